// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dioptre/accel/cell_walk.h"
#include "dioptre/accel/grid_layout.h"

namespace dioptre {

/// Equal cells that each list the items in them: the spatially enumerated auxiliary data structure
/// (SEADS) of Fujimoto, Tanaka and Iwata 1986, "ARTS: accelerated ray-tracing system".
class GridCells {
 public:
  /// Lists those of the `items` that are named, in about `cells` cells; in fewer ones if that would
  /// list more than `most` in all.
  GridCells(std::span<const BoxedItem> items, std::span<const std::uint32_t> named,
            const Bounds& box, double cells, std::size_t most);

  const GridLayout& layout() const { return layout_; }
  /// What a cell lists: indices into the items.
  std::span<const std::uint32_t> listed(std::size_t cell) const {
    return std::span(listed_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }
  /// All that any cell lists, some of it repeatedly.
  std::span<const std::uint32_t> listed() const { return listed_; }
  AcceleratorStatistics statistics() const;

 private:
  GridLayout layout_;
  /// Cell i lists listed_[first_[i], first_[i + 1]).
  std::vector<std::uint32_t> first_, listed_;
};

/// A uniform grid over all items.
class Grid {
 public:
  explicit Grid(std::span<const BoxedItem> items);
  /// Reports the items whose box the ray meets, cell by cell.
  void walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const;
  /// Appends the items whose box holds p.
  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const;
  AcceleratorStatistics statistics() const;

 private:
  std::vector<ItemSlabs> items_;
  Bounds bounds_;
  GridCells cells_;
};

}  // namespace dioptre
