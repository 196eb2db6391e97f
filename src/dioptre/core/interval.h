// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace dioptre {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A closed range of real numbers; empty when min > max. The default is empty.
struct Interval {
  double min = kInfinity, max = -kInfinity;

  static constexpr Interval all() { return {-kInfinity, kInfinity}; }
  constexpr bool empty() const { return !(min <= max); }
  constexpr bool contains(double v) const { return min <= v && v <= max; }
  /// True strictly inside: a ray's range excludes its ends.
  constexpr bool surrounds(double v) const { return min < v && v < max; }
  bool operator==(const Interval&) const = default;
};

/// The next number above a positive, finite one.
constexpr double just_above(double v) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) + 1);
}

constexpr Interval intersect(Interval a, Interval b) {
  return {std::max(a.min, b.min), std::min(a.max, b.max)};
}
constexpr Interval unite(Interval a, Interval b) {
  return {std::min(a.min, b.min), std::max(a.max, b.max)};
}

}  // namespace dioptre
