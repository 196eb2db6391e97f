// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// How the control points of an outline make a curve (as in a scene file).
enum class PrismSpline : std::uint8_t { kLinear, kQuadratic, kCubic, kBezier };

/// A closed outline in the x-z plane swept along y: straight (linear sweep) or from the origin
/// (conic sweep: the outline is that at y = 1 and shrinks to a point at y = 0).
struct Prism {
  static constexpr const char* kName = "prism";
  PrismSpline spline = PrismSpline::kLinear;
  bool conic = false;
  double height1 = 0;
  double height2 = 1;
  std::vector<std::vector<Vec2>>
      outlines;  ///< control points (x, z), as the spline kind wants them
  bool open = false;
  bool sturm = false;

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

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Prism& prism);

}  // namespace dioptre
