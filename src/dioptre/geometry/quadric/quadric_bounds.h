// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/bounds.h"
#include "dioptre/geometry/quadric/quadric.h"

namespace dioptre {

/// A box that holds the quadric's inside. It is finite for ellipsoids; if the axes of the quadric
/// lie along x, y and z, also in those directions in which cylinders and paraboloids end; infinite
/// elsewhere.
Bounds quadric_bounds(const Quadric& quadric);

/// A box that holds the part of the quadric's inside that lies in `region`; tight in the directions
/// that the rest of the equation bounds there, if the axes of the quadric lie along x, y and z.
Bounds quadric_bounds_within(const Quadric& quadric, const Bounds& region);

}  // namespace dioptre
