// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/geometry/lathe/lathe.h"
#include "dioptre/geometry/outline/outline.h"

namespace dioptre {

/// A piece of a lathe's outline in units of the lathe's scale. Where one piece ends the next one
/// begins, or a loop does; all loops are closed, the axis counting as closed.
struct LatheCurve {
  Curve curve;
  bool visible = true;            ///< false for a piece that only closes a loop
  Interval radius, height;        ///< what the piece lies in; the radius is |x|
  double v_begin = 0, v_end = 0;  ///< the second surface coordinate at its ends
};

struct LatheCurves {
  std::vector<LatheCurve> curves;
  double scale = 1;  ///< the largest coordinate
};

/// The curves that a lathe's control points stand for, with those that close them.
Result<LatheCurves> lathe_curves(const Lathe& lathe);

}  // namespace dioptre
