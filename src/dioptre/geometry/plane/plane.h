// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The half-space of the points p with dot(p, normal)/|normal| <= distance.
struct Plane {
  static constexpr const char* kName = "plane";
  Vec3 normal{0, 1, 0};  ///< points out of the half-space; any length but 0
  double distance = 0;   ///< of the plane from the origin, along the unit normal

  bool operator==(const Plane&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("normal", self.normal);
    visit("distance", self.distance);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Plane& plane);

}  // namespace dioptre
