// SPDX-License-Identifier: Apache-2.0
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <vector>

#include "dioptre/codecs/codecs.h"

namespace dioptre::codecs {
namespace {

/// A TIFF file in memory, for libtiff's callbacks.
struct TiffInput {
  std::string_view bytes;
  std::uint64_t at = 0;
};

tmsize_t read_some(thandle_t handle, void* out, tmsize_t size) {
  auto* in = static_cast<TiffInput*>(handle);
  // As a file does, this gives nothing beyond its end: libtiff does not expect an error here.
  if (size < 0 || in->at > in->bytes.size()) return 0;
  const std::uint64_t count =
      std::min<std::uint64_t>(static_cast<std::uint64_t>(size), in->bytes.size() - in->at);
  std::memcpy(out, in->bytes.data() + in->at, count);
  in->at += count;
  return static_cast<tmsize_t>(count);
}
tmsize_t no_write(thandle_t, void*, tmsize_t) { return -1; }
toff_t seek(thandle_t handle, toff_t offset, int origin) {
  auto* in = static_cast<TiffInput*>(handle);
  if (origin == SEEK_CUR) offset += in->at;
  if (origin == SEEK_END) offset += in->bytes.size();
  return in->at = offset;
}
int no_close(thandle_t) { return 0; }
toff_t size_of(thandle_t handle) { return static_cast<TiffInput*>(handle)->bytes.size(); }

/// Rows of the plain layout (8 or 16 bit grey or RGB, samples together), as exact values.
bool read_rows(TIFF* tiff, ImageData& data, std::uint32_t bits) {
  std::vector<std::uint8_t> row(static_cast<std::size_t>(TIFFScanlineSize(tiff)));
  const std::size_t values = std::size_t{data.width} * data.channels;
  if (row.size() < values * bits / 8) return false;
  for (std::uint32_t y = 0; y < data.height; ++y) {
    if (TIFFReadScanline(tiff, row.data(), y, 0) < 0) return false;
    for (std::size_t k = 0; k < values; ++k) {
      std::uint16_t wide = 0;
      if (bits == 16) std::memcpy(&wide, row.data() + 2 * k, 2);
      data.pixels.push_back(bits == 16 ? static_cast<float>(wide) / 65535.0f
                                       : static_cast<float>(row[k]) / 255.0f);
    }
  }
  return true;
}

/// Every other layout, through libtiff's own conversion to 8-bit RGBA.
bool read_converted(TIFF* tiff, ImageData& data) {
  data.channels = 4;
  std::vector<std::uint32_t> raster(std::size_t{data.width} * data.height);
  if (TIFFReadRGBAImageOriented(tiff, data.width, data.height, raster.data(), ORIENTATION_TOPLEFT,
                                1) == 0) {
    return false;
  }
  for (const std::uint32_t p : raster) {
    for (const std::uint32_t value : {TIFFGetR(p), TIFFGetG(p), TIFFGetB(p), TIFFGetA(p)}) {
      data.pixels.push_back(static_cast<float>(value) / 255.0f);
    }
  }
  return true;
}

/// Whether libtiff may be trusted to convert the layout: with odd numbers of samples it writes
/// beyond its buffers.
bool is_convertible(TIFF* tiff) {
  std::uint16_t samples = 1, depth = 1, photometric = 0;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &depth);
  if (TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric) == 0) return false;
  const bool known_depth = depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
  switch (photometric) {
    case PHOTOMETRIC_MINISWHITE:
    case PHOTOMETRIC_MINISBLACK:
      return known_depth && samples <= 2;
    case PHOTOMETRIC_PALETTE:
      return known_depth && samples == 1;
    case PHOTOMETRIC_RGB:
      return (depth == 8 || depth == 16) && (samples == 3 || samples == 4);
    case PHOTOMETRIC_YCBCR:
      return depth == 8 && samples == 3;
    default:
      return false;
  }
}

bool is_plain(TIFF* tiff, std::uint32_t& channels, std::uint32_t& bits) {
  std::uint16_t samples = 1, depth = 1, layout = 0, photometric = 0, orientation = 1, extra = 0;
  std::uint16_t format = SAMPLEFORMAT_UINT;
  std::uint16_t* extra_kinds = nullptr;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &depth);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &layout);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &orientation);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &format);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &extra, &extra_kinds);
  if (TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric) == 0) return false;
  const bool grey = photometric == PHOTOMETRIC_MINISBLACK && samples == 1;
  const bool color = photometric == PHOTOMETRIC_RGB && samples == 3;
  channels = samples;
  bits = depth;
  return (grey || color) && (depth == 8 || depth == 16) && layout == PLANARCONFIG_CONTIG &&
         orientation == ORIENTATION_TOPLEFT && format == SAMPLEFORMAT_UINT &&
         TIFFIsTiled(tiff) == 0 && extra == 0;
}

Result<DecodedImage> decode(TIFF* tiff, const TiffInput& in, std::uint64_t max_pixels) {
  DecodedImage image;
  image.curve = DecodedImage::Curve::kAsStored;
  ImageData& data = image.data;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &data.width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &data.height);
  if (const auto size = check_image_size(data.width, data.height, max_pixels); !size) {
    return tl::unexpected(size.error());
  }
  const std::uint64_t pixels = std::uint64_t{data.width} * data.height;
  if (pixels / 2000 > in.bytes.size()) return fail("the file is too short for its header");
  std::uint32_t bits = 8;
  const bool plain = is_plain(tiff, data.channels, bits);
  if (!plain && !is_convertible(tiff)) return fail("its layout of samples is not read");
  data.pixels.reserve(pixels * (plain ? data.channels : 4));
  if (!(plain ? read_rows(tiff, data, bits) : read_converted(tiff, data))) {
    return fail("the pixels are cut or damaged (at byte " + std::to_string(in.at) + ")");
  }
  return image;
}

}  // namespace

Result<DecodedImage> decode_tiff(std::string_view bytes, std::uint64_t max_pixels) {
  // The handlers are process-wide in libtiff 4.5; messages would go to the standard error.
  static const bool silenced = [] {
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    return true;
  }();
  static_cast<void>(silenced);
  TiffInput in{bytes};
  TIFF* tiff = TIFFClientOpen("memory", "rm", &in, read_some, no_write, seek, no_close, size_of,
                              nullptr, nullptr);
  if (tiff == nullptr) return fail("the TIFF header or directory is damaged");
  Result<DecodedImage> image = decode(tiff, in, max_pixels);
  TIFFClose(tiff);
  return image;
}

}  // namespace dioptre::codecs
