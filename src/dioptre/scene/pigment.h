// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "dioptre/core/color.h"
#include "dioptre/scene/ids.h"
#include "dioptre/scene/pattern.h"

namespace dioptre {

/// A colour at a place in a map.
struct ColorEntry {
  double position = 0;
  PigmentColor color;
  bool operator==(const ColorEntry&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("position", self.position);
    visit("color", self.color);
  }
};

/// A pigment at a place in a map; for an average, its weight.
struct PigmentEntry {
  double position = 0;
  PigmentId pigment;
  bool operator==(const PigmentEntry&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("position", self.position);
    visit("pigment", self.pigment);
  }
};

/// One colour everywhere.
struct SolidPigment {
  static constexpr const char* kName = "solid";
  PigmentColor color;
  bool operator==(const SolidPigment&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("color", self.color);
  }
};

/// Colours chosen by a pattern.
struct ColorMapPigment {
  static constexpr const char* kName = "color_map";
  Pattern pattern;
  std::vector<ColorEntry> entries;
  bool list = false;  ///< true: the pattern gives the number of the entry
  bool operator==(const ColorMapPigment&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pattern", self.pattern);
    visit("entries", self.entries);
    visit("list", self.list);
  }
};

/// Pigments chosen by a pattern. An entry is evaluated at the point inside all warps of the pattern
/// (transforms, turbulence): what moves the map moves its entries.
struct PigmentMapPigment {
  static constexpr const char* kName = "pigment_map";
  Pattern pattern;
  std::vector<PigmentEntry> entries;
  bool list = false;  ///< true: the pattern gives the number of the entry
  bool operator==(const PigmentMapPigment&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pattern", self.pattern);
    visit("entries", self.entries);
    visit("list", self.list);
  }
};

/// The weighted mean of pigments, evaluated at the point inside the warps.
struct AveragePigment {
  static constexpr const char* kName = "average";
  std::vector<PigmentEntry> entries;
  std::vector<Warp> warps;
  bool operator==(const AveragePigment&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("entries", self.entries);
    visit("warps", self.warps);
  }
};

/// Colours from an image.
struct ImagePigment {
  static constexpr const char* kName = "image_map";
  ImageId image;
  std::vector<Warp> warps;
  bool operator==(const ImagePigment&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("image", self.image);
    visit("warps", self.warps);
  }
};

/// A pigment evaluated at (u, v, 0) of the surface in place of the point.
struct UvPigment {
  static constexpr const char* kName = "uv_mapping";
  PigmentId pigment;
  bool operator==(const UvPigment&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pigment", self.pigment);
  }
};

/// A colour with transparency for every point of space.
struct Pigment {
  std::variant<SolidPigment, ColorMapPigment, PigmentMapPigment, AveragePigment, ImagePigment,
               UvPigment>
      data;
  PigmentColor quick_color;  ///< for renders at quality 5 and below
  bool has_quick_color = false;
  bool operator==(const Pigment&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("data", self.data);
    visit("quick_color", self.quick_color);
    visit("has_quick_color", self.has_quick_color);
  }
};

}  // namespace dioptre
