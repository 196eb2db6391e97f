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

/// A binary tree of bounding volumes, built by halving the items at the median of their middles
/// along the longest axis (Kay and Kajiya 1986, "Ray tracing complex scenes"; Rubin and
/// Whitted 1980, "A 3-dimensional representation for fast rendering of complex scenes").
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
    build(items);
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
  /// Halving bounds the depth by the number of bits of an index, and a walk holds one node more.
  static constexpr std::size_t kMaxDepth = 40;

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

  void build(std::span<BoxedItem> items) {
    const std::size_t index = nodes_.size();
    nodes_.push_back({Volume(items), items[0].item, true});
    if (items.size() == 1) return;
    const int axis = longest_axis(items);
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [axis](const BoxedItem& a, const BoxedItem& b) {
                       const double at = a.center(axis), other = b.center(axis);
                       return at != other ? at < other : a.item < b.item;
                     });
    build(items.first(half));
    nodes_[index].link = static_cast<std::uint32_t>(nodes_.size());
    nodes_[index].leaf = false;
    build(items.subspan(half));
  }

  std::vector<Node> nodes_;
};

}  // namespace dioptre
