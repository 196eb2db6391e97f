// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace dioptre {

/// The place in (low, high) where a function that changes its sign once there does so. `evaluate(t,
/// value, slope)` sets both; `rises` says that the function is negative at low. Newton steps from
/// `start`, halving where a step leaves the bracket. Ends when a step is a rounding of t, or when
/// the steps no longer shrink because the value itself is but rounding.
template <class Evaluate>
double bracketed_newton(Evaluate&& evaluate, double low, double high, double start, bool rises) {
  constexpr double kNoise = 1e-9;  // steps as small as this shrink or are rounding
  double t = start > low && start < high ? start : 0.5 * (low + high);
  double last = high - low;
  for (int i = 0; i < 100; ++i) {
    double value, slope;
    evaluate(t, value, slope);
    ((value >= 0) == rises ? high : low) = t;
    double next = t - value / slope;
    const double size = std::fabs(t);
    if (std::fabs(next - t) <= 0x1p-52 * size) return t;
    const bool inside = next > low && next < high;
    if (!inside) next = 0.5 * (low + high);
    const double step = std::fabs(next - t);
    if (step <= 0x1p-52 * size || (inside && step < kNoise * size && step >= last)) return next;
    last = step;
    t = next;
  }
  return t;
}

/// The same by Halley's method (E. Halley, "Methodus nova accurata et facilis inveniendi radices
/// aequationum quarumcumque generaliter", 1694), for functions with a cheap second derivative:
/// `evaluate(t, value, slope, bend)` sets half of it, too. Ends one step earlier, where the next
/// step of Newton's method would be a rounding of t.
template <class Evaluate>
double bracketed_halley(Evaluate&& evaluate, double low, double high, double start, bool rises) {
  constexpr double kNoise = 1e-9;
  double t = start > low && start < high ? start : 0.5 * (low + high);
  double last = high - low;
  for (int i = 0; i < 100; ++i) {
    double value, slope, bend;
    evaluate(t, value, slope, bend);
    ((value >= 0) == rises ? high : low) = t;
    double next = t - value * slope / (slope * slope - value * bend);
    const double size = std::fabs(t);
    if (std::fabs(next - t) <= 0x1p-52 * size) return t;
    const bool inside = next > low && next < high;
    if (!inside) next = 0.5 * (low + high);
    const double step = std::fabs(next - t);
    if (step <= 0x1p-52 * size) return next;
    if (inside) {
      if (std::fabs(bend) * step * step <= 0x1p-54 * size * std::fabs(slope)) return next;
      if (step < kNoise * size && step >= last) return next;
    }
    last = step;
    t = next;
  }
  return t;
}

}  // namespace dioptre
