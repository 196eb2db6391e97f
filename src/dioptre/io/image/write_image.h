// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/film/image.h"

namespace dioptre {

/// Writes a file whole or not at all: a temporary file in the same folder is filled, flushed to the
/// disk and renamed. On failure nothing new remains and what was there before is untouched. "-" is
/// the standard output.
Result<void> write_file(const std::string& path, std::string_view bytes);

/// The formats that hold integers.
enum class ImageFormat { kPng, kPpm, kJpeg, kTga, kBmp };

struct WriteImageOptions {
  int jpeg_quality = 85;
};

/// The bytes of an image file. PNG takes 8 or 16 bits (others are scaled up) with alpha, PPM any
/// depth up to 16, the others 8 bits; PPM and JPEG drop alpha.
Result<std::string> image_bytes(const EncodedImage& image, ImageFormat format,
                                const WriteImageOptions& options = {});

/// Writes an image file, as write_file does.
Result<void> write_image(const std::string& path, const EncodedImage& image, ImageFormat format,
                         const WriteImageOptions& options = {});

/// Writes linear light as OpenEXR: R, G, B and, if the picture has it, A (colours multiplied by
/// alpha, as the format wants), 32-bit floats or halves, ZIP compressed. The channels of layers
/// follow, each called LAYER.CHANNEL, in 32-bit floats always; light in them (channels "RGB") is
/// multiplied by alpha too.
Result<void> write_exr(const std::string& path, const Image& linear, bool half,
                       std::span<const ImageLayer> layers = {});

/// Writes linear light as Radiance RGBE (.hdr).
Result<void> write_hdr(const std::string& path, const Image& linear);

}  // namespace dioptre
