// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dioptre/accel/slab_test.h"
#include "dioptre/core/bounds.h"
#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"

namespace dioptre {

/// A binary tree of boxes over the boxes of n items, built by the surface area heuristic over bins
/// (Wald 2007, "On fast construction of SAH-based bounding volume hierarchies").
///
/// Knows only boxes and indices. Empty boxes are never reported; infinite ones are kept apart and
/// looked at first. The same boxes give the same tree. A ray or point may be given an item that it
/// does not meet, but never misses one.
class BoundingVolumeHierarchy {
 public:
  /// A subtree: an inner node if count is 0, else the items order_[first, first + count).
  struct Child {
    std::uint32_t first, count;  ///< not set at first: walks keep long stacks of these
  };

  BoundingVolumeHierarchy() = default;
  /// Builds the tree with at most `leaf_size` items in a leaf (fewer where that is faster).
  explicit BoundingVolumeHierarchy(std::span<const Bounds> boxes, std::uint32_t leaf_size = 4);

  /// The number of inner nodes.
  std::size_t node_count() const { return nodes_.size(); }
  /// Memory in use.
  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + order_.capacity() * sizeof(std::uint32_t) +
           unbounded_.capacity() * sizeof(Unbounded) +
           everywhere_.capacity() * sizeof(std::uint32_t);
  }
  /// The number of items.
  std::size_t item_count() const { return order_.size() + unbounded_.size() + everywhere_.size(); }

  /// A box around all items.
  const Bounds& bounds() const { return bounds_; }

  /// Calls `bool leaf(std::uint32_t item, Interval& range)` for the items whose box the ray may
  /// meet in `range`, roughly from near to far. The leaf may lower range.max, and then what lies
  /// beyond is skipped; it ends the walk by returning false. If the leaf has `step()`, that is
  /// called for each inner node looked at.
  template <class Leaf>
  void traverse(const Ray& ray, Interval& range, Leaf&& leaf) const {
    for (const std::uint32_t item : everywhere_) {
      if (!leaf(item, range)) return;
    }
    if (!has_root_ && unbounded_.empty()) return;
    const SlabRay slabs(ray);
    double entry = 0;
    for (const Unbounded& each : unbounded_) {
      if (slabs.meets(each.box, range, entry) && !leaf(each.item, range)) return;
    }
    if (!has_root_ || !slabs.meets(root_box_, range, entry)) return;
    struct Pending {
      double entry;
      Child child;
    };
    std::array<Pending, kMaxDepth + 1> stack;
    std::size_t size = 0;
    Child child = root_;
    while (true) {
      if (child.count > 0) {
        for (std::uint32_t i = 0; i < child.count; ++i) {
          if (!leaf(order_[child.first + i], range)) return;
        }
      } else {
        if constexpr (requires { leaf.step(); }) leaf.step();
        const Node& node = nodes_[child.first];
        std::array<double, 2> entries;
        const unsigned met = slabs.meets(node.boxes, range, entries);
        if (met == 3) {
          const std::size_t first = entries[0] <= entries[1] ? 0 : 1;
          stack[size++] = {entries[1 - first], node.child[1 - first]};
          child = node.child[first];
          continue;
        }
        if (met != 0) {
          child = node.child[met - 1];
          continue;
        }
      }
      do {
        if (size == 0) return;
        --size;
      } while (stack[size].entry > range.max);
      child = stack[size].child;
    }
  }

  /// Calls `void leaf(std::uint32_t item)` for the items whose box may hold p.
  template <class Leaf>
  void visit_at(Vec3 p, Leaf&& leaf) const {
    for (const std::uint32_t item : everywhere_) leaf(item);
    for (const Unbounded& each : unbounded_) {
      if (each.box.contains(p)) leaf(each.item);
    }
    if (!has_root_ || !root_box_.contains(p)) return;
    std::array<Child, kMaxDepth + 1> stack;
    std::size_t size = 0;
    stack[size++] = root_;
    while (size > 0) {
      const Child child = stack[--size];
      for (std::uint32_t i = 0; i < child.count; ++i) leaf(order_[child.first + i]);
      if (child.count > 0) continue;
      const Node& node = nodes_[child.first];
      for (std::size_t side : {1, 0}) {
        if (node.boxes.contains(side, p)) stack[size++] = node.child[side];
      }
    }
  }

 private:
  friend class NearestFirst;
  friend class BvhBuilder;

  /// No path is longer: below kMaxDepth - 32 levels the items are halved by number.
  static constexpr std::size_t kMaxDepth = 96;

  struct Node {
    SlabPair boxes;
    std::array<Child, 2> child;
  };
  struct Unbounded {
    SlabBox box;
    std::uint32_t item;
  };

  Bounds bounds_;
  SlabBox root_box_;
  Child root_{};
  bool has_root_ = false;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Unbounded> unbounded_;
  std::vector<std::uint32_t> everywhere_;  ///< with at most one finite side: never worth a test
};

}  // namespace dioptre
