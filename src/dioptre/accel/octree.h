// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/box_set.h"

namespace dioptre {

/// Space split in eight, and again where it is crowded (Glassner 1984, "Space subdivision for fast
/// ray tracing"), walked from the top by the times at which the ray crosses the middle planes of
/// each cell (Revelles, Ureña and Lastra 2000, "An efficient parametric algorithm for octree
/// traversal").
class Octree {
 public:
  explicit Octree(std::span<const BoxedItem> items);

  /// Reports the items whose box the ray meets, from near cells to far ones.
  void walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const;
  /// Appends the items whose box holds p.
  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const;
  AcceleratorStatistics statistics() const;

 private:
  friend class OctreeBuilder;
  static constexpr std::size_t kMaxDepth = 32;

  /// An inner node has up to eight children, from `first` on: those that `children` has a bit for.
  /// Bit 0 of a child's number is set on the upper side of the middle in x, bit 1 in y, bit 2 in z.
  /// A leaf (no bit set) lists listed_[first, first + count).
  struct Node {
    Vec3 middle;
    std::uint32_t first = 0, count = 0;
    std::uint8_t children = 0;
  };

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> listed_;
  std::vector<ItemSlabs> items_;
  Bounds bounds_;
};

}  // namespace dioptre
