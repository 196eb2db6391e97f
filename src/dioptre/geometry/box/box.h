// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The axis-aligned box between two opposite corners, given in any order.
struct Box {
  static constexpr const char* kName = "box";
  Vec3 corner1;
  Vec3 corner2{1, 1, 1};

  bool operator==(const Box&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("corner1", self.corner1);
    visit("corner2", self.corner2);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Box& box);

}  // namespace dioptre
