// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/display.h"

#include <algorithm>
#include <cmath>

#include "dioptre/film/transfer_curve.h"

namespace dioptre {
namespace {

/// What is not a number counts as 0.
double clip(double v) { return v > 0 ? std::min(v, 1.0) : 0.0; }

double encode_value(float value, const Settings& settings, const DisplayOptions& options) {
  if (!settings.gamma_correction) return clip(value);
  const double light = clip(to_linear(value, settings));
  return options.file_gamma > 0 ? std::pow(light, 1 / options.file_gamma) : srgb_encode(light);
}

/// Rounds the values of one channel row by row and hands each rounding error on to the neighbours
/// that follow (Floyd and Steinberg 1976, "An adaptive algorithm for spatial grayscale").
class Diffuser {
 public:
  Diffuser(std::uint32_t width, double top) : top_(top), here_(width + 2), below_(width + 2) {}

  void next_row() {
    here_.swap(below_);
    std::fill(below_.begin(), below_.end(), 0.0);
  }
  std::uint16_t operator()(std::uint32_t x, double value) {
    const double wanted = value * top_ + here_[x + 1];
    const double level = std::clamp(std::floor(wanted + 0.5), 0.0, top_);
    spread(x, wanted - level);
    return static_cast<std::uint16_t>(level);
  }

 private:
  void spread(std::uint32_t x, double error) {
    here_[x + 2] += error * 7 / 16;
    below_[x] += error * 3 / 16;
    below_[x + 1] += error * 5 / 16;
    below_[x + 2] += error / 16;
  }
  double top_;
  std::vector<double> here_, below_;
};

/// Fills the values of `out` row by row: value(v, x, channel) for the colours.
template <class RowStart, class Value>
void fill(EncodedImage& out, const Image& image, RowStart&& row_start, Value&& value) {
  const double top = (1u << out.bits) - 1;
  out.values.resize(image.pixels.size() * out.channels);
  std::uint16_t* next = out.values.data();
  for (std::uint32_t y = 0; y < image.height; ++y) {
    row_start();
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const std::size_t at = std::size_t{y} * image.width + x;
      const Color c = image.pixels[at];
      *next++ = value(c.r, x, 0);
      *next++ = value(c.g, x, 1);
      *next++ = value(c.b, x, 2);
      if (out.channels < 4) continue;
      const double alpha = image.alpha.empty() ? 1.0 : clip(image.alpha[at]);
      *next++ = static_cast<std::uint16_t>(std::floor(alpha * top + 0.5));
    }
  }
}

}  // namespace

double srgb_encode(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

double srgb_decode(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

float to_linear(float value, const Settings& settings) {
  if (!(value > 0)) return 0;
  if (!settings.gamma_correction || settings.assumed_gamma == 1) return value;
  if (settings.assumed_gamma == 0) return static_cast<float>(srgb_decode(value));
  return static_cast<float>(std::pow(double{value}, settings.assumed_gamma));
}

Image to_linear(const Image& image, const Settings& settings) {
  Image linear = image;
  for (Color& c : linear.pixels) {
    c = {to_linear(c.r, settings), to_linear(c.g, settings), to_linear(c.b, settings)};
  }
  return linear;
}

EncodedImage encode(const Image& image, const Settings& settings, const DisplayOptions& options) {
  EncodedImage out;
  out.width = image.width;
  out.height = image.height;
  out.channels = options.alpha ? 4 : 3;
  out.bits = std::clamp<std::uint32_t>(options.bits, 1, 16);
  out.gamma = options.file_gamma;
  out.gamma_known = settings.gamma_correction;
  const double top = (1u << out.bits) - 1;
  const auto exact = [&](float v) { return encode_value(v, settings, options); };
  if (options.dither) {
    std::vector<Diffuser> channels(3, Diffuser(image.width, top));
    const auto next_row = [&] {
      for (Diffuser& d : channels) d.next_row();
    };
    fill(out, image, next_row,
         [&](float v, std::uint32_t x, int k) { return channels[k](x, exact(v)); });
  } else {
    const TransferCurve curve(exact, top);
    fill(
        out, image, [] {}, [&](float v, std::uint32_t, int) { return curve.level(v); });
  }
  return out;
}

}  // namespace dioptre
