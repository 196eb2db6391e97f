// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "dioptre/scene/ids.h"
#include "dioptre/scene/pattern.h"

namespace dioptre {

/// Height and slope at a place in a slope map.
struct SlopeEntry {
  double position = 0;
  double height = 0;
  double slope = 0;
  bool operator==(const SlopeEntry&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("position", self.position);
    visit("height", self.height);
    visit("slope", self.slope);
  }
};

/// A normal at a place in a map; for an average, its weight.
struct NormalEntry {
  double position = 0;
  NormalId normal;
  bool operator==(const NormalEntry&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("position", self.position);
    visit("normal", self.normal);
  }
};

/// Bumps whose height is a pattern.
struct PatternNormal {
  static constexpr const char* kName = "pattern";
  Pattern pattern;
  std::vector<SlopeEntry> slope_map;  ///< may be empty
  double amount = 0.5;
  bool operator==(const PatternNormal&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pattern", self.pattern);
    visit("slope_map", self.slope_map);
    visit("amount", self.amount);
  }
};

/// Normals chosen by a pattern.
struct NormalMapNormal {
  static constexpr const char* kName = "normal_map";
  Pattern pattern;
  std::vector<NormalEntry> entries;
  bool list = false;  ///< true: the pattern gives the number of the entry
  bool operator==(const NormalMapNormal&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pattern", self.pattern);
    visit("entries", self.entries);
    visit("list", self.list);
  }
};

/// The weighted mean of normals.
struct AverageNormal {
  static constexpr const char* kName = "average";
  std::vector<NormalEntry> entries;
  std::vector<Warp> warps;
  bool operator==(const AverageNormal&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("entries", self.entries);
    visit("warps", self.warps);
  }
};

/// Bumps whose height is an image.
struct BumpMapNormal {
  static constexpr const char* kName = "bump_map";
  ImageId image;
  double amount = 0.5;
  std::vector<Warp> warps;
  bool operator==(const BumpMapNormal&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("image", self.image);
    visit("amount", self.amount);
    visit("warps", self.warps);
  }
};

/// A normal evaluated at (u, v, 0) of the surface in place of the point.
struct UvNormal {
  static constexpr const char* kName = "uv_mapping";
  NormalId normal;
  bool operator==(const UvNormal&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("normal", self.normal);
  }
};

/// How the shading normal of a surface is disturbed. It is carried into the pattern's space as a
/// covector by the transforms among the warps, made unit there (not with `no_bump_scale`),
/// disturbed, carried back and made unit: uniform scaling does not change the bumps' steepness.
/// Entries of a normal map are evaluated inside the warps of the map.
struct Normal {
  std::variant<PatternNormal, NormalMapNormal, AverageNormal, BumpMapNormal, UvNormal> data;
  double bump_size = 1;  ///< multiplies the amount
  bool has_bump_size = false;
  bool no_bump_scale = false;
  double accuracy = 0.02;  ///< the distance at which a pattern's slope is sampled
  bool operator==(const Normal&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("data", self.data);
    visit("bump_size", self.bump_size);
    visit("has_bump_size", self.has_bump_size);
    visit("no_bump_scale", self.no_bump_scale);
    visit("accuracy", self.accuracy);
  }
};

}  // namespace dioptre
