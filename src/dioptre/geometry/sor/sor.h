// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A surface of revolution about the y axis: the square of the radius is a function of the height,
/// on each segment a cubic polynomial through two points. Its slope at a point is 2 r dr/dh, where
/// dr/dh is that of the line through the point's neighbours. The first and the last point only give
/// slopes.
struct Sor {
  static constexpr const char* kName = "sor";
  std::vector<Vec2> points;  ///< (radius, height), at least 4; the heights in between rise
  bool open = false;         ///< the end discs bound the solid but are not drawn
  bool sturm = false;        ///< kept for scene files; all roots are always found

  bool operator==(const Sor&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("points", self.points);
    visit("open", self.open);
    visit("sturm", self.sturm);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for too few
/// points, a negative radius, heights that do not rise, or a number that is not finite.
Result<ShapePtr> prepare(const Sor& sor);

}  // namespace dioptre
