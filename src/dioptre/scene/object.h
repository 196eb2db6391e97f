// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/geometry/shapes.h"
#include "dioptre/scene/ids.h"

namespace dioptre {

enum class CsgOperation : std::uint8_t { kUnion, kMerge, kIntersection, kDifference };

/// A solid made of others. A difference takes the rest from the first.
struct Csg {
  static constexpr const char* kName = "csg";
  CsgOperation operation = CsgOperation::kUnion;
  std::vector<ObjectId> children;
  bool split_union =
      true;  ///< false: inner surfaces as written even where splitting would be faster
  bool operator==(const Csg&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("operation", self.operation);
    visit("children", self.children);
    visit("split_union", self.split_union);
  }
};

/// A solid or sheet in the scene, or part of one. Objects may share children: every one places them
/// by its own transform.
struct Object {
  std::string name;  ///< the identifier it was declared under, if any
  std::variant<ShapeData, Csg> geometry = ShapeData{};
  Affine transform;  ///< own space to the parent's (or the world's)

  TextureId texture;                     ///< none: the parent's, in the end the default texture
  TextureId interior_texture;            ///< seen from inside; none: `texture`
  Affine texture_transform;              ///< space of the textures to the parent's space
  InteriorId interior;                   ///< none: the parent's
  std::vector<TextureId> part_textures;  ///< of mesh corners and blob components

  std::vector<ObjectId> clipped_by;  ///< shown only inside all of these; in the parent's space
  bool inverse = false;
  bool hollow = false;
  bool has_hollow = false;  ///< the flag was written, and wins over the parent's
  bool no_shadow = false;
  bool no_image = false;
  bool no_reflection = false;
  bool double_illuminate = false;
  bool uv_mapping = false;
  std::uint32_t light_group = 0;  ///< the lights of this group shine on it; 0: the whole's group
  bool global_lights = false;     ///< in a group: the lights of no group shine on it too
  bool operator==(const Object&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("name", self.name);
    visit("geometry", self.geometry);
    visit("transform", self.transform);
    visit("texture", self.texture);
    visit("interior_texture", self.interior_texture);
    visit("texture_transform", self.texture_transform);
    visit("interior", self.interior);
    visit("part_textures", self.part_textures);
    visit("clipped_by", self.clipped_by);
    visit("inverse", self.inverse);
    visit("hollow", self.hollow);
    visit("has_hollow", self.has_hollow);
    visit("no_shadow", self.no_shadow);
    visit("no_image", self.no_image);
    visit("no_reflection", self.no_reflection);
    visit("double_illuminate", self.double_illuminate);
    visit("uv_mapping", self.uv_mapping);
    visit("light_group", self.light_group);
    visit("global_lights", self.global_lights);
  }
};

}  // namespace dioptre
