// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A flat disc, with an optional hole: a sheet that also divides space like its plane.
struct Disc {
  static constexpr const char* kName = "disc";
  Vec3 center;
  Vec3 normal{0, 1, 0};  ///< any length but 0
  double radius = 1;
  double hole_radius = 0;

  bool operator==(const Disc&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("center", self.center);
    visit("normal", self.normal);
    visit("radius", self.radius);
    visit("hole_radius", self.hole_radius);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Disc& disc);

}  // namespace dioptre
