// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/interval_math.h"

namespace dioptre {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Beyond this the place within a period is lost.
constexpr double kLargestAngle = 0x1p40;

/// Whether some phase + 2 pi k lies in a, or closer than rounding can tell.
bool meets(Interval a, double phase) {
  const double slack = 1e-14 * (1 + magnitude(a));
  const double first = std::ceil((a.min - slack - phase) / (2 * kPi));
  return phase + 2 * kPi * first <= a.max + slack;
}

/// sin and cos, whose maximum is at `top`.
template <class Function>
Interval wave(Interval a, double top, Function f) {
  if (!(magnitude(a) < kLargestAngle) || a.max - a.min >= 2 * kPi) return {-1, 1};
  const double p = f(a.min), q = f(a.max);
  const Interval ends = widen({std::min(p, q), std::max(p, q)}, kLibraryRoundings);
  return {meets(a, top + kPi) ? -1 : ends.min, meets(a, top) ? 1 : ends.max};
}

}  // namespace

Interval sin(Interval a) {
  return wave(a, kPi / 2, [](double v) { return std::sin(v); });
}

Interval cos(Interval a) {
  return wave(a, 0, [](double v) { return std::cos(v); });
}

Interval power(Interval a, int n) {
  if (n == 0) return {1, 1};
  if (n == 1) return a;
  if (n == 2) return square(a);
  if (n < 0) return Interval{1, 1} / power(a, -n);
  const double p = std::pow(a.min, n), q = std::pow(a.max, n);
  if (n % 2 != 0 || a.min >= 0) return widen({p, q}, kLibraryRoundings);
  if (a.max <= 0) return widen({q, p}, kLibraryRoundings);
  return widen({0, std::max(p, q)}, kLibraryRoundings);
}

Interval pow(Interval x, Interval y) {
  constexpr double kLargestWhole = 1024;
  if (is_point(y) && y.min == std::floor(y.min) && std::fabs(y.min) <= kLargestWhole) {
    return power(x, static_cast<int>(y.min));
  }
  if (!(x.min > 0 || (x.min == 0 && y.min > 0))) return Interval::all();
  // Increasing or decreasing in each: the extremes are at corners.
  const double p = std::pow(x.min, y.min), q = std::pow(x.min, y.max);
  const double r = std::pow(x.max, y.min), s = std::pow(x.max, y.max);
  return widen({std::min({p, q, r, s}), std::max({p, q, r, s})}, kLibraryRoundings);
}

Interval atan2(Interval y, Interval x) {
  const bool meets_cut = x.min <= 0 && y.min <= 0 && y.max >= 0;
  if (meets_cut || std::isnan(x.min + x.max) || std::isnan(y.min + y.max)) {
    return {-just_above(kPi), just_above(kPi)};
  }
  // Seen from the origin a box has its extremes at corners.
  const double p = std::atan2(y.min, x.min), q = std::atan2(y.min, x.max);
  const double r = std::atan2(y.max, x.min), s = std::atan2(y.max, x.max);
  return widen({std::min({p, q, r, s}), std::max({p, q, r, s})}, kLibraryRoundings);
}

}  // namespace dioptre
