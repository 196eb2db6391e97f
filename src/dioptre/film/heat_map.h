// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "dioptre/film/image.h"

namespace dioptre {

/// The height of the legend below a heat map of this width, in pixels, and the least width that
/// has room for it.
std::uint32_t legend_height(std::uint32_t width);
inline constexpr std::uint32_t kLegendWidth = 240;

/// A layer of one value per pixel as a picture in the colours of viridis(), with a legend below
/// that says what the colours stand for; `unit` follows the layer's name there. A narrow picture
/// stands at the left of what the legend needs.
///
/// The scale runs evenly from 0, or for distances (channel "Z") in equal ratios from the least of
/// them, to what one pixel in 200 exceeds; those all have the last colour, and the legend says how
/// far they go. Pixels without a finite value are dark.
EncodedImage heat_map(const ImageLayer& layer, std::uint32_t width, std::uint32_t height,
                      std::string_view unit);

}  // namespace dioptre
