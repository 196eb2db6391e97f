// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "dioptre/film/image.h"

namespace dioptre {

/// The distance from one letter to the next and the height of a letter, in dots.
inline constexpr std::uint32_t kLetterPitch = 6, kLetterHeight = 7;

/// How many dots wide a text is.
inline std::uint32_t text_width(std::string_view text) {
  return static_cast<std::uint32_t>(text.size()) * kLetterPitch - (text.empty() ? 0 : 1);
}

/// Writes a text into a picture of 8 bits, its first letter's corner at a pixel, in white and in
/// dots of `scale` pixels. There are capital letters (others become such), digits and . , + - > ;
/// what else there is, is blank. What lies outside of the picture is left out.
void draw_text(EncodedImage& image, std::uint32_t x, std::uint32_t y, std::uint32_t scale,
               std::string_view text);

}  // namespace dioptre
