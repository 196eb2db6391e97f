// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// All points within `radius` of `center`.
struct Sphere {
  static constexpr const char* kName = "sphere";
  Vec3 center;
  double radius = 1;  ///< not negative

  bool operator==(const Sphere&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("center", self.center);
    visit("radius", self.radius);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Sphere& sphere);

}  // namespace dioptre
