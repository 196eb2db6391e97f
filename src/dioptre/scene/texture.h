// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/scene/finish.h"
#include "dioptre/scene/ids.h"
#include "dioptre/scene/pattern.h"

namespace dioptre {

/// One layer: colour, bumps and light model, in the space of `transform`.
struct TextureLayer {
  PigmentId pigment;
  NormalId normal;  ///< may be none
  Finish finish;
  Affine transform;
  bool operator==(const TextureLayer&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pigment", self.pigment);
    visit("normal", self.normal);
    visit("finish", self.finish);
    visit("transform", self.transform);
  }
};

/// Layers, the bottom one first.
struct LayeredTexture {
  static constexpr const char* kName = "layers";
  std::vector<TextureLayer> layers;
  bool operator==(const LayeredTexture&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("layers", self.layers);
  }
};

/// A texture at a place in a map; for an average, its weight.
struct TextureEntry {
  double position = 0;
  TextureId texture;
  bool operator==(const TextureEntry&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("position", self.position);
    visit("texture", self.texture);
  }
};

/// Textures chosen by a pattern. An entry is evaluated at the point inside all warps of the
/// pattern.
struct TextureMap {
  static constexpr const char* kName = "texture_map";
  Pattern pattern;
  std::vector<TextureEntry> entries;
  bool list = false;  ///< true: the pattern gives the number of the entry
  bool operator==(const TextureMap&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pattern", self.pattern);
    visit("entries", self.entries);
    visit("list", self.list);
  }
};

/// The weighted mean of textures.
struct AverageTexture {
  static constexpr const char* kName = "average";
  std::vector<TextureEntry> entries;
  bool operator==(const AverageTexture&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("entries", self.entries);
  }
};

/// Textures chosen by the indices of an image.
struct MaterialMap {
  static constexpr const char* kName = "material_map";
  ImageId image;
  std::vector<TextureId> textures;
  bool operator==(const MaterialMap&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("image", self.image);
    visit("textures", self.textures);
  }
};

/// A texture evaluated at (u, v, 0) of the surface in place of the point.
struct UvTexture {
  static constexpr const char* kName = "uv_mapping";
  TextureId texture;
  bool operator==(const UvTexture&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("texture", self.texture);
  }
};

/// What a surface looks like, placed by `transform` in the space that the object gives it.
struct Texture {
  std::variant<LayeredTexture, TextureMap, AverageTexture, MaterialMap, UvTexture> data;
  Affine transform;
  bool operator==(const Texture&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("data", self.data);
    visit("transform", self.transform);
  }
};

}  // namespace dioptre
