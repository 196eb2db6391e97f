// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace dioptre {

/// A typed index into one of the scene's vectors; the default refers to nothing.
template <class T>
struct Id {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t index = kNone;

  constexpr explicit operator bool() const { return index != kNone; }
  bool operator==(const Id&) const = default;
  auto operator<=>(const Id&) const = default;
};

/// Appends a value and returns its id.
template <class T>
Id<T> append(std::vector<T>& values, T value) {
  values.push_back(std::move(value));
  return {static_cast<std::uint32_t>(values.size() - 1)};
}
template <class T>
const T& at(const std::vector<T>& values, Id<T> id) {
  return values[id.index];
}

}  // namespace dioptre
