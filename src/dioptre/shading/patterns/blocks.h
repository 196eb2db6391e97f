// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/scene/pattern.h"

namespace dioptre {

/// Unit cubes in two kinds, by the parity of the sum of their corners.
double checker_block(Vec3 p);
/// 0 in the mortar, 1 in a brick. Mortar lies at the far end of each cell; every odd row is moved
/// by half a brick along x, every even one along z.
double brick_block(Vec3 p, const Brick& brick);
/// The number of the cube's face that the point sees from the origin: x, y, z, -x, -y, -z.
double cubic_block(Vec3 p);
/// Hexagons with sides of length 1 in the x-z plane, in three kinds, the first around the origin.
double hexagon_block(Vec3 p);
/// Unit squares in the x-z plane in four kinds.
double square_block(Vec3 p);
/// Triangles with sides of length 1 in the x-z plane in six kinds.
double triangular_block(Vec3 p);

}  // namespace dioptre
