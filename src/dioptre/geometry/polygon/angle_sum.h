// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/vec.h"

namespace dioptre {

/// Whether p is inside an odd number of outlines, by the angle that each of them turns through as
/// seen from p: 2 pi if it is around p, 0 if not. An inverse tangent for each edge; the test by
/// crossings (Outline::contains_even_odd) gives the same for all points but those on an edge.
bool inside_by_angles(const std::vector<std::vector<Vec2>>& outlines, Vec2 p);

}  // namespace dioptre
