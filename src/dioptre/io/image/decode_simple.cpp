// SPDX-License-Identifier: Apache-2.0
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_GIF
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS (1 << 24)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <climits>
#include <cmath>
#include <memory>

#include "dioptre/io/image/decoders.h"
#include "dioptre/io/image/palette_numbers.h"

namespace dioptre {
namespace {

std::uint32_t little(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t k = count; k-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  }
  return value;
}

std::uint64_t least_bmp_size(std::string_view bytes, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kOldHeaders = 26, kHeaders = 34;
  if (bytes.size() < kOldHeaders) return kOldHeaders;
  const bool old = little(bytes, 14, 4) == 12;
  if (!old && bytes.size() < kHeaders) return kHeaders;
  const std::uint32_t offset = little(bytes, 10, 4), bits = little(bytes, old ? 24 : 28, 2);
  const std::uint32_t compression = old ? 0 : little(bytes, 30, 4);
  if (compression != 0 && compression != 3) return 0;
  return offset + (width * bits + 31) / 32 * 4 * (height - 1) + width * bits / 8;
}

/// The decoder takes missing data for zeros, so that a cut file would pass: the least size that the
/// header allows is checked here. 0 if unknown.
std::uint64_t least_size(std::string_view bytes, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kTgaHeader = 18;
  if (bytes.starts_with("GIF")) return 0;
  if (bytes.starts_with("BM")) return least_bmp_size(bytes, width, height);
  if (bytes.size() < kTgaHeader) return kTgaHeader;
  const auto kind = static_cast<unsigned char>(bytes[2]);
  const std::uint64_t pixel = (static_cast<unsigned char>(bytes[16]) + 7u) / 8;
  const std::uint64_t header = kTgaHeader + std::uint64_t{static_cast<unsigned char>(bytes[0])};
  if (kind >= 9) return header + width * height / 128 * (pixel + 1);  // runs of up to 128
  return header + width * height * pixel;
}

/// Leaves out an alpha channel that is 1 everywhere.
void drop_opaque_alpha(ImageData& data) {
  if (data.channels % 2 != 0) return;
  const std::uint32_t shades = data.channels - 1;
  for (std::size_t k = shades; k < data.pixels.size(); k += data.channels) {
    if (data.pixels[k] != 1) return;
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < data.pixels.size(); ++k) {
    if (k % data.channels != shades) data.pixels[kept++] = data.pixels[k];
  }
  data.pixels.resize(kept);
  data.channels = shades;
}

struct Free {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

namespace {

/// Decodes what a GIF, TGA or BMP shows; a clear colour is black.
Result<DecodedImage> decode_shown(std::string_view bytes, std::uint64_t max_pixels) {
  if (bytes.size() > INT_MAX) return fail("the file is larger than 2 GiB");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  const auto reason = [] {
    const char* text = stbi_failure_reason();
    return fail(std::string("it is damaged: ") + (text != nullptr ? text : "unknown"));
  };
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) return reason();
  const auto w = static_cast<std::uint64_t>(std::max(width, 0));
  const auto h = static_cast<std::uint64_t>(std::max(height, 0));
  if (const auto fits = check_image_size(w, h, max_pixels); !fits) {
    return tl::unexpected(fits.error());
  }
  if (least_size(bytes, w, h) > bytes.size()) {
    return fail("the file ends too early (at byte " + std::to_string(bytes.size()) + ")");
  }
  const std::unique_ptr<stbi_uc, Free> pixels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 0));
  if (pixels == nullptr) return reason();
  DecodedImage image;
  image.data.width = static_cast<std::uint32_t>(width);
  image.data.height = static_cast<std::uint32_t>(height);
  image.data.channels = static_cast<std::uint32_t>(channels);
  image.data.pixels.resize(std::size_t{image.data.width} * image.data.height * image.data.channels);
  for (std::size_t k = 0; k < image.data.pixels.size(); ++k) {
    image.data.pixels[k] = static_cast<float>(pixels.get()[k]) / 255.0f;
  }
  drop_opaque_alpha(image.data);
  return image;
}

}  // namespace

/// A GIF's clear colour stays what it is (measured: it shows where it is interpolated or given
/// another transparency).
Result<DecodedImage> decode_simple(std::string_view bytes, std::uint64_t max_pixels) {
  Result<DecodedImage> image = decode_shown(bytes, max_pixels);
  if (!image || image->data.channels != 4 || !bytes.starts_with("GIF8")) return image;
  const Result<DecodedImage> opaque =
      decode_shown(with_opaque_entries(std::string(bytes)), max_pixels);
  if (!opaque || opaque->data.channels != 3) return image;
  const std::size_t count = image->data.pixels.size() / 4;
  if (opaque->data.pixels.size() != 3 * count) return image;
  for (std::size_t k = 0; k < count; ++k) {
    std::copy_n(&opaque->data.pixels[3 * k], 3, &image->data.pixels[4 * k]);
  }
  return image;
}

Result<DecodedImage> decode_simple_indices(std::string_view bytes, std::uint64_t max_pixels) {
  const std::optional<std::string> numbered = with_palette_of_numbers(bytes);
  Result<DecodedImage> image = decode_simple(numbered ? *numbered : bytes, max_pixels);
  if (!image || !numbered) return image;
  ImageData& data = image->data;
  const std::size_t count = data.pixels.size() / data.channels;
  for (std::size_t k = 0; k < count; ++k) {
    data.pixels[k] = std::round(data.pixels[k * data.channels] * 255.0f);
  }
  data.pixels.resize(count);
  data.channels = 1;
  image->curve = DecodedImage::Curve::kIndices;
  return image;
}

}  // namespace dioptre
