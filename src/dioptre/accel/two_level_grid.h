// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dioptre/accel/grid.h"

namespace dioptre {

/// A coarse grid whose crowded cells have grids of their own, for scenes with much in few places:
/// Jevans and Wyvill 1989, "Adaptive voxel subdivision for ray tracing"; Kalojanov, Billeter and
/// Slusallek 2011, "Two-level grids for ray tracing on GPUs".
class TwoLevelGrid {
 public:
  explicit TwoLevelGrid(std::span<const BoxedItem> items);
  /// Reports the items whose box the ray meets, cell by cell.
  void walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const;
  /// Appends the items whose box holds p.
  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const;
  AcceleratorStatistics statistics() const;

 private:
  static constexpr std::uint32_t kNoGrid = 0xffffffff;

  /// Builds grids in the cells that list many items.
  void divide_cells(std::span<const BoxedItem> items);
  bool walk_cell(const GridCells& grid, const Ray& ray, CellWalk& walk) const;

  std::vector<ItemSlabs> items_;
  Bounds bounds_;
  GridCells top_;
  /// For each cell of the top grid, the number of its own grid or kNoGrid.
  std::vector<std::uint32_t> inner_of_;
  std::vector<GridCells> inner_;
};

}  // namespace dioptre
