// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A right circular cone or frustum; a radius of 0 is an apex.
struct Cone {
  static constexpr const char* kName = "cone";
  Vec3 base;
  double base_radius = 1;
  Vec3 cap{0, 1, 0};
  double cap_radius = 0;
  bool open = false;  ///< without end discs: they bound the solid, but are not drawn

  bool operator==(const Cone&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("base", self.base);
    visit("base_radius", self.base_radius);
    visit("cap", self.cap);
    visit("cap_radius", self.cap_radius);
    visit("open", self.open);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Cone& cone);

}  // namespace dioptre
