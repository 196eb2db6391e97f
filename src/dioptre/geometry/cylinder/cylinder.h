// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A right circular cylinder between the centres of its two end discs.
struct Cylinder {
  static constexpr const char* kName = "cylinder";
  Vec3 base;
  Vec3 cap{0, 1, 0};
  double radius = 1;
  bool open = false;  ///< without end discs: they bound the solid, but are not drawn

  bool operator==(const Cylinder&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("base", self.base);
    visit("cap", self.cap);
    visit("radius", self.radius);
    visit("open", self.open);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Cylinder& cylinder);

}  // namespace dioptre
