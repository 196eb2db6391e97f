// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dioptre/core/shared.h"

namespace dioptre {

/// Decoded pixels: rows from top to bottom, 1 to 5 channels (grey, grey+alpha, RGB, RGBA,
/// RGBA+filter), in linear light or in the scene's own values.
struct ImageData {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 3;
  std::vector<float> pixels;
  bool operator==(const ImageData&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("width", self.width);
    visit("height", self.height);
    visit("channels", self.channels);
    visit("pixels", self.pixels);
  }
};

/// An image read from a file and how it is laid on surfaces.
struct ImageSource {
  enum class Mapping : std::uint8_t {
    kPlanar = 0,
    kSpherical = 1,
    kCylindrical = 2,
    kToroidal = 5
  };
  enum class Interpolation : std::uint8_t {
    kNone = 0,
    kBilinear = 2,
    kBicubic = 3,
    kNormalizedDistance = 4
  };
  std::string path;
  Shared<ImageData> data;
  Mapping mapping = Mapping::kPlanar;
  bool once = false;  ///< outside the unit square: nothing
  Interpolation interpolation = Interpolation::kNone;
  double filter_all = 0;    ///< beside the filter channel
  double transmit_all = 0;  ///< beside what alpha lets through
  bool use_color = true;    ///< for bump maps and patterns: the colour, not the index
  bool use_alpha = false;
  bool operator==(const ImageSource&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("path", self.path);
    visit("data", self.data);
    visit("mapping", self.mapping);
    visit("once", self.once);
    visit("interpolation", self.interpolation);
    visit("filter_all", self.filter_all);
    visit("transmit_all", self.transmit_all);
    visit("use_color", self.use_color);
    visit("use_alpha", self.use_alpha);
  }
};

}  // namespace dioptre
