// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A flat triangle: a sheet, whose normal is along cross(c - a, b - a). With normals it is shaded
/// smoothly. Corners on one line make an empty shape.
struct Triangle {
  static constexpr const char* kName = "triangle";
  Vec3 a;
  Vec3 b{1, 0, 0};
  Vec3 c{0, 1, 0};
  std::vector<Vec3> normals;  ///< none, or one per corner (of any length)

  bool operator==(const Triangle&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("a", self.a);
    visit("b", self.b);
    visit("c", self.c);
    visit("normals", self.normals);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for
/// corners that are not finite, or a number of normals other than 0 and 3.
Result<ShapePtr> prepare(const Triangle& triangle);

}  // namespace dioptre
