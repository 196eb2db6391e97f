// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace dioptre {

/// A value from 0 to 1 as a colour, 8 bits of sRGB each: from dark violet over green to yellow,
/// where equal steps of the value look alike, also in grey and to the colour-blind. What lies
/// outside counts as the nearer end, what is not a number as 0.
///
/// The map is viridis (S. van der Walt and N. Smith, "A Better Default Colormap for Matplotlib",
/// 2015), by the polynomial of M. Zucker, "matplotlib colormaps", Shadertoy WlfXRN, 2019; both are
/// in the public domain (CC0).
std::array<std::uint8_t, 3> viridis(double value);

}  // namespace dioptre
