// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/split_tree.h"

#include <algorithm>
#include <array>

#include "dioptre/accel/cell_walk.h"
#include "dioptre/accel/plane_times.h"

namespace dioptre {

std::uint32_t SplitTree::Builder::add_split(const SplitPlane& plane) {
  const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
  Node node;
  node.plane = plane.at;
  node.axis = static_cast<std::uint32_t>(plane.axis) & 3;
  tree_.nodes_.push_back(node);
  return index;
}

void SplitTree::Builder::begin_right(std::uint32_t node) {
  tree_.nodes_[node].first = static_cast<std::uint32_t>(tree_.nodes_.size());
}

void SplitTree::Builder::add_leaf(std::span<const std::uint32_t> listed) {
  Node node;
  node.first = static_cast<std::uint32_t>(tree_.listed_.size());
  node.count = static_cast<std::uint32_t>(listed.size()) & 0x3fffffff;
  tree_.nodes_.push_back(node);
  tree_.listed_.insert(tree_.listed_.end(), listed.begin(), listed.end());
}

void SplitTree::walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const {
  const Interval inside = nodes_.empty() ? Interval{} : clip(bounds_, ray, range);
  if (inside.empty()) return;
  const PlaneRay planes(ray);
  CellWalk walk(ray, range, leaf, cost);
  struct Part {
    std::uint32_t node;
    Interval inside;
  };
  std::array<Part, kMaxDepth + 1> stack;
  std::size_t size = 0;
  Part part{0, inside};
  while (true) {
    const Node& node = nodes_[part.node];
    walk.step();
    if (node.axis == kLeaf) {
      if (!walk.offer(listed(node), items_)) return;
      do {
        if (size == 0) return;
        part = stack[--size];
      } while (part.inside.min > walk.range().max);
      continue;
    }
    const int axis = static_cast<int>(node.axis);
    const PlaneTimes times = planes.times(axis, node.plane);
    const std::uint32_t left = part.node + 1;
    const bool backward = planes.backward(axis);
    const Part near{backward ? node.first : left, PlaneRay::near_part(part.inside, times)};
    const Part far{backward ? left : node.first, PlaneRay::far_part(part.inside, times)};
    if (near.inside.empty()) {
      part = far;
    } else {
      if (!far.inside.empty()) stack[size++] = far;
      part = near;
    }
  }
}

void SplitTree::items_at(Vec3 p, std::vector<std::uint32_t>& items) const {
  if (nodes_.empty() || !bounds_.contains(p)) return;
  const std::size_t before = items.size();
  std::array<std::uint32_t, kMaxDepth + 1> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t index = stack[--size];
    const Node& node = nodes_[index];
    if (node.axis == kLeaf) {
      for (const std::uint32_t each : listed(node)) {
        if (items_[each].box.contains(p)) items.push_back(items_[each].item);
      }
      continue;
    }
    if (p[node.axis] >= node.plane) stack[size++] = node.first;
    if (p[node.axis] <= node.plane) stack[size++] = index + 1;
  }
  const auto added = items.begin() + static_cast<std::ptrdiff_t>(before);
  std::sort(added, items.end());
  items.erase(std::unique(added, items.end()), items.end());
}

AcceleratorStatistics SplitTree::statistics() const {
  return {nodes_.size(), listed_.size(),
          nodes_.capacity() * sizeof(Node) + listed_.capacity() * sizeof(std::uint32_t) +
              items_.capacity() * sizeof(ItemSlabs)};
}

SplitBudget SplitBudget::split(std::size_t items, std::size_t left, std::size_t right) {
  left_ -= cost(items, left, right);
  SplitBudget share = *this;
  const double part = static_cast<double>(left) / static_cast<double>(left + right);
  share.left_ = std::min(left_, static_cast<std::size_t>(static_cast<double>(left_) * part));
  left_ -= share.left_;
  return share;
}

}  // namespace dioptre
