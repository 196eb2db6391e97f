// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/color.h"
#include "dioptre/scene/interior.h"

namespace dioptre {

/// The place in the spectrum of light that dispersion has not split.
inline constexpr float kWhiteLight = -1;

/// Whether an interior bends light of different colours differently.
inline bool disperses(const Interior& interior) {
  return interior.has_ior && interior.dispersion != 1;
}

/// The index of refraction for light at a place in the spectrum, 0 the red end, 1 the violet one:
/// ior dispersion^(position - 1/2) (measured, to 1e-4).
double ior_of_color(const Interior& interior, double position);

/// What colour number `index` has of white light when it splits into `colors` equal stretches of
/// the spectrum (at least 1), the first being red; each is sent to the middle of its stretch.
Color color_share(std::uint32_t index, std::uint32_t colors);

}  // namespace dioptre
