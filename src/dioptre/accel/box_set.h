// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dioptre/accel/slab_test.h"
#include "dioptre/core/bounds.h"

namespace dioptre {

/// A box and the index of the item in it, as structures are built from.
struct BoxedItem {
  Bounds box;
  std::uint32_t item;
  /// The middle along one axis; halved before the sum, which could overflow.
  double center(int axis) const { return 0.5 * box.min[axis] + 0.5 * box.max[axis]; }
};

/// The same, as rays are tested against it.
struct ItemSlabs {
  SlabBox box;
  std::uint32_t item;
};

/// The boxes of all items, sorted by what a structure can do with them.
struct BoxSet {
  std::vector<BoxedItem> walkable;  ///< of moderate numbers: areas and volumes do not overflow
  std::vector<ItemSlabs> apart;     ///< infinite or of huge numbers: to be tested for every ray
  Bounds bounds;                    ///< a box around all items
};

/// Sorts the boxes; empty ones are dropped, the others keep their order.
BoxSet sort_boxes(std::span<const Bounds> boxes);

/// The numbers 0, 1, ..., n - 1.
std::vector<std::uint32_t> numbers_below(std::size_t n);

/// A box around some items.
Bounds bounds_of(std::span<const BoxedItem> items);

/// What rays are tested against, for each item.
std::vector<ItemSlabs> slabs_of(std::span<const BoxedItem> items);

}  // namespace dioptre
