// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "dioptre/core/shared.h"
#include "dioptre/scene/mesh_camera.h"

namespace dioptre {

/// Finds the face of a mesh that wears a texture coordinate, by a grid over the unit square.
class UvFaces {
 public:
  UvFaces() = default;
  /// The indices of the mesh must be valid. Without texture coordinates nothing is found
  /// (measured).
  explicit UvFaces(const Shared<MeshData>& data);

  struct Place {
    std::uint32_t face;
    double v, w;  ///< weights of the face's second and third corner
  };
  /// The first face that holds the coordinate, edges included.
  std::optional<Place> find(Vec2 uv) const;

 private:
  struct Box {
    Vec2 min, max;
  };
  struct Cells {
    std::uint32_t first_column, end_column, first_row, end_row;
  };
  std::array<Vec2, 3> corners(std::uint32_t face) const;
  Box box(std::uint32_t face) const;
  Cells cells(const Box& box) const;
  std::size_t count_entries() const;
  void fill();

  Shared<MeshData> data_;
  std::uint32_t side_ = 1;             ///< the grid has side x side cells
  std::vector<std::uint32_t> starts_;  ///< of the cells' faces in faces_, and the end
  std::vector<std::uint32_t> faces_;
};

}  // namespace dioptre
