// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/box_set.h"

#include <cmath>
#include <numeric>

namespace dioptre {
namespace {

/// No walkable number is larger: the product of three does not overflow.
constexpr double kLargest = 1e100;

bool moderate(Vec3 p) { return max_component(abs(p)) <= kLargest; }

}  // namespace

BoxSet sort_boxes(std::span<const Bounds> boxes) {
  BoxSet set;
  set.walkable.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].empty()) continue;
    set.bounds = unite(set.bounds, boxes[i]);
    if (moderate(boxes[i].min) && moderate(boxes[i].max)) {
      set.walkable.push_back({boxes[i], i});
    } else {
      set.apart.push_back({SlabBox(boxes[i]), i});
    }
  }
  return set;
}

std::vector<std::uint32_t> numbers_below(std::size_t n) {
  std::vector<std::uint32_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

Bounds bounds_of(std::span<const BoxedItem> items) {
  Bounds box;
  for (const BoxedItem& item : items) box = unite(box, item.box);
  return box;
}

std::vector<ItemSlabs> slabs_of(std::span<const BoxedItem> items) {
  std::vector<ItemSlabs> slabs;
  slabs.reserve(items.size());
  for (const BoxedItem& item : items) slabs.push_back({SlabBox(item.box), item.item});
  return slabs;
}

}  // namespace dioptre
