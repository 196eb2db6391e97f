// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dioptre/core/shared.h"
#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The corners, normals and texture coordinates that the triangles of a mesh index.
struct MeshData {
  /// A corner without a texture of its own shows the texture of the object.
  static constexpr std::uint32_t kNoTexture = TextureShare::kWhole;
  struct Face {
    std::array<std::uint32_t, 3> corners{};
    std::array<std::uint32_t, 3> normals{};  ///< used if MeshData::normals is not empty
    std::array<std::uint32_t, 3> uvs{};      ///< used if MeshData::uvs is not empty
    std::array<std::uint32_t, 3> textures{
        kNoTexture, kNoTexture, kNoTexture};  ///< per corner, indices into Object::part_textures
    bool operator==(const Face&) const = default;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit) {
      visit("corners", self.corners);
      visit("normals", self.normals);
      visit("uvs", self.uvs);
      visit("textures", self.textures);
    }
  };

  std::vector<Vec3> corners;
  std::vector<Vec3> normals;
  std::vector<Vec2> uvs;
  std::vector<Face> faces;
  bool operator==(const MeshData&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("corners", self.corners);
    visit("normals", self.normals);
    visit("uvs", self.uvs);
    visit("faces", self.faces);
  }
};

/// Triangles that share corners, or have their own at equal places; the normal of a face is along
/// cross(c - a, b - a). A solid if `inside_vector` is given, else a sheet.
struct Mesh {
  static constexpr const char* kName = "mesh";
  Shared<MeshData> data;
  Vec3 inside_vector;  ///< any direction; 0 means a sheet. Inside is what odd parity along
                       ///< it says: the mesh should be closed

  bool operator==(const Mesh&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("data", self.data);
    visit("inside_vector", self.inside_vector);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for an
/// index that refers to nothing, or a number that is not finite.
Result<ShapePtr> prepare(const Mesh& mesh, const ShapeOptions& options = {});

}  // namespace dioptre
