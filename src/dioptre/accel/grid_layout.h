// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "dioptre/core/bounds.h"
#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"

namespace dioptre {

/// A box divided into equal cells, and the walk of a ray from cell to cell (Fujimoto, Tanaka and
/// Iwata 1986, "ARTS: accelerated ray-tracing system"; Amanatides and Woo 1987, "A fast voxel
/// traversal algorithm for ray tracing").
///
/// The walk goes wrong by rounding by less than half of kMargin of a cell, which is why a box
/// counts as being in every cell that comes as close to it as kMargin. Times are computed from the
/// planes, not summed up, so that the error does not grow.
class GridLayout {
 public:
  using Cell = std::array<int, 3>;
  /// The cells that a box is in: from first to last.
  struct Range {
    Cell first, last;
  };

  /// About `cells` cells in `box`, as cubic as may be and at least one; the box's numbers must be
  /// below 1e100.
  GridLayout(const Bounds& box, double cells);

  std::size_t size() const {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
           static_cast<std::size_t>(count_[2]);
  }
  std::size_t index(const Cell& cell) const {
    return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(count_[1]) +
            static_cast<std::size_t>(cell[1])) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(cell[0]);
  }
  /// The cell of an index.
  Cell cell(std::size_t index) const {
    const auto x = static_cast<std::size_t>(count_[0]), y = static_cast<std::size_t>(count_[1]);
    return {static_cast<int>(index % x), static_cast<int>(index / x % y),
            static_cast<int>(index / x / y)};
  }
  /// The cells of a box, which must not be empty; what is outside counts to the outermost cells.
  Range cells_of(const Bounds& box) const;
  /// A cell that holds p, which must lie in the box.
  Cell cell_at(Vec3 p) const { return cells_of({p, p}).first; }
  /// The box of a cell, enlarged by what a walk may go wrong by.
  Bounds bounds_of(const Cell& cell) const;

  /// Whether the ray's numbers allow a walk; if not, it may meet anything.
  bool walkable(const Ray& ray) const;

  /// Calls `bool enter(std::size_t cell)` for each cell on the way of a walkable ray within
  /// `range`, which may shrink on the way; false ends the walk and is handed back.
  template <class Enter>
  bool walk(const Ray& ray, const Interval& range, Enter&& enter) const;

  static constexpr double kMargin = 0x1p-12;

 private:
  struct Axis {
    double next;     ///< when the ray leaves the current cell along this axis
    double origin;   ///< of the ray, in cells
    double inverse;  ///< of its direction, in cells
    int cell, last;  ///< the current cell and the outermost one ahead
    int step;
    std::ptrdiff_t stride;

    /// The time at the plane ahead; the outermost one is left to the end of the range.
    void look_ahead() {
      next = cell == last ? kInfinity : ((step > 0 ? cell + 1 : cell) - origin) * inverse;
    }
  };

  int cell_of(std::size_t axis, double at) const {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, count_[axis] - 1.0));
  }
  Axis start(const Ray& ray, std::size_t axis, double t) const;

  Bounds box_, padded_;
  Vec3 scale_;  ///< cells per unit; 0 along an axis that is not divided
  Cell count_{1, 1, 1};
};

template <class Enter>
bool GridLayout::walk(const Ray& ray, const Interval& range, Enter&& enter) const {
  const Interval inside = clip(padded_, ray, range);
  if (inside.empty()) return true;
  std::array<Axis, 3> axes{start(ray, 0, inside.min), start(ray, 1, inside.min),
                           start(ray, 2, inside.min)};
  auto cell = static_cast<std::ptrdiff_t>(index({axes[0].cell, axes[1].cell, axes[2].cell}));
  while (enter(static_cast<std::size_t>(cell))) {
    const std::size_t nearer = axes[1].next < axes[0].next ? 1 : 0;
    Axis& axis = axes[axes[2].next < axes[nearer].next ? 2 : nearer];
    if (!(axis.next <= inside.max && axis.next <= range.max)) return true;
    axis.cell += axis.step;
    cell += axis.stride;
    axis.look_ahead();
  }
  return false;
}

}  // namespace dioptre
