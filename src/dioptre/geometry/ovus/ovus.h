// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/geometry/shape.h"

namespace dioptre {

/// An egg about the y axis: a sphere around the origin, one around the bottom sphere's top, and
/// between them a lemon, whose side is an arc that touches both. The arc's radius is twice the
/// larger of the two. A top radius of more than twice the bottom one leaves the top sphere alone.
struct Ovus {
  static constexpr const char* kName = "ovus";
  double bottom_radius = 1;
  double top_radius = 0.5;

  bool operator==(const Ovus&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("bottom_radius", self.bottom_radius);
    visit("top_radius", self.top_radius);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for a radius
/// that is not a number, or for none above 0.
Result<ShapePtr> prepare(const Ovus& ovus);

}  // namespace dioptre
