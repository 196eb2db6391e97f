// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "dioptre/core/result.h"
#include "dioptre/scene/image_source.h"

namespace dioptre {

/// What a decoder found: values as the file has them (integers scaled to 0..1), and what the file
/// says about their meaning.
struct DecodedImage {
  enum class Curve { kUnknown, kSrgb, kLinear, kPower, kAsStored, kIndices };
  ImageData data;
  Curve curve = Curve::kUnknown;  ///< kUnknown: the file says nothing; kAsStored: its values
                                  ///< are the scene's, whatever their gamma; kIndices: no light
  double gamma = 1;               ///< of kPower: light is value^gamma
  bool grey_bytes = false;        ///< a PNG of grey bytes
};

/// Refuses sizes of 0 or above the limit, before anything is allocated.
inline Result<void> check_image_size(std::uint64_t width, std::uint64_t height,
                                     std::uint64_t max_pixels) {
  if (width == 0 || height == 0) return fail("the header says that it has no pixels");
  if (width > max_pixels || height > max_pixels / width) {
    return fail("the header says " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels, more than the limit of " + std::to_string(max_pixels));
  }
  return {};
}

/// The decoders. Each takes the bytes of a whole file of its format, and gives the reason of a
/// failure without the name of the file.
Result<DecodedImage> decode_png(std::string_view bytes, std::uint64_t max_pixels);
/// As decode_png, but an image with a palette gives the numbers of its entries, one channel.
Result<DecodedImage> decode_png_indices(std::string_view bytes, std::uint64_t max_pixels);
Result<DecodedImage> decode_jpeg(std::string_view bytes, std::uint64_t max_pixels);
Result<DecodedImage> decode_tiff(std::string_view bytes, std::uint64_t max_pixels);
Result<DecodedImage> decode_pnm(std::string_view bytes, std::uint64_t max_pixels);
Result<DecodedImage> decode_exr(std::string_view bytes, std::uint64_t max_pixels);
Result<DecodedImage> decode_hdr(std::string_view bytes, std::uint64_t max_pixels);
/// GIF, TGA and BMP.
Result<DecodedImage> decode_simple(std::string_view bytes, std::uint64_t max_pixels);
/// As decode_simple, but an image with a palette gives the numbers of its entries, one channel.
Result<DecodedImage> decode_simple_indices(std::string_view bytes, std::uint64_t max_pixels);

}  // namespace dioptre
