// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "dioptre/io/image/codec_module.h"
#include "dioptre/io/image/write_image.h"

namespace dioptre {
namespace {

/// Shared-exponent form (Ward 1991, "Real pixels").
void put_rgbe(std::string& out, Color c) {
  const auto part = [](float v) { return v > 0 && std::isfinite(v) ? std::min(v, 1e37f) : 0.0f; };
  const float r = part(c.r), g = part(c.g), b = part(c.b), top = std::max({r, g, b});
  if (top < 1e-32f) return static_cast<void>(out.append(4, '\0'));
  int exponent = 0;
  const float scale = std::frexp(top, &exponent) * 256 / top;
  for (const float v : {r, g, b}) out.push_back(static_cast<char>(static_cast<int>(v * scale)));
  out.push_back(static_cast<char>(exponent + 128));
}

}  // namespace

Result<void> write_exr(const std::string& path, const Image& linear, bool half,
                       std::span<const ImageLayer> layers) {
  if (linear.pixels.empty()) return fail("the image has no pixels");
  for (const ImageLayer& layer : layers) {
    if (layer.values.size() == linear.pixels.size() * layer.channels.size()) continue;
    return fail("the layer " + layer.name + " has another size than the image");
  }
  const Result<const CodecModule*> codecs = load_codecs();
  if (!codecs) return fail("cannot write " + path + ": " + codecs.error().message);
  const Result<std::string> bytes = (*codecs)->encode_exr(linear, layers, half);
  if (!bytes) return fail("cannot write " + path + ": " + bytes.error().message);
  return write_file(path, *bytes);
}

Result<void> write_hdr(const std::string& path, const Image& linear) {
  if (linear.pixels.empty()) return fail("the image has no pixels");
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(linear.height) +
                      " +X " + std::to_string(linear.width) + "\n";
  bytes.reserve(bytes.size() + linear.pixels.size() * 4);
  for (const Color c : linear.pixels) put_rgbe(bytes, c);
  return write_file(path, bytes);
}

}  // namespace dioptre
