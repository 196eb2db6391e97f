// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/octree.h"

#include <algorithm>
#include <array>
#include <bit>

#include "dioptre/accel/cell_walk.h"
#include "dioptre/accel/plane_times.h"

namespace dioptre {
namespace {

/// The number of the children of a node before number `child`.
unsigned children_before(unsigned children, unsigned child) {
  return static_cast<unsigned>(std::popcount(children & ((1u << child) - 1)));
}

/// Which children are on the lower side of the middle, for each axis.
constexpr std::array<unsigned, 3> kLower{0x55, 0x33, 0x0f};

/// The children's bits when their numbers are all changed by exclusive or with `change`.
unsigned renumbered(unsigned children, unsigned change) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (!(change >> axis & 1)) continue;
    const unsigned by = 1u << axis, lower = kLower[axis];
    children = (children & lower) << by | (children >> by & lower);
  }
  return children;
}

/// The middle planes of a cell as a ray meets them, children being numbered as the ray runs: the
/// bits of a number are 0 on the near sides and 1 on the far ones, and no child is behind one of a
/// greater number.
class MiddleTimes {
 public:
  MiddleTimes(const PlaneRay& planes, Vec3 middle) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      times_[axis] = planes.times(static_cast<int>(axis), middle[axis]);
    }
  }

  /// The children on sides of the planes that the ray is on at some time in `inside`.
  unsigned candidates(const Interval& inside) const {
    unsigned children = 0xff;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (times_[axis].until < inside.min) children &= ~kLower[axis];
      if (times_[axis].since > inside.max) children &= kLower[axis];
    }
    return children;
  }

  /// The part of `inside` for which the ray may be in a child.
  Interval child(unsigned number, Interval inside) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      inside = number >> axis & 1 ? PlaneRay::far_part(inside, times_[axis])
                                  : PlaneRay::near_part(inside, times_[axis]);
    }
    return inside;
  }

 private:
  std::array<PlaneTimes, 3> times_;
};

}  // namespace

void Octree::walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const {
  const Interval whole = nodes_.empty() ? Interval{} : clip(bounds_, ray, range);
  if (whole.empty()) return;
  const PlaneRay planes(ray);
  unsigned backward = 0;
  for (int axis = 0; axis < 3; ++axis) backward |= unsigned{planes.backward(axis)} << axis;
  CellWalk walk(ray, range, leaf, cost);
  struct Part {
    std::uint32_t node;
    Interval inside;
  };
  std::array<Part, 7 * kMaxDepth + 8> stack;
  std::size_t size = 0;
  stack[size++] = {0, whole};
  while (size > 0) {
    const Part part = stack[--size];
    if (part.inside.min > walk.range().max) continue;
    const Node& node = nodes_[part.node];
    walk.step();
    if (node.children == 0) {
      if (!walk.offer(std::span(listed_).subspan(node.first, node.count), items_)) return;
      continue;
    }
    const MiddleTimes times(planes, node.middle);
    unsigned candidates = times.candidates(part.inside) & renumbered(node.children, backward);
    while (candidates != 0) {
      const auto number = static_cast<unsigned>(std::bit_width(candidates)) - 1;
      candidates ^= 1u << number;
      const Interval inside = times.child(number, part.inside);
      if (inside.empty()) continue;
      const unsigned before = children_before(node.children, number ^ backward);
      stack[size++] = {node.first + before, inside};
    }
  }
}

void Octree::items_at(Vec3 p, std::vector<std::uint32_t>& items) const {
  if (nodes_.empty() || !bounds_.contains(p)) return;
  const std::size_t before = items.size();
  std::array<std::uint32_t, 7 * kMaxDepth + 8> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    if (node.children == 0) {
      for (const std::uint32_t each : std::span(listed_).subspan(node.first, node.count)) {
        if (items_[each].box.contains(p)) items.push_back(items_[each].item);
      }
    }
    for (unsigned child = 0; child < 8; ++child) {
      bool holds = node.children >> child & 1;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool upper = child >> axis & 1;
        holds = holds && (upper ? p[axis] >= node.middle[axis] : p[axis] <= node.middle[axis]);
      }
      if (holds) stack[size++] = node.first + children_before(node.children, child);
    }
  }
  const auto added = items.begin() + static_cast<std::ptrdiff_t>(before);
  std::sort(added, items.end());
  items.erase(std::unique(added, items.end()), items.end());
}

AcceleratorStatistics Octree::statistics() const {
  return {nodes_.size(), listed_.size(),
          nodes_.capacity() * sizeof(Node) + listed_.capacity() * sizeof(std::uint32_t) +
              items_.capacity() * sizeof(ItemSlabs)};
}

}  // namespace dioptre
