// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/bounding_volume_hierarchy.h"

#include <algorithm>
#include <optional>

namespace dioptre {
namespace {

constexpr std::size_t kBins = 16;
/// The cost of one item, in units of the cost of one inner node.
constexpr double kItemCost = 1;

struct Item {
  Bounds box;
  std::uint32_t index;
  /// Halved before the sum, which could overflow.
  double center(int axis) const { return 0.5 * box.min[axis] + 0.5 * box.max[axis]; }
};

/// Maps centers along one axis to bins.
struct Binning {
  int axis;
  double low, scale;
  std::size_t bin(const Item& item) const {
    const double at = (item.center(axis) - low) * scale;
    return at > 0 ? std::min(kBins - 1, static_cast<std::size_t>(std::min(at, 1.0 * kBins))) : 0;
  }
};

/// Cut after bin `last` of the left side.
struct Split {
  Binning binning;
  std::size_t last;
  double cost;
};

struct Bin {
  Bounds box;
  std::size_t count = 0;
};

/// The cheapest of the cuts between bins along one axis; nothing if all centers are in one bin.
std::optional<Split> best_split(std::span<const Item> items, const Binning& binning) {
  std::array<Bin, kBins> bins;
  for (const Item& item : items) {
    Bin& bin = bins[binning.bin(item)];
    bin.box = unite(bin.box, item.box);
    ++bin.count;
  }
  std::array<double, kBins> right_cost{};
  Bin right;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    right = {unite(right.box, bins[i].box), right.count + bins[i].count};
    right_cost[i - 1] = right.box.half_area() * static_cast<double>(right.count);
  }
  std::optional<Split> best;
  Bin left;
  for (std::size_t i = 0; i + 1 < kBins; ++i) {
    left = {unite(left.box, bins[i].box), left.count + bins[i].count};
    if (left.count == 0 || left.count == items.size()) continue;
    const double cost = left.box.half_area() * static_cast<double>(left.count) + right_cost[i];
    if (!best || cost < best->cost) best = Split{binning, i, cost};
  }
  return best;
}

std::optional<Split> best_split(std::span<const Item> items) {
  std::optional<Split> best;
  for (int axis = 0; axis < 3; ++axis) {
    double low = kInfinity, high = -kInfinity;
    for (const Item& item : items) {
      low = std::min(low, item.center(axis));
      high = std::max(high, item.center(axis));
    }
    const double scale = kBins / (high - low);
    if (!(high > low) || !std::isfinite(scale)) continue;
    const auto split = best_split(items, Binning{axis, low, scale});
    if (split && (!best || split->cost < best->cost)) best = split;
  }
  return best;
}

int finite_sides(const Bounds& box) {
  int count = 0;
  for (const double side : SlabBox(box).plane) count += std::isfinite(side) ? 1 : 0;
  return count;
}

Bounds bounds_of(std::span<const Item> items) {
  Bounds box;
  for (const Item& item : items) box = unite(box, item.box);
  return box;
}

}  // namespace

/// Fills a tree from its items, from the top down.
class BvhBuilder {
 public:
  BvhBuilder(BoundingVolumeHierarchy& tree, std::span<Item> items, std::uint32_t leaf_size)
      : tree_(tree), items_(items), leaf_size_(std::max(leaf_size, 1u)) {}

  /// Builds the subtree over items_[first, first + count). The depth bounds the recursion.
  BoundingVolumeHierarchy::Child build(std::uint32_t first, std::uint32_t count,
                                       std::size_t depth) {
    const auto items = items_.subspan(first, count);
    const std::uint32_t left = left_count(items, depth);
    if (left == 0) return {first, count};
    const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    BoundingVolumeHierarchy::Node node;
    node.boxes = {SlabBox(bounds_of(items.first(left))), SlabBox(bounds_of(items.subspan(left)))};
    node.child[0] = build(first, left, depth + 1);
    node.child[1] = build(first + left, count - left, depth + 1);
    tree_.nodes_[index] = node;
    return {index, 0};
  }

 private:
  /// Splits the items and returns how many go left; 0 makes a leaf.
  std::uint32_t left_count(std::span<Item> items, std::size_t depth) const {
    const auto count = static_cast<std::uint32_t>(items.size());
    if (count <= 1) return 0;
    const auto split = depth + 32 < BoundingVolumeHierarchy::kMaxDepth
                           ? best_split(std::span<const Item>(items))
                           : std::nullopt;
    if (!split) return count <= leaf_size_ ? 0 : count / 2;
    const double area = bounds_of(items).half_area();
    if (count <= leaf_size_ && !(area + kItemCost * split->cost < kItemCost * area * count)) {
      return 0;
    }
    const auto middle = std::partition(items.begin(), items.end(), [&](const Item& item) {
      return split->binning.bin(item) <= split->last;
    });
    return static_cast<std::uint32_t>(middle - items.begin());
  }

  BoundingVolumeHierarchy& tree_;
  std::span<Item> items_;
  std::uint32_t leaf_size_;
};

BoundingVolumeHierarchy::BoundingVolumeHierarchy(std::span<const Bounds> boxes,
                                                 std::uint32_t leaf_size) {
  std::vector<Item> items;
  items.reserve(boxes.size());
  Bounds finite;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].empty()) continue;
    bounds_ = unite(bounds_, boxes[i]);
    if (boxes[i].finite()) {
      items.push_back({boxes[i], i});
      finite = unite(finite, boxes[i]);
    } else if (finite_sides(boxes[i]) > 1) {
      unbounded_.push_back({SlabBox(boxes[i]), i});
    } else {
      everywhere_.push_back(i);
    }
  }
  if (items.empty()) return;
  has_root_ = true;
  root_box_ = SlabBox(finite);
  nodes_.reserve(items.size());
  root_ = BvhBuilder(*this, items, leaf_size).build(0, static_cast<std::uint32_t>(items.size()), 0);
  nodes_.shrink_to_fit();
  order_.reserve(items.size());
  for (const Item& item : items) order_.push_back(item.index);
}

}  // namespace dioptre
