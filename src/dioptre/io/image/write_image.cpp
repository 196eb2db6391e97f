// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/image/write_image.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

// jpeglib.h needs stdio's types first.
#include <jpeglib.h>

#include <csetjmp>
#include <cstdlib>

namespace dioptre {

Result<std::string> png_bytes(const EncodedImage& image);

namespace {

std::uint8_t to_8_bits(std::uint16_t value, std::uint32_t bits) {
  if (bits == 8) return static_cast<std::uint8_t>(value);
  const std::uint32_t top = (1u << bits) - 1;
  return static_cast<std::uint8_t>((value * 255u + top / 2) / top);
}

/// Red, green and blue of pixel number `at`, 8 bits, and alpha.
struct Pixel8 {
  std::uint8_t r, g, b, a;
};
Pixel8 pixel_8(const EncodedImage& image, std::size_t at) {
  const std::uint16_t* v = &image.values[at * image.channels];
  const auto value = [&](std::uint32_t channel) { return to_8_bits(v[channel], image.bits); };
  const bool grey = image.channels < 3;
  const bool alpha = image.channels % 2 == 0;
  return {value(0), value(grey ? 0 : 1), value(grey ? 0 : 2),
          alpha ? value(image.channels - 1) : std::uint8_t{255}};
}

void put_16(std::string& out, std::uint32_t value) {  // little-endian
  out.push_back(static_cast<char>(value & 255));
  out.push_back(static_cast<char>(value >> 8 & 255));
}
void put_32(std::string& out, std::uint32_t value) {
  put_16(out, value & 0xffff);
  put_16(out, value >> 16);
}

std::string ppm_bytes(const EncodedImage& image) {
  const std::uint32_t top = (1u << image.bits) - 1;
  std::string out = "P6\n" + std::to_string(image.width) + " " + std::to_string(image.height) +
                    "\n" + std::to_string(top) + "\n";
  const std::size_t pixels = std::size_t{image.width} * image.height;
  const bool wide = image.bits > 8;
  std::size_t end = out.size();
  out.resize(end + pixels * (wide ? 6 : 3));
  const bool grey = image.channels < 3;
  for (std::size_t at = 0; at < pixels; ++at) {
    for (std::uint32_t channel = 0; channel < 3; ++channel) {
      const std::uint16_t value = image.values[at * image.channels + (grey ? 0 : channel)];
      if (wide) out[end++] = static_cast<char>(value >> 8);
      out[end++] = static_cast<char>(value & 255);
    }
  }
  return out;
}

Result<std::string> tga_bytes(const EncodedImage& image) {
  if (image.width > 65535 || image.height > 65535) return fail("a TGA file is at most 65535 wide");
  const bool alpha = image.channels % 2 == 0;
  std::string out(12, '\0');
  out[2] = 2;  // uncompressed true colour
  put_16(out, image.width);
  put_16(out, image.height);
  out.push_back(alpha ? 32 : 24);
  out.push_back(static_cast<char>(0x20 | (alpha ? 8 : 0)));  // first row at the top
  const std::size_t pixels = std::size_t{image.width} * image.height;
  for (std::size_t at = 0; at < pixels; ++at) {
    const Pixel8 p = pixel_8(image, at);
    for (const std::uint8_t byte : {p.b, p.g, p.r}) out.push_back(static_cast<char>(byte));
    if (alpha) out.push_back(static_cast<char>(p.a));
  }
  return out;
}

Result<std::string> bmp_bytes(const EncodedImage& image) {
  const bool alpha = image.channels % 2 == 0;
  const std::uint64_t row = (std::uint64_t{image.width} * (alpha ? 32 : 24) + 31) / 32 * 4;
  const std::uint64_t size = 54 + row * image.height;
  if (size > 0x7fffffff) return fail("the image is too large for a BMP file");
  std::string out = "BM";
  put_32(out, static_cast<std::uint32_t>(size));
  put_32(out, 0);
  put_32(out, 54);
  put_32(out, 40);
  put_32(out, image.width);
  put_32(out, image.height);
  put_16(out, 1);
  put_16(out, alpha ? 32 : 24);
  put_32(out, 0);
  put_32(out, static_cast<std::uint32_t>(row * image.height));
  for (const std::uint32_t field : {2835u, 2835u, 0u, 0u}) put_32(out, field);
  for (std::uint32_t y = image.height; y-- > 0;) {
    const std::size_t start = out.size();
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const Pixel8 p = pixel_8(image, std::size_t{y} * image.width + x);
      for (const std::uint8_t byte : {p.b, p.g, p.r}) out.push_back(static_cast<char>(byte));
      if (alpha) out.push_back(static_cast<char>(p.a));
    }
    out.resize(start + row, '\0');
  }
  return out;
}

/// libjpeg's error handling: it must not return, so it jumps back to the caller.
struct JpegErrors {
  jpeg_error_mgr base;
  std::jmp_buf back;
};
[[noreturn]] void jpeg_failed(j_common_ptr info) {
  std::longjmp(reinterpret_cast<JpegErrors*>(info->err)->back, 1);
}

/// `rows` holds 3 bytes per pixel. Returns false on failure. No object with a destructor lives here
/// across the jump.
bool compress_jpeg(const std::uint8_t* rows, std::uint32_t width, std::uint32_t height, int quality,
                   unsigned char** buffer, unsigned long* size) {
  jpeg_compress_struct info;
  JpegErrors errors;
  info.err = jpeg_std_error(&errors.base);
  errors.base.error_exit = jpeg_failed;
  if (setjmp(errors.back) != 0) {
    jpeg_destroy_compress(&info);
    return false;
  }
  jpeg_create_compress(&info);
  jpeg_mem_dest(&info, buffer, size);
  info.image_width = width;
  info.image_height = height;
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = 1;
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < height) {
    auto* row = const_cast<JSAMPROW>(rows + std::size_t{info.next_scanline} * width * 3);
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  return true;
}

Result<std::string> jpeg_bytes(const EncodedImage& image, int quality) {
  if (image.width > 65500 || image.height > 65500) return fail("a JPEG file is at most 65500 wide");
  std::vector<std::uint8_t> rows;
  const std::size_t pixels = std::size_t{image.width} * image.height;
  rows.reserve(pixels * 3);
  for (std::size_t at = 0; at < pixels; ++at) {
    const Pixel8 p = pixel_8(image, at);
    rows.insert(rows.end(), {p.r, p.g, p.b});
  }
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  const bool good = compress_jpeg(rows.data(), image.width, image.height,
                                  std::clamp(quality, 2, 100), &buffer, &size);
  std::string out;
  if (good) out.assign(reinterpret_cast<const char*>(buffer), size);
  std::free(buffer);
  if (!good) return fail("JPEG compression failed");
  return out;
}

}  // namespace

Result<std::string> image_bytes(const EncodedImage& image, ImageFormat format,
                                const WriteImageOptions& options) {
  if (image.width == 0 || image.height == 0) return fail("the image has no pixels");
  switch (format) {
    case ImageFormat::kPng:
      return png_bytes(image);
    case ImageFormat::kPpm:
      return ppm_bytes(image);
    case ImageFormat::kJpeg:
      return jpeg_bytes(image, options.jpeg_quality);
    case ImageFormat::kTga:
      return tga_bytes(image);
    case ImageFormat::kBmp:
      return bmp_bytes(image);
  }
  return fail("unknown image format");
}

Result<void> write_image(const std::string& path, const EncodedImage& image, ImageFormat format,
                         const WriteImageOptions& options) {
  const Result<std::string> bytes = image_bytes(image, format, options);
  if (!bytes) return tl::unexpected(bytes.error());
  return write_file(path, *bytes);
}

}  // namespace dioptre
