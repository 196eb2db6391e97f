// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "dioptre/core/bounds.h"
#include "dioptre/core/ray.h"
#include "dioptre/raster/screen_view.h"

namespace dioptre {

/// How large the things in view are, in scene units.
struct ViewScale {
  double near = 1;  ///< of the smallest, with its distance from the eye
  double far = 1;   ///< where unbounded surfaces end
};

/// A lattice of cells over the part of a box that is in view: straight rows and columns on the
/// image, layers of depth behind each other. Seen by a perspective camera layers grow with their
/// depth, so that near and far cells look alike. All its lines are straight in the world: those of
/// axis 0 run along a row, of axis 1 along a column, and those of axis 2 into the depth.
class ViewLattice {
 public:
  /// The side of a cell on the image, in pixels: the more the larger a thing is seen. It is less
  /// for what is but a few pixels large, and more for what fills a very large image.
  static constexpr double kLeastCell = 1, kMostCell = 2;

  /// Nothing if the box is out of view.
  static std::optional<ViewLattice> around(const ScreenView& view, const Bounds& box,
                                           const ViewScale& scale);

  /// The number of cells along an axis; lines of other axes stand at 0 up to this, both included.
  std::uint32_t cells(std::size_t axis) const { return cells_[axis]; }
  /// The side of a cell on the image, in pixels.
  double side() const { return side_; }
  /// The number of all lines.
  double line_count() const;

  /// A line of an axis, at nodes of the two other axes in the order of their numbers.
  Ray line(std::size_t axis, std::uint32_t u, std::uint32_t v) const;
  /// The range of t on lines of an axis.
  Interval range(std::size_t axis) const;
  /// The cell in which a line of an axis is at t.
  std::uint32_t cell_at(std::size_t axis, double t) const;

  /// The nearest point of a cell to a point of view space, or the middle of the cell if that is
  /// nowhere. Cells may be one beside the lattice.
  Vec3 into_cell(const std::array<std::int64_t, 3>& cell, Vec3 view) const;
  /// The depth from the front to the back of a cell.
  double cell_depth(std::int64_t layer) const { return depth(layer + 1) - depth(layer); }

 private:
  explicit ViewLattice(const ScreenView& view) : view_(view) {}
  void set_layers(Interval depths, double step);
  double depth(double layer) const;
  double layer(double depth) const;

  ScreenView view_;
  Vec2 corner_;              ///< the place of node 0
  double side_ = kMostCell;  ///< of a cell, in pixels
  double first_depth_ = 0;
  double step_ = 1;  ///< from layer to layer: a length, or the logarithm of a ratio
  std::array<std::uint32_t, 3> cells_{};
};

}  // namespace dioptre
