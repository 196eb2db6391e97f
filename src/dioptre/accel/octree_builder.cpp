// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <deque>

#include "dioptre/accel/octree.h"
#include "dioptre/accel/split_tree.h"

namespace dioptre {
namespace {

/// A cell with no more items is not split.
constexpr std::size_t kLeafSize = 4;
/// The cost of a step down the tree, in units of the cost of looking at an item.
constexpr double kStepCost = 3;

using Children = std::array<std::vector<std::uint32_t>, 8>;

/// Cells are cubes, or thin ones would cut many items.
Bounds cube_around(const Bounds& box) {
  const double side = max_component(box.extent());
  return {box.min, box.min + Vec3{side, side, side}};
}

Bounds child_of(const Bounds& cell, Vec3 middle, unsigned child) {
  Bounds box = cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    (child >> axis & 1 ? box.min : box.max)[axis] = middle[axis];
  }
  return box;
}

}  // namespace

/// Fills an octree level by level, so that a limit on its size is felt everywhere alike.
class OctreeBuilder {
 public:
  OctreeBuilder(Octree& tree, std::span<const BoxedItem> items)
      : tree_(tree), items_(items), left_(8 * items.size() + 64) {}

  void build() {
    tree_.nodes_.emplace_back();
    cells_.push_back({0, 0, cube_around(tree_.bounds_), numbers_below(items_.size())});
    for (; !cells_.empty(); cells_.pop_front()) {
      if (!split(cells_.front())) make_leaf(cells_.front());
    }
  }

 private:
  struct Cell {
    std::uint32_t node;
    std::size_t depth;
    Bounds box;
    std::vector<std::uint32_t> listed;
  };

  Children distribute(const Cell& cell, Vec3 middle) const {
    Children children;
    for (const std::uint32_t each : cell.listed) {
      const Bounds& box = items_[each].box;
      for (unsigned child = 0; child < 8; ++child) {
        bool holds = true;
        for (int axis = 0; axis < 3; ++axis) {
          const SplitPlane plane{axis, middle[static_cast<std::size_t>(axis)]};
          holds = holds && (child >> axis & 1 ? plane.holds_right(box) : plane.holds_left(box));
        }
        if (holds) children[child].push_back(each);
      }
    }
    return children;
  }

  /// Splits a cell if that is expected to make rays cheaper and the tree may grow.
  bool split(const Cell& cell) {
    const std::size_t count = cell.listed.size();
    if (count <= kLeafSize || cell.depth >= Octree::kMaxDepth) return false;
    const Vec3 middle = 0.5 * cell.box.min + 0.5 * cell.box.max;
    Children children = distribute(cell, middle);
    std::size_t listed = 0;
    unsigned bits = 0;
    for (unsigned child = 0; child < 8; ++child) {
      listed += children[child].size();
      bits |= unsigned{!children[child].empty()} << child;
    }
    // A child shows a ray a quarter of the area of its parent.
    if (kStepCost + 0.25 * static_cast<double>(listed) > static_cast<double>(count)) return false;
    const std::size_t growth = listed - count + 1;
    if (growth > left_) return false;
    left_ -= growth;
    const auto first = static_cast<std::uint32_t>(tree_.nodes_.size());
    Octree::Node& node = tree_.nodes_[cell.node];
    node.middle = middle;
    node.first = first;
    node.children = static_cast<std::uint8_t>(bits);
    for (unsigned child = 0; child < 8; ++child) {
      if (children[child].empty()) continue;
      cells_.push_back({static_cast<std::uint32_t>(tree_.nodes_.size()), cell.depth + 1,
                        child_of(cell.box, middle, child), std::move(children[child])});
      tree_.nodes_.emplace_back();
    }
    return true;
  }

  void make_leaf(const Cell& cell) {
    Octree::Node& node = tree_.nodes_[cell.node];
    node.first = static_cast<std::uint32_t>(tree_.listed_.size());
    node.count = static_cast<std::uint32_t>(cell.listed.size());
    tree_.listed_.insert(tree_.listed_.end(), cell.listed.begin(), cell.listed.end());
  }

  Octree& tree_;
  std::span<const BoxedItem> items_;
  std::size_t left_;
  std::deque<Cell> cells_;
};

Octree::Octree(std::span<const BoxedItem> items)
    : items_(slabs_of(items)), bounds_(bounds_of(items)) {
  if (items.empty()) return;
  OctreeBuilder(*this, items).build();
  nodes_.shrink_to_fit();
  listed_.shrink_to_fit();
}

}  // namespace dioptre
