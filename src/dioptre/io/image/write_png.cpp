// SPDX-License-Identifier: Apache-2.0
#include <png.h>

#include <csetjmp>
#include <new>

#include "dioptre/io/image/write_image.h"

namespace dioptre {

Result<std::string> png_bytes(const EncodedImage& image);

namespace {

/// What libpng's callbacks are handed.
struct PngOutput {
  std::string bytes;
};

/// An exception must not pass through C code.
void append(png_structp png, png_bytep data, png_size_t size) {
  bool good = true;
  try {
    auto* out = static_cast<PngOutput*>(png_get_io_ptr(png));
    out->bytes.append(reinterpret_cast<const char*>(data), size);
  } catch (const std::bad_alloc&) {
    good = false;
  }
  if (!good) png_error(png, "out of memory");
}
void ignore_flush(png_structp) {}
void ignore_warning(png_structp, png_const_charp) {}

int color_type(std::uint32_t channels) {
  switch (channels) {
    case 1:
      return PNG_COLOR_TYPE_GRAY;
    case 2:
      return PNG_COLOR_TYPE_GRAY_ALPHA;
    case 3:
      return PNG_COLOR_TYPE_RGB;
    default:
      return PNG_COLOR_TYPE_RGBA;
  }
}

/// The rows of the file: 8 bits, or 16 with the high byte first. Other depths are scaled up.
std::vector<std::uint8_t> file_rows(const EncodedImage& image, std::uint32_t depth) {
  const std::uint32_t top = (1u << image.bits) - 1, file_top = (1u << depth) - 1;
  std::vector<std::uint8_t> rows;
  rows.reserve(image.values.size() * depth / 8);
  for (const std::uint16_t value : image.values) {
    const auto scaled = static_cast<std::uint32_t>(
        top == file_top ? value : (std::uint64_t{value} * file_top + top / 2) / top);
    if (depth == 16) rows.push_back(static_cast<std::uint8_t>(scaled >> 8));
    rows.push_back(static_cast<std::uint8_t>(scaled & 255));
  }
  return rows;
}

/// Says how the values are to be read: the sRGB curve or a power.
void write_gamma(png_structp png, png_infop info, const EncodedImage& image) {
  if (!image.gamma_known) return;
  if (image.gamma > 0) {
    png_set_gAMA(png, info, 1 / image.gamma);
  } else {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  }
}

bool write_png(const EncodedImage& image, std::uint32_t depth, std::vector<png_bytep>& rows,
               PngOutput& out) {
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, ignore_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
  png_set_write_fn(png, &out, append, ignore_flush);
  png_set_IHDR(png, info, image.width, image.height, static_cast<int>(depth),
               color_type(image.channels), PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  write_gamma(png, info, image);
  png_write_info(png, info);
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

}  // namespace

/// The bytes of a PNG file.
Result<std::string> png_bytes(const EncodedImage& image) {
  const std::uint32_t depth = image.bits > 8 ? 16 : 8;
  std::vector<std::uint8_t> data = file_rows(image, depth);
  const std::size_t row = std::size_t{image.width} * image.channels * depth / 8;
  std::vector<png_bytep> rows(image.height);
  for (std::uint32_t y = 0; y < image.height; ++y) rows[y] = data.data() + y * row;
  PngOutput out;
  if (!write_png(image, depth, rows, out)) return fail("PNG compression failed");
  return std::move(out.bytes);
}

}  // namespace dioptre
