// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dioptre/core/color.h"

namespace dioptre {

/// A rendered picture in the scene's own values, rows from top to bottom. `alpha` is 1 where the
/// pixel is opaque; colours are not multiplied by it.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<Color> pixels;
  std::vector<float> alpha;  ///< empty: opaque everywhere

  Image() = default;
  Image(std::uint32_t w, std::uint32_t h) : width(w), height(h), pixels(std::size_t{w} * h) {}
  Color& at(std::uint32_t x, std::uint32_t y) { return pixels[std::size_t{y} * width + x]; }
  const Color& at(std::uint32_t x, std::uint32_t y) const {
    return pixels[std::size_t{y} * width + x];
  }
};

/// What is told of each pixel beside its colour, rows from top to bottom.
struct ImageLayer {
  std::string name;
  std::string channels;  ///< a letter for each value of a pixel: "RGB" is light, "Z" a distance
  std::vector<float> values;  ///< those of one pixel stand together
};

/// A picture as the integers that a file holds, rows from top to bottom.
struct EncodedImage {
  std::uint32_t width = 0, height = 0;
  std::uint32_t channels = 3;  ///< 1: grey, 2: grey and alpha, 3: RGB, 4: RGBA
  std::uint32_t bits = 8;      ///< 1 to 16: values are 0 to 2^bits - 1
  double gamma = 0;            ///< of the encoding; 0: the sRGB curve
  bool gamma_known = true;     ///< false: values are the scene's own, the file says no gamma
  std::vector<std::uint16_t> values;
};

}  // namespace dioptre
