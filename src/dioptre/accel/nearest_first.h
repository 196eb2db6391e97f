// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "dioptre/accel/bounding_volume_hierarchy.h"

namespace dioptre {

/// Walks a hierarchy along a ray strictly from near to far: a best-first search, where the nearest
/// box not yet opened is known at any time. Everything before it has been reported.
class NearestFirst {
 public:
  /// A subtree, or one item, not yet opened.
  struct Pending {
    double entry;  ///< a lower bound on where the ray enters it
    BoundingVolumeHierarchy::Child child;
    /// Orders a heap so that the nearest is on top; ties in the order of building.
    bool operator<(const Pending& b) const {
      return entry != b.entry ? entry > b.entry : child.first > b.child.first;
    }
  };

  /// Starts a walk along a ray, which must outlive it; `storage` is used as scratch space and keeps
  /// its capacity. The hierarchy's infinite boxes are reported first.
  NearestFirst(const BoundingVolumeHierarchy& tree, const SlabRay& ray, Interval range,
               std::vector<Pending>& storage)
      : tree_(tree), slabs_(ray), range_(range), heap_(storage) {
    heap_.clear();
    double entry = 0;
    if (tree_.has_root_ && slabs_.meets(tree_.root_box_, range_, entry)) push(entry, tree_.root_);
  }

  /// The entry of the nearest box not yet opened: no item reported later begins before it.
  double bound() const {
    if (next_everywhere_ < tree_.everywhere_.size() || next_unbounded_ < tree_.unbounded_.size()) {
      return -kInfinity;
    }
    return heap_.empty() ? kInfinity : heap_.front().entry;
  }

  /// Opens boxes until an item comes up; false when there are no more. With leaves of more than one
  /// item, `item` need not be met itself.
  bool next(std::uint32_t& item) {
    if (next_everywhere_ < tree_.everywhere_.size()) {
      item = tree_.everywhere_[next_everywhere_++];
      return true;
    }
    while (next_unbounded_ < tree_.unbounded_.size()) {
      const auto& each = tree_.unbounded_[next_unbounded_++];
      double entry = 0;
      if (!slabs_.meets(each.box, range_, entry)) continue;
      item = each.item;
      return true;
    }
    while (!heap_.empty()) {
      const BoundingVolumeHierarchy::Child child = heap_.front().child;
      if (child.count > 0) {
        item = tree_.order_[child.first];
        if (child.count == 1) {
          pop();
        } else {
          ++heap_.front().child.first;
          --heap_.front().child.count;
        }
        return true;
      }
      pop();
      const auto& node = tree_.nodes_[child.first];
      std::array<double, 2> entries;
      const unsigned met = slabs_.meets(node.boxes, range_, entries);
      if (met & 1) push(entries[0], node.child[0]);
      if (met & 2) push(entries[1], node.child[1]);
    }
    return false;
  }

 private:
  void push(double entry, BoundingVolumeHierarchy::Child child) {
    heap_.push_back({entry, child});
    std::push_heap(heap_.begin(), heap_.end());
  }
  void pop() {
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
  }

  const BoundingVolumeHierarchy& tree_;
  const SlabRay& slabs_;
  Interval range_;
  std::vector<Pending>& heap_;
  std::size_t next_everywhere_ = 0, next_unbounded_ = 0;
};

}  // namespace dioptre
