// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/result.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The box or sphere within which a surface that is given by functions is looked for.
struct Container {
  bool sphere = false;
  Vec3 corner1{-1, -1, -1}, corner2{1, 1, 1};  ///< of the box
  Vec3 center;                                 ///< of the sphere
  double radius = 1;

  bool operator==(const Container&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("sphere", self.sphere);
    visit("corner1", self.corner1);
    visit("corner2", self.corner2);
    visit("center", self.center);
    visit("radius", self.radius);
  }
};

/// The container as a solid; an error where a box or sphere with these parameters would be one.
Result<ShapePtr> prepare(const Container& container);

}  // namespace dioptre
