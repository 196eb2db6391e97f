// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/box_set.h"

namespace dioptre {

/// A binary tree of bounding volumes (Rubin and Whitted 1980, "A 3-dimensional representation for
/// fast rendering of complex scenes"). Items are divided along the longest axis of their middles
/// where the areas of both boxes, times the items in them, are least in sum (Goldsmith and Salmon
/// 1987, "Automatic creation of object hierarchies for ray tracing").
///
/// A Volume has a constructor from items, which makes the volume around them, `contains(point)`,
/// and a class Probe made from a ray, whose `meets(volume, range, entry)` tells whether the ray may
/// meet the volume within the range and sets a lower bound on where.
template <class Volume>
class VolumeHierarchy {
 public:
  explicit VolumeHierarchy(std::vector<BoxedItem> items) {
    if (items.empty()) return;
    nodes_.reserve(2 * items.size() - 1);
    build(items, 0);
  }

  /// Reports the items whose volume the ray meets.
  void walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const {
    if (nodes_.empty()) return;
    const typename Volume::Probe probe(ray);
    std::array<Pending, kMaxDepth> stack;
    std::size_t size = 0;
    double entry = 0;
    ++cost.nodes;
    if (probe.meets(nodes_[0].volume, range, entry)) stack[size++] = {entry, 0};
    while (size > 0) {
      const Pending top = stack[--size];
      if (top.entry > range.max) continue;
      const Node& node = nodes_[top.node];
      if (node.leaf) {
        ++cost.items;
        if (!leaf.visit(node.link, range)) return;
        continue;
      }
      Pending near{0, top.node + 1}, far{0, node.link};
      cost.nodes += 2;
      const bool meets_near = probe.meets(nodes_[near.node].volume, range, near.entry);
      const bool meets_far = probe.meets(nodes_[far.node].volume, range, far.entry);
      if (meets_near && meets_far && far.entry < near.entry) std::swap(near, far);
      if (meets_near && meets_far) stack[size++] = far;
      if (meets_near || meets_far) stack[size++] = meets_near ? near : far;
    }
  }

  /// Appends the items whose volume holds p.
  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const {
    std::array<std::uint32_t, kMaxDepth> stack;
    std::size_t size = 0;
    if (!nodes_.empty()) stack[size++] = 0;
    while (size > 0) {
      const std::uint32_t index = stack[--size];
      const Node& node = nodes_[index];
      if (!node.volume.contains(p)) continue;
      if (node.leaf) {
        items.push_back(node.link);
      } else {
        stack[size++] = node.link;
        stack[size++] = index + 1;
      }
    }
  }

  AcceleratorStatistics statistics() const {
    return {nodes_.size(), (nodes_.size() + 1) / 2, nodes_.capacity() * sizeof(Node)};
  }

 private:
  /// Deeper than kDeepestDivision the items are halved by number, which takes no more levels than
  /// an index has bits; and a walk holds one node more.
  static constexpr std::size_t kDeepestDivision = 32, kMaxDepth = kDeepestDivision + 40;

  /// An inner node's first child follows it; `link` is its second child, or the item of a leaf.
  struct Node {
    Volume volume;
    std::uint32_t link;
    bool leaf;
  };
  struct Pending {
    double entry;
    std::uint32_t node;
  };

  static int longest_axis(std::span<const BoxedItem> items) {
    Bounds centers;
    for (const BoxedItem& each : items) {
      centers = unite(centers, Vec3{each.center(0), each.center(1), each.center(2)});
    }
    const Vec3 extent = centers.extent();
    return extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  }

  /// Puts the items in order along an axis, and returns how many go to the first child.
  static std::size_t divide(std::span<BoxedItem> items, std::size_t depth) {
    const int axis = longest_axis(items);
    const auto before = [axis](const BoxedItem& a, const BoxedItem& b) {
      const double at = a.center(axis), other = b.center(axis);
      return at != other ? at < other : a.item < b.item;
    };
    const std::size_t half = items.size() / 2;
    if (depth > kDeepestDivision) {
      std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half),
                       items.end(), before);
      return half;
    }
    std::sort(items.begin(), items.end(), before);
    std::vector<double> cost(items.size());  // of the items before each place
    Bounds box;
    for (std::size_t i = 1; i < items.size(); ++i) {
      box = unite(box, items[i - 1].box);
      cost[i] = box.half_area() * static_cast<double>(i);
    }
    std::size_t best = half;
    double least = kInfinity;
    box = {};
    for (std::size_t i = items.size(); i-- > 1;) {
      box = unite(box, items[i].box);
      const double sum = cost[i] + box.half_area() * static_cast<double>(items.size() - i);
      if (sum < least) least = sum, best = i;
    }
    return best;
  }

  void build(std::span<BoxedItem> items, std::size_t depth) {
    const std::size_t index = nodes_.size();
    nodes_.push_back({Volume(items), items[0].item, true});
    if (items.size() == 1) return;
    const std::size_t first = divide(items, depth);
    build(items.first(first), depth + 1);
    nodes_[index].link = static_cast<std::uint32_t>(nodes_.size());
    nodes_[index].leaf = false;
    build(items.subspan(first), depth + 1);
  }

  std::vector<Node> nodes_;
};

}  // namespace dioptre
