// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "dioptre/core/bounds.h"
#include "dioptre/csg/placed_leaf.h"

namespace dioptre::csg {

/// A box around what half-spaces have in common, if that is finite on all sides; else all of space.
///
/// By the duality of linear programs, the greatest x there is the least sum of w_i * distance_i
/// over the weights w_i >= 0 with sum w_i * normal_i = (1, 0, 0), and three weights suffice. Where
/// there are many half-spaces, the first few of them count.
Bounds polytope_bounds(std::span<const PlacedHalfSpace> half_spaces);

}  // namespace dioptre::csg
