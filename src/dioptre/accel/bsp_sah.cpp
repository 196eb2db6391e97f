// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "dioptre/accel/split_tree.h"

namespace dioptre {
namespace {

/// The cost of looking at an item, in units of the cost of a step down the tree.
constexpr double kItemCost = 0.4;
/// Cutting off empty space is worth more than the heuristic knows.
constexpr double kEmptyBonus = 0.8;

enum class Side : std::uint8_t { kEnd, kFlat, kStart };

/// Where an item ends, lies or starts along one axis.
struct Event {
  double at;
  std::uint32_t item;
  Side side;
  bool operator<(const Event& b) const {
    if (at != b.at) return at < b.at;
    return side != b.side ? side < b.side : item < b.item;
  }
};
/// For each axis, the events of the items of a cell in order. They keep their places when a plane
/// cuts an item, for then what lies outside the cell is only counted and never a place to cut.
using Events = std::array<std::vector<Event>, 3>;

struct Candidate {
  SplitPlane plane;
  std::size_t left, right;
  double cost;
};

class SahBuilder {
 public:
  SahBuilder(std::span<const BoxedItem> items, SplitTree::Builder& out)
      : items_(items), out_(out), sides_(items.size()) {
    const Vec3 extent = bounds_of(items).extent();
    // Flat cells need some area to be compared by.
    thickness_ = max_component(extent) * 0x1p-40;
  }

  Events all_events() const {
    Events events;
    for (int axis = 0; axis < 3; ++axis) {
      auto& list = events[static_cast<std::size_t>(axis)];
      list.reserve(2 * items_.size());
      for (std::uint32_t i = 0; i < items_.size(); ++i) {
        const double low = items_[i].box.min[axis], high = items_[i].box.max[axis];
        if (low == high) {
          list.push_back({low, i, Side::kFlat});
        } else {
          list.push_back({low, i, Side::kStart});
          list.push_back({high, i, Side::kEnd});
        }
      }
      std::sort(list.begin(), list.end());
    }
    return events;
  }

  /// Builds the subtree over `count` items; the depth bounds the recursion.
  void build(const Bounds& cell, Events events, std::size_t count, SplitBudget budget, int depth) {
    Candidate best{{}, 0, 0, kItemCost * static_cast<double>(count)};
    if (depth < SplitTree::kMaxDepth) {
      for (int axis = 0; axis < 3; ++axis) improve(best, cell, events, count, axis);
    }
    if (best.left + best.right == 0 || !budget.affords(count, best.left, best.right)) {
      add_leaf(events[0]);
      return;
    }
    Events left, right;
    distribute(events, best, left, right);
    const SplitBudget left_budget = budget.split(count, best.left, best.right);
    Bounds left_cell = cell, right_cell = cell;
    left_cell.max[best.plane.axis] = right_cell.min[best.plane.axis] = best.plane.at;
    const std::uint32_t node = out_.add_split(best.plane);
    build(left_cell, std::move(left), best.left, left_budget, depth + 1);
    out_.begin_right(node);
    build(right_cell, std::move(right), best.right, budget, depth + 1);
  }

 private:
  double area(Vec3 extent) const {
    const Vec3 e = extent + Vec3{thickness_, thickness_, thickness_};
    return e.x * e.y + e.y * e.z + e.z * e.x;
  }

  /// Sweeps a plane along one axis and keeps the cheapest place.
  void improve(Candidate& best, const Bounds& cell, const Events& events, std::size_t count,
               int axis) const {
    const double low = cell.min[axis], high = cell.max[axis];
    const double whole = area(cell.extent());
    if (!(low < high) || !(whole > 0)) return;
    Vec3 extent = cell.extent();
    std::size_t left = 0, right = count;
    const auto& list = events[static_cast<std::size_t>(axis)];
    for (std::size_t i = 0; i < list.size();) {
      const double at = list[i].at;
      if (at >= high) break;
      std::array<std::size_t, 3> met{};
      for (; i < list.size() && list[i].at == at; ++i)
        ++met[static_cast<std::size_t>(list[i].side)];
      const auto [ends, flat, starts] = met;
      right -= ends + flat;
      left += flat;
      if (at > low) {
        extent[static_cast<std::size_t>(axis)] = at - low;
        const double left_area = area(extent);
        extent[static_cast<std::size_t>(axis)] = high - at;
        const double right_area = area(extent);
        const double items =
            (left_area * static_cast<double>(left) + right_area * static_cast<double>(right)) /
            whole;
        const double bonus = left == 0 || right == 0 ? kEmptyBonus : 1;
        const double cost = bonus * (1 + kItemCost * items);
        if (cost < best.cost) best = {{axis, at}, left, right, cost};
      }
      left += starts;
    }
  }

  /// Hands the events to the sides that their items belong to; both stay in order.
  void distribute(Events& events, const Candidate& split, Events& left, Events& right) {
    constexpr std::uint8_t kLeft = 1, kRight = 2;
    for (const Event& event : events[0]) {
      const Bounds& box = items_[event.item].box;
      sides_[event.item] = static_cast<std::uint8_t>((split.plane.holds_left(box) ? kLeft : 0) |
                                                     (split.plane.holds_right(box) ? kRight : 0));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      left[axis].reserve(2 * split.left);
      right[axis].reserve(2 * split.right);
      for (const Event& event : events[axis]) {
        if (sides_[event.item] & kLeft) left[axis].push_back(event);
        if (sides_[event.item] & kRight) right[axis].push_back(event);
      }
      events[axis] = {};
    }
  }

  void add_leaf(const std::vector<Event>& events) {
    listed_.clear();
    for (const Event& event : events) {
      if (event.side != Side::kEnd) listed_.push_back(event.item);
    }
    out_.add_leaf(listed_);
  }

  std::span<const BoxedItem> items_;
  SplitTree::Builder& out_;
  std::vector<std::uint8_t> sides_;
  std::vector<std::uint32_t> listed_;
  double thickness_ = 0;
};

}  // namespace

void build_bsp_sah(std::span<const BoxedItem> items, SplitTree::Builder& out) {
  SahBuilder builder(items, out);
  builder.build(bounds_of(items), builder.all_events(), items.size(), SplitBudget(items.size()), 0);
}

}  // namespace dioptre
