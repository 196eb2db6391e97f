// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/box_set.h"
#include "dioptre/accel/mailbox.h"
#include "dioptre/accel/slab_test.h"

namespace dioptre {

/// One ray on its way through the cells of a structure.
class CellWalk {
 public:
  CellWalk(const Ray& ray, const Interval& range, LeafVisitor& leaf, WalkCost& cost)
      : range_(range), slabs_(ray), leaf_(leaf), cost_(cost) {}

  /// What is left of the ray: range.max falls as hits are found.
  const Interval& range() const { return range_; }

  /// Counts a node or cell.
  void step() { ++cost_.nodes; }

  /// Reports those of the listed items that the ray meets and that it has not met before; false
  /// ends the walk.
  bool offer(std::span<const std::uint32_t> listed, std::span<const ItemSlabs> items) {
    cost_.boxes += listed.size();
    for (const std::uint32_t each : listed) {
      if (!offer(items[each])) return false;
    }
    return true;
  }

  /// The same for items that are all listed.
  bool offer_all(std::span<const ItemSlabs> items) {
    cost_.boxes += items.size();
    for (const ItemSlabs& each : items) {
      if (!offer(each)) return false;
    }
    return true;
  }

 private:
  bool offer(const ItemSlabs& each) {
    double entry = 0;
    if (!slabs_.meets(each.box, range_, entry) || !mailbox_.insert(each.item)) return true;
    ++cost_.items;
    return leaf_.visit(each.item, range_);
  }

  Interval range_;
  SlabRay slabs_;
  LeafVisitor& leaf_;
  WalkCost& cost_;
  Mailbox mailbox_;
};

}  // namespace dioptre
