// SPDX-License-Identifier: Apache-2.0
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#include "dioptre/io/image/decoders.h"

namespace dioptre {
namespace {

struct PngInput {
  std::string_view bytes;
  std::size_t at = 0;
  char problem[160] = {};
};

void read_some(png_structp png, png_bytep out, png_size_t size) {
  auto* in = static_cast<PngInput*>(png_get_io_ptr(png));
  if (size > in->bytes.size() - in->at) {
    in->at = in->bytes.size();
    png_error(png, "the file ends too early");
  }
  std::memcpy(out, in->bytes.data() + in->at, size);
  in->at += size;
}

[[noreturn]] void failed(png_structp png, png_const_charp message) {
  auto* in = static_cast<PngInput*>(png_get_error_ptr(png));
  std::strncpy(in->problem, message, sizeof in->problem - 1);
  png_longjmp(png, 1);
}
void ignore_warning(png_structp, png_const_charp) {}

/// Reads the header and asks for grey or RGB with 8 or 16 bits, alpha from transparency; if wanted,
/// for the numbers of a palette's entries as bytes.
bool read_header(png_structp png, png_infop info, bool indices) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
  png_read_info(png, info);
  if (indices && png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE) {
    png_set_packing(png);
  } else {
    png_set_expand(png);
  }
  return true;
}

bool read_rows(png_structp png, png_infop info, std::vector<std::uint8_t>& data,
               std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (data.size() < png_get_rowbytes(png, info) * rows.size()) return false;
  png_read_image(png, rows.data());
  png_read_end(png, info);
  return true;
}

void read_curve(png_structp png, png_infop info, DecodedImage& image) {
  int intent = 0;
  double file_gamma = 0;
  if (png_get_sRGB(png, info, &intent) != 0) {
    image.curve = DecodedImage::Curve::kSrgb;
  } else if (png_get_gAMA(png, info, &file_gamma) != 0 && file_gamma > 0) {
    image.curve = DecodedImage::Curve::kPower;
    image.gamma = 1 / file_gamma;
  }
}

/// The number of channels after expansion.
std::uint32_t channels_of(png_structp png, png_infop info) {
  const int type = png_get_color_type(png, info);
  const bool color = (type & PNG_COLOR_MASK_COLOR) != 0;
  const bool alpha =
      (type & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  return (color ? 3u : 1u) + (alpha ? 1u : 0u);
}

Result<DecodedImage> decode(png_structp png, png_infop info, PngInput& in, std::uint64_t max_pixels,
                            bool indices) {
  const auto problem = [&] {
    return fail(std::string(in.problem) + " (at byte " + std::to_string(in.at) + ")");
  };
  if (!read_header(png, info, indices)) return problem();
  DecodedImage image;
  ImageData& data = image.data;
  data.width = png_get_image_width(png, info);
  data.height = png_get_image_height(png, info);
  if (const auto size = check_image_size(data.width, data.height, max_pixels); !size) {
    return tl::unexpected(size.error());
  }
  if (indices && png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE) {
    image.curve = DecodedImage::Curve::kIndices;
    data.channels = 1;
  } else {
    read_curve(png, info, image);
    data.channels = channels_of(png, info);
  }
  const std::uint32_t bytes = png_get_bit_depth(png, info) == 16 ? 2 : 1;
  image.grey_bytes =
      bytes == 1 && data.channels == 1 && image.curve != DecodedImage::Curve::kIndices;
  const std::size_t row = std::size_t{data.width} * data.channels * bytes;
  // Deflate packs at most about 1032 to 1: a file too small for its header is refused at once.
  const std::size_t bits_per_row =
      std::size_t{data.width} * png_get_bit_depth(png, info) * png_get_channels(png, info);
  if (bits_per_row / 8 * data.height / 1100 > in.bytes.size()) {
    return fail("the file is too short for " + std::to_string(data.width) + " x " +
                std::to_string(data.height) + " pixels");
  }
  std::vector<std::uint8_t> raw(row * data.height);
  std::vector<png_bytep> rows(data.height);
  for (std::uint32_t y = 0; y < data.height; ++y) rows[y] = raw.data() + y * row;
  if (!read_rows(png, info, raw, rows)) return problem();
  const float top = image.curve == DecodedImage::Curve::kIndices ? 1.0f : 255.0f;
  data.pixels.resize(std::size_t{data.width} * data.height * data.channels);
  for (std::size_t k = 0; k < data.pixels.size(); ++k) {
    data.pixels[k] = bytes == 1 ? static_cast<float>(raw[k]) / top
                                : static_cast<float>(raw[2 * k] * 256 + raw[2 * k + 1]) / 65535.0f;
  }
  return image;
}

Result<DecodedImage> decode(std::string_view bytes, std::uint64_t max_pixels, bool indices) {
  PngInput in{bytes};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &in, failed, ignore_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  Result<DecodedImage> image = fail("out of memory");
  if (info != nullptr) {
    png_set_read_fn(png, &in, read_some);
    image = decode(png, info, in, max_pixels, indices);
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return image;
}

}  // namespace

Result<DecodedImage> decode_png(std::string_view bytes, std::uint64_t max_pixels) {
  return decode(bytes, max_pixels, false);
}

Result<DecodedImage> decode_png_indices(std::string_view bytes, std::uint64_t max_pixels) {
  return decode(bytes, max_pixels, true);
}

}  // namespace dioptre
