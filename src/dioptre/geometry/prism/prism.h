// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/outline/outline_spline.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A closed outline in the x-z plane swept along y: straight (linear sweep) or from the origin
/// (conic sweep: the outline is that at y = 1 and shrinks to a point at y = 0; below 0 it is
/// mirrored at the origin). The heights may come in any order.
///
/// Each entry of `outlines` holds the control points of one closed sub-outline exactly as a scene
/// file lists them, its own c (and d) included, with the repeated closing point (pn = p1, or the
/// last Bezier end) or without it: then a straight line closes it. A point is inside where an odd
/// number of sub-outlines is around it.
struct Prism {
  static constexpr const char* kName = "prism";
  OutlineSpline spline = OutlineSpline::kLinear;
  bool conic = false;
  double height1 = 0;
  double height2 = 1;
  std::vector<std::vector<Vec2>> outlines;  ///< control points (x, z), as the spline kind says
  bool open = false;                        ///< the caps bound the solid but are not drawn
  bool sturm = false;                       ///< kept for scene files; all roots are always found

  bool operator==(const Prism&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("spline", self.spline);
    visit("conic", self.conic);
    visit("height1", self.height1);
    visit("height2", self.height2);
    visit("outlines", self.outlines);
    visit("open", self.open);
    visit("sturm", self.sturm);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for too few
/// points, or a number that is not finite.
Result<ShapePtr> prepare(const Prism& prism);

}  // namespace dioptre
