// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/scene/pattern.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre {

/// Cells around one random point in each unit cube (S. Worley, "A Cellular Texture Basis
/// Function", 1996): the distances to the nearest three points, weighted by `form`; or, if solid,
/// the noise at the nearest point, one value per cell.
double crackle_value(Vec3 p, const Crackle& crackle, NoiseGenerator generator);

}  // namespace dioptre
