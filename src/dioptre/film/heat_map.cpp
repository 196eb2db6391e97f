// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/heat_map.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "dioptre/film/color_map.h"
#include "dioptre/film/lettering.h"

namespace dioptre {
namespace {

constexpr std::uint16_t kDark = 24;

/// The parts of the legend from top to bottom, in dots.
constexpr std::uint32_t kMargin = 6, kTitleTop = 6, kBarTop = 17, kBarBottom = 27,
                        kTicksBottom = 30;
constexpr std::uint32_t kNumbersTop = 32, kLegendBottom = 45;

/// Pixels per dot of the legend.
std::uint32_t legend_scale(std::uint32_t width) { return std::clamp(width / 480, 1u, 8u); }

/// Which values have the first and the last colour, and the largest of all.
struct Scale {
  double low = 0, high = 1, largest = 0;
  bool logarithmic = false;  ///< low is above 0

  double share(double value) const {
    return logarithmic ? std::log(value / low) / std::log(high / low)
                       : (value - low) / (high - low);
  }
  double value(double share) const {
    return logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
  }
};

Scale scale_of(const ImageLayer& layer) {
  std::vector<float> finite;
  finite.reserve(layer.values.size());
  std::copy_if(layer.values.begin(), layer.values.end(), std::back_inserter(finite),
               [](float v) { return std::isfinite(v); });
  Scale scale;
  if (finite.empty()) return scale;
  const auto most = finite.begin() + static_cast<std::ptrdiff_t>((finite.size() - 1) * 199 / 200);
  std::nth_element(finite.begin(), most, finite.end());
  scale.high = *most;
  scale.largest = *std::max_element(most, finite.end());
  if (!(scale.high > 0)) scale.high = scale.largest > 0 ? scale.largest : 1;
  if (layer.channels == "Z") {
    scale.logarithmic = true;
    const double least = *std::min_element(finite.begin(), most + 1);
    scale.low = std::clamp(least, 1e-4 * scale.high, 0.9 * scale.high);
  }
  return scale;
}

/// Four digits; from 10000 on with K for thousands, M for millions and so on.
std::string number(double value) {
  std::string prefix;
  for (const char next : {'K', 'M', 'G', 'T'}) {
    if (!(value >= (prefix.empty() ? 9999.5 : 999.95))) break;
    value /= 1000;
    prefix = next;
  }
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
  return std::string(text.data(), end.ptr) + prefix;
}

class Drawing {
 public:
  Drawing(const ImageLayer& layer, std::uint32_t width, std::uint32_t height)
      : layer_(layer), scale_(scale_of(layer)), columns_(width), rows_(height) {
    image_.width = std::max(width, kLegendWidth);
    image_.height = height + legend_height(width);
    image_.values.assign(std::size_t{image_.width} * image_.height * 3, kDark);
    dot_ = legend_scale(image_.width);
  }

  EncodedImage draw(std::string_view unit) {
    for (std::uint32_t y = 0; y < rows_; ++y) {
      for (std::uint32_t x = 0; x < columns_; ++x) {
        const float value = layer_.values[std::size_t{y} * columns_ + x];
        if (std::isfinite(value)) put(x, y, scale_.share(value));
      }
    }
    std::string title = layer_.name + " " + std::string(unit);
    if (scale_.largest > scale_.high) title += ", up to " + number(scale_.largest);
    draw_text(image_, kMargin * dot_, rows_ + kTitleTop * dot_, dot_, title);
    draw_bar();
    return std::move(image_);
  }

 private:
  void put(std::uint32_t x, std::uint32_t y, double share) {
    const auto color = viridis(share);
    std::copy(color.begin(), color.end(),
              image_.values.begin() +
                  static_cast<std::ptrdiff_t>((std::size_t{y} * image_.width + x) * 3));
  }

  /// The colours from the first to the last, and numbers for some of them.
  void draw_bar() {
    const std::uint32_t first = kMargin * dot_, length = image_.width - 2 * first;
    for (std::uint32_t y = kBarTop * dot_; y < kBarBottom * dot_; ++y) {
      for (std::uint32_t i = 0; i < length; ++i) put(first + i, rows_ + y, i / (length - 1.0));
    }
    constexpr std::uint32_t kParts = 4;
    for (std::uint32_t part = 0; part <= kParts; ++part) {
      const double share = double{part} / kParts;
      const auto at = static_cast<std::uint32_t>(first + share * (length - 1));
      for (std::uint32_t y = kBarBottom * dot_; y < kTicksBottom * dot_; ++y) {
        put(at, rows_ + y, share);
      }
      const bool more = part == kParts && scale_.largest > scale_.high;
      const std::string text = (more ? ">" : "") + number(scale_.value(share));
      const double left = at - share * text_width(text) * dot_;
      draw_text(image_, static_cast<std::uint32_t>(left), rows_ + kNumbersTop * dot_, dot_, text);
    }
  }

  const ImageLayer& layer_;
  Scale scale_;
  std::uint32_t columns_, rows_, dot_ = 1;
  EncodedImage image_;
};

}  // namespace

std::uint32_t legend_height(std::uint32_t width) {
  return kLegendBottom * legend_scale(std::max(width, kLegendWidth));
}

EncodedImage heat_map(const ImageLayer& layer, std::uint32_t width, std::uint32_t height,
                      std::string_view unit) {
  return Drawing(layer, width, height).draw(unit);
}

}  // namespace dioptre
