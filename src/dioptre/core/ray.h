// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"

namespace dioptre {

/// A half-line. World-space rays have a unit direction, so that t is a distance; a ray carried into
/// an object's space keeps its t and its direction is then of any length.
struct Ray {
  Vec3 origin, direction;
  constexpr Vec3 at(double t) const { return origin + t * direction; }
};

}  // namespace dioptre
