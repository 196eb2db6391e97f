// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "dioptre/geometry/polygon/polygon.h"

namespace dioptre {

/// Cuts a polygon into triangles, every three points one, in its own space: between the heights of
/// its corners, and of the crossings of its sides, it consists of trapezoids. Nothing for a polygon
/// of more sides than are worth it, which grows with their square.
std::optional<std::vector<Vec3>> cut_into_triangles(const Polygon& polygon);

}  // namespace dioptre
