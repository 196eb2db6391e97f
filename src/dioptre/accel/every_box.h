// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/box_set.h"

namespace dioptre {

/// No structure at all: every box is tested, which all the others are measured against.
class EveryBox {
 public:
  explicit EveryBox(std::span<const BoxedItem> items) : items_(slabs_of(items)) {}
  explicit EveryBox(std::vector<ItemSlabs> items) : items_(std::move(items)) {}

  /// Reports the items whose box the ray meets, in the order of the items; false if the walk was
  /// ended. The range shrinks as hits are found.
  bool walk_on(const SlabRay& ray, Interval& range, LeafVisitor& leaf, WalkCost& cost) const {
    double entry = 0;
    cost.boxes += items_.size();
    for (const ItemSlabs& each : items_) {
      if (!ray.meets(each.box, range, entry)) continue;
      ++cost.items;
      if (!leaf.visit(each.item, range)) return false;
    }
    return true;
  }

  /// The same for a walk of its own.
  void walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const {
    walk_on(SlabRay(ray), range, leaf, cost);
  }

  /// Appends the items whose box holds p.
  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const {
    for (const ItemSlabs& each : items_) {
      if (each.box.contains(p)) items.push_back(each.item);
    }
  }

  AcceleratorStatistics statistics() const {
    return {0, items_.size(), items_.capacity() * sizeof(ItemSlabs)};
  }

 private:
  std::vector<ItemSlabs> items_;
};

}  // namespace dioptre
