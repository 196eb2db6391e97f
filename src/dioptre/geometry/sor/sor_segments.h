// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/geometry/outline/bernstein.h"
#include "dioptre/geometry/sor/sor.h"

namespace dioptre {

/// A stretch of the height, low < high, with the squared radius as a polynomial on it. One segment
/// begins where the last one ended, with the same radius.
struct SorSegment {
  double low = 0, high = 1;
  Bernstein<3> squared_radius{};
  double most = 0;  ///< its largest value

  /// Where a height lies in the stretch: 0 at its low end, 1 at the high one, at most.
  double place_of(double height) const;
  /// The squared radius at s in [0, 1] of the stretch.
  double at(double s) const;
  /// Its derivative by the height.
  double slope(double s) const;
  /// The same polynomial on the part from a to b of the stretch, a and b in [0, 1].
  Bernstein<3> part(double a, double b) const;
};

struct SorSegments {
  std::vector<SorSegment> segments;  ///< in units of the scale
  double scale = 1;                  ///< the largest coordinate
  double reach = 1;                  ///< the largest radius, in units of the scale
};

Result<SorSegments> sor_segments(const Sor& sor);

}  // namespace dioptre
