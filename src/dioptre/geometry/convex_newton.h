// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/quadratic.h"

namespace dioptre {

/// Moves s from outside a convex solid towards `end` on to its surface; false if the line misses
/// the solid. `excess(s, value, slope)` is a convex function of s, positive outside, in units of
/// the solid's size: Newton's iteration then comes to the root without passing it. `slope` becomes
/// that of the function there.
template <class Excess>
bool approach_convex(Excess&& excess, double& s, double end, double& slope) {
  const bool forth = s < end;
  double last = 0;
  for (int i = 0; i < 100; ++i) {
    double value = 0;
    excess(s, value, slope);
    if (value <= kRounding) return true;
    if (forth ? !(slope < 0) : !(slope > 0)) return false;
    const double next = s - value / slope;
    if (forth ? !(next < end) : !(next > end)) return false;
    const double step = std::fabs(next - s);
    s = next;
    // Steps shrink with their squares: the next one would be about step^3 / last^2.
    if (step * step * step <= 0.1 * kRounding * last * last || step <= 4 * kRounding) return true;
    last = step;
  }
  return true;
}

/// Does the first steps of approach_convex with an `excess` that is right to six digits, as long as
/// it is surely outside; false if the line surely misses the solid.
template <class Excess>
bool come_near_convex(Excess&& excess, double& s, double end) {
  constexpr double kNear = 3e-5, kSure = 3e-6;
  const bool forth = s < end;
  double before = s;
  for (int i = 0; i < 30; ++i) {
    double value = 0, slope = 0;
    excess(s, value, slope);
    if (!(value > kSure)) {
      s = before;  // a rough step may have gone too far
      return true;
    }
    if (value < kNear) return true;
    // The slope only grows along a convex function: what is missed here is missed by far.
    if (forth ? !(slope < 0) : !(slope > 0)) return false;
    const double next = s - value / slope;
    if (forth ? !(next < end + kSure) : !(next > end - kSure)) return false;
    before = s;
    s = forth ? std::min(next, end) : std::max(next, end);
  }
  return true;
}

}  // namespace dioptre
