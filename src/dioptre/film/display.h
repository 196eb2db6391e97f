// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/film/image.h"
#include "dioptre/scene/settings.h"

namespace dioptre {

/// How the values of a rendered picture become those of a file.
struct DisplayOptions {
  double file_gamma = 0;   ///< the file's values are light^(1/file_gamma); 0: the sRGB curve
  std::uint32_t bits = 8;  ///< per channel, 1 to 16
  bool alpha = false;      ///< write the alpha channel too, colours not multiplied by it
  bool dither = false;     ///< Floyd-Steinberg error diffusion
};

/// The sRGB curve (IEC 61966-2-1): light in [0, 1] to the value of a file, and back.
double srgb_encode(double light);
double srgb_decode(double value);

/// The linear light of a value of the scene: value^assumed_gamma, or by the sRGB curve; negative
/// values give 0.
float to_linear(float value, const Settings& settings);

/// The whole picture in linear light, for files that hold that. Alpha stays as it is.
Image to_linear(const Image& image, const Settings& settings);

/// The picture as the integers of a file: linear light clipped to [0, 1], encoded, rounded half up.
/// Without gamma correction the scene's values go to the file as they are.
EncodedImage encode(const Image& image, const Settings& settings, const DisplayOptions& options);

}  // namespace dioptre
