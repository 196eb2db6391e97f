// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/shared.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// Heights at the points of a grid over the unit square of x and z.
struct HeightGrid {
  std::uint32_t width = 0;     ///< points along x
  std::uint32_t depth = 0;     ///< points along z
  std::vector<float> heights;  ///< row after row along x; the first row is at z = 0
  bool operator==(const HeightGrid&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("width", self.width);
    visit("depth", self.depth);
    visit("heights", self.heights);
  }
};

/// Land over the unit square: two triangles for each cell of the grid, which meet along the
/// diagonal from its +x to its +z corner. Inside is what is below the land, or below the water,
/// down to a floor just under y = 0. Only the land above the water is drawn.
struct HeightField {
  static constexpr const char* kName = "height_field";
  Shared<HeightGrid> grid;
  double water_level = 0;
  bool smooth = false;         ///< shaded with normals mixed between the points of the grid
  Vec3 smooth_scale{1, 1, 1};  ///< how much larger the field is where its normals are mixed

  bool operator==(const HeightField&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("grid", self.grid);
    visit("water_level", self.water_level);
    visit("smooth", self.smooth);
    visit("smooth_scale", self.smooth_scale);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for a grid of
/// less than 2 x 2 or more than 2^28 points or of the wrong size, for numbers that are not
/// finite, and for a smooth_scale with a part that is not greater than 0.
Result<ShapePtr> prepare(const HeightField& field);

}  // namespace dioptre
