// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/split_tree.h"

namespace dioptre {
namespace {

/// A cell with no more items is not split.
constexpr std::size_t kLeafSize = 4;

class MedianBuilder {
 public:
  MedianBuilder(std::span<const BoxedItem> items, SplitTree::Builder& out)
      : items_(items), out_(out) {}

  /// Builds the subtree over the items listed; the depth bounds the recursion.
  void build(const Bounds& cell, std::vector<std::uint32_t> listed, SplitBudget budget, int depth) {
    const SplitPlane plane = middle_of(cell);
    const bool inside = cell.min[plane.axis] < plane.at && plane.at < cell.max[plane.axis];
    std::vector<std::uint32_t> left, right;
    if (inside && listed.size() > kLeafSize && depth < SplitTree::kMaxDepth) {
      for (const std::uint32_t each : listed) {
        if (plane.holds_left(items_[each].box)) left.push_back(each);
        if (plane.holds_right(items_[each].box)) right.push_back(each);
      }
    }
    const std::size_t count = listed.size();
    const bool separates = left.size() < count || right.size() < count;
    if (left.size() + right.size() == 0 || !separates ||
        !budget.affords(count, left.size(), right.size())) {
      out_.add_leaf(listed);
      return;
    }
    listed = {};
    const SplitBudget left_budget = budget.split(count, left.size(), right.size());
    Bounds left_cell = cell, right_cell = cell;
    left_cell.max[plane.axis] = right_cell.min[plane.axis] = plane.at;
    const std::uint32_t node = out_.add_split(plane);
    build(left_cell, std::move(left), left_budget, depth + 1);
    out_.begin_right(node);
    build(right_cell, std::move(right), budget, depth + 1);
  }

 private:
  static SplitPlane middle_of(const Bounds& cell) {
    const Vec3 extent = cell.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    return {axis, 0.5 * cell.min[axis] + 0.5 * cell.max[axis]};
  }

  std::span<const BoxedItem> items_;
  SplitTree::Builder& out_;
};

}  // namespace

void build_bsp_median(std::span<const BoxedItem> items, SplitTree::Builder& out) {
  MedianBuilder(items, out)
      .build(bounds_of(items), numbers_below(items.size()), SplitBudget(items.size()), 0);
}

}  // namespace dioptre
