// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/outline/outline_spline.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A curve in the half-plane of distance from the y axis and height, revolved about the y axis.
///
/// A curve that does not end where it began is a surface that bounds a solid only together with
/// invisible faces: flat ones from its two ends towards the axis, and a cylinder as wide as the
/// curve's least distance from the axis. A point is inside where an odd number of curves is
/// farther out.
struct Lathe {
  static constexpr const char* kName = "lathe";
  OutlineSpline spline = OutlineSpline::kLinear;
  std::vector<Vec2> points;  ///< control points (distance from the axis, y); the distance >= 0
  bool sturm = false;        ///< kept for scene files; all roots are always found

  bool operator==(const Lathe&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("spline", self.spline);
    visit("points", self.points);
    visit("sturm", self.sturm);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for too few
/// points, a negative distance from the axis, or a number that is not finite.
Result<ShapePtr> prepare(const Lathe& lathe);

}  // namespace dioptre
