// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/color.h"
#include "dioptre/scene/interior.h"

namespace dioptre {

/// The share of light left after `distance` (in world units) inside an interior, by its fade_*
/// values: 1 / (1 + (d/fade_distance)^fade_power), tinted by the fade colour; exponential for
/// powers of 1000 and more. White if fade_distance is 0; a power of 0 leaves one half (measured).
Color attenuation(const Interior& interior, double distance);

}  // namespace dioptre
