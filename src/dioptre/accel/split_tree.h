// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/box_set.h"

namespace dioptre {

/// A plane across a cell, and to which sides of it an item belongs. An item that only touches the
/// plane is on one side of it, for a ray that reaches the plane visits both.
struct SplitPlane {
  int axis;
  double at;
  bool holds_left(const Bounds& box) const { return box.min[axis] < at || box.max[axis] <= at; }
  bool holds_right(const Bounds& box) const { return box.max[axis] > at; }
};

/// A binary tree of cells split by axis-aligned planes, each leaf listing the items in its cell: a
/// BSP tree with planes along the axes, or kd-tree. The two builders are bsp_median and bsp_sah.
class SplitTree {
 public:
  /// No cell is split more often.
  static constexpr int kMaxDepth = 60;

  /// What a builder fills: nodes in the order of a walk that goes left first.
  class Builder {
   public:
    /// Appends an inner node, to which the left subtree is appended next.
    std::uint32_t add_split(const SplitPlane& plane);
    /// The right subtree of `node` is appended next.
    void begin_right(std::uint32_t node);
    /// Appends a leaf.
    void add_leaf(std::span<const std::uint32_t> listed);

   private:
    friend class SplitTree;
    explicit Builder(SplitTree& tree) : tree_(tree) {}
    SplitTree& tree_;
  };

  /// Builds a tree by `build(items, Builder&)`.
  template <class Build>
  SplitTree(std::span<const BoxedItem> items, Build&& build)
      : items_(slabs_of(items)), bounds_(bounds_of(items)) {
    if (items.empty()) return;
    Builder builder(*this);
    build(items, builder);
    nodes_.shrink_to_fit();
    listed_.shrink_to_fit();
  }

  /// Reports the items whose box the ray meets, from near cells to far ones.
  void walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const;
  /// Appends the items whose box holds p.
  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const;
  AcceleratorStatistics statistics() const;

 private:
  static constexpr std::uint32_t kLeaf = 3;

  /// An inner node's left child follows it and `first` is the right one; a leaf lists
  /// listed_[first, first + count).
  struct Node {
    double plane = 0;
    std::uint32_t first = 0;
    std::uint32_t axis : 2 = kLeaf;
    std::uint32_t count : 30 = 0;
  };

  std::span<const std::uint32_t> listed(const Node& leaf) const {
    return std::span(listed_).subspan(leaf.first, leaf.count);
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> listed_;
  std::vector<ItemSlabs> items_;
  Bounds bounds_;
};

/// How much a tree may grow by items listed on both sides of planes, and by its planes: n items
/// give it 8 n to spend, so that its size is linear in n whatever the boxes.
class SplitBudget {
 public:
  explicit SplitBudget(std::size_t items) : left_(8 * items + 64) {}

  /// Whether `items` may be split into so many left and right of a plane.
  bool affords(std::size_t items, std::size_t left, std::size_t right) const {
    return cost(items, left, right) <= left_;
  }
  /// Pays for a split and shares what is left in proportion; the receiver keeps the left's share.
  SplitBudget split(std::size_t items, std::size_t left, std::size_t right);

 private:
  static std::size_t cost(std::size_t items, std::size_t left, std::size_t right) {
    return left + right - items + 1;
  }
  std::size_t left_;
};

/// Planes in the middle of the longest side of each cell that holds more than a few items, as in
/// Kaplan 1985, "Space tracing: a constant time ray tracer".
void build_bsp_median(std::span<const BoxedItem> items, SplitTree::Builder& out);

/// The plane of least expected cost among the sides of all boxes, found in O(n log n): Wald and
/// Havran 2006, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)".
void build_bsp_sah(std::span<const BoxedItem> items, SplitTree::Builder& out);

}  // namespace dioptre
