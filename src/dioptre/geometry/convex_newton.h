// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "dioptre/geometry/quadratic.h"

namespace dioptre {

/// Moves s from outside a convex solid towards `end` on to its surface; false if the line misses
/// the solid. `excess(s, value, slope)` is a convex function of s, positive outside, in units of
/// the solid's size: Newton's iteration then comes to the root without passing it.
template <class Excess>
bool approach_convex(Excess&& excess, double& s, double end) {
  const bool forth = s < end;
  for (int i = 0; i < 100; ++i) {
    double value = 0, slope = 0;
    excess(s, value, slope);
    if (value <= kRounding) return true;
    if (forth ? !(slope < 0) : !(slope > 0)) return false;
    const double next = s - value / slope;
    if (forth ? !(next < end) : !(next > end)) return false;
    if (std::fabs(next - s) <= 4 * kRounding) return true;
    s = next;
  }
  return true;
}

}  // namespace dioptre
