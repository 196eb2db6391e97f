// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A ring about the y axis; if the minor radius is the larger, the spindle is filled.
struct Torus {
  static constexpr const char* kName = "torus";
  double major_radius = 1;     ///< from the axis to the centre of the tube
  double minor_radius = 0.25;  ///< of the tube

  bool operator==(const Torus&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("major_radius", self.major_radius);
    visit("minor_radius", self.minor_radius);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Torus& torus);

}  // namespace dioptre
