// SPDX-License-Identifier: Apache-2.0
// Interval arithmetic (R. E. Moore, "Interval Analysis", 1966). A result holds the result of every
// choice of numbers from the operands; its ends are rounded outwards. Where a function has no value
// for some of the numbers the result is everything.
#pragma once

#include <algorithm>
#include <cmath>

#include "dioptre/core/interval.h"

namespace dioptre {

/// An interval of one number; everything for what is not a number, so that no end ever is.
constexpr Interval interval_of(double v) { return v == v ? Interval{v, v} : Interval::all(); }
constexpr bool is_point(Interval a) { return a.min == a.max; }
/// True if an end is infinite.
constexpr bool is_unbounded(Interval a) { return !(a.min > -kInfinity && a.max < kInfinity); }
/// The largest absolute value.
constexpr double magnitude(Interval a) { return std::max(std::fabs(a.min), std::fabs(a.max)); }

/// Both ends moved outwards by `roundings` units of rounding. 0 stays 0, so that what is nowhere
/// negative remains so. Everything, if an end is not a number.
inline Interval widen(Interval a, double roundings = 1) {
  const double share = roundings * 0x1p-52;
  const Interval wide{a.min - std::fabs(a.min) * share, a.max + std::fabs(a.max) * share};
  return wide.min <= wide.max ? wide : Interval::all();
}

inline Interval operator-(Interval a) { return {-a.max, -a.min}; }
inline Interval operator+(Interval a, Interval b) { return widen({a.min + b.min, a.max + b.max}); }
inline Interval operator-(Interval a, Interval b) { return widen({a.min - b.max, a.max - b.min}); }

/// With 0 times anything as 0.
inline Interval operator*(Interval a, Interval b) {
  const auto times = [](double x, double y) { return x == 0 || y == 0 ? 0 : x * y; };
  const double p = times(a.min, b.min), q = times(a.min, b.max);
  const double r = times(a.max, b.min), s = times(a.max, b.max);
  return widen(
      {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))});
}

inline Interval operator/(Interval a, Interval b) {
  if (!(b.min > 0 || b.max < 0)) return Interval::all();
  return a * widen({1 / b.max, 1 / b.min});
}

inline Interval square(Interval a) {
  const double low = a.min * a.min, high = a.max * a.max;
  if (a.min >= 0) return widen({low, high});
  if (a.max <= 0) return widen({high, low});
  return widen({0, std::max(low, high)});
}

inline Interval abs(Interval a) {
  if (a.min >= 0) return a;
  if (a.max <= 0) return -a;
  return {0, std::max(-a.min, a.max)};
}

inline Interval sqrt(Interval a) {
  if (!(a.min >= 0)) return Interval::all();
  return widen({std::sqrt(a.min), std::sqrt(a.max)});
}

/// The library's functions are right to within two units of rounding.
inline constexpr double kLibraryRoundings = 2;

/// The image under a function that nowhere decreases, computed by the library.
template <class Function>
Interval increasing(Interval a, Function f) {
  return widen({f(a.min), f(a.max)}, kLibraryRoundings);
}

Interval sin(Interval a);
Interval cos(Interval a);
/// a^n for a whole number n.
Interval power(Interval a, int n);
/// x^y, for y of any kind where no x is negative, and else for a whole number y.
Interval pow(Interval x, Interval y);
/// The angle of the vectors (x, y), from -pi to pi.
Interval atan2(Interval y, Interval x);

}  // namespace dioptre
