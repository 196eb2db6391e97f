// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "dioptre/geometry/height_field/height_field.h"

namespace dioptre {

/// A place on the grid: the cell, and where in it, 0 to 1 along x and z.
struct LandPlace {
  std::uint32_t i = 0, j = 0;
  double u = 0, v = 0;
};

/// The triangles of a grid of heights. Triangle 2 c is the one at the low corner of cell
/// c = j (width - 1) + i, triangle 2 c + 1 the one at its high corner.
class Land {
 public:
  Land(Shared<HeightGrid> grid, Vec3 smooth_scale) : grid_(std::move(grid)), scale_(smooth_scale) {}

  std::uint32_t cells_x() const { return grid_->width - 1; }
  std::uint32_t cells_z() const { return grid_->depth - 1; }
  double height(std::uint32_t i, std::uint32_t j) const {
    return double{grid_->heights[std::size_t{j} * grid_->width + i]};
  }
  Vec3 point(std::uint32_t i, std::uint32_t j) const {
    return {static_cast<double>(i) / cells_x(), height(i, j), static_cast<double>(j) / cells_z()};
  }
  /// The corners a, b, c of a triangle: cross(c - a, b - a) points up.
  std::array<Vec3, 3> triangle(std::uint32_t index) const;
  /// The cell at x and z in [0, 1].
  LandPlace place(double x, double z) const;
  /// The height of the triangles at x and z in [0, 1].
  double height_at(double x, double z) const;
  /// The unit normal at x and z. It is bilinear in the cell between those of its corners, which
  /// are unit vectors where the field is scaled; 0 if they cancel.
  Vec3 smooth_normal_at(double x, double z) const;

 private:
  /// The normal where the field is scaled. It is kept in steps of 1/32767 where cells are 1 long
  /// and heights are 65536 times as high (measured): steep land has only few of them.
  Vec3 corner_normal(std::uint32_t i, std::uint32_t j) const;

  Shared<HeightGrid> grid_;
  Vec3 scale_;
};

}  // namespace dioptre
