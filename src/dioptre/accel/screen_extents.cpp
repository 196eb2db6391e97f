// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/screen_extents.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "dioptre/accel/screen_square.h"

namespace dioptre {
namespace {

constexpr std::size_t kScreens = 6;
constexpr double kMostSquares = 512;
/// Squares per item, on all screens.
constexpr double kDensity = 8;

Bounds relative(const Bounds& box, Vec3 eye) { return {box.min - eye, box.max - eye}; }

double distance_to(const Bounds& seen) {
  Vec3 gap;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gap[axis] = std::max({seen.min[axis], -seen.max[axis], 0.0});
  }
  return length(gap);
}

bool moderate(Vec3 v) { return max_component(abs(v)) <= 1e100; }

}  // namespace

/// Fills the squares.
class ScreenBuilder {
 public:
  ScreenBuilder(ScreenExtents& screens, std::vector<BoxedItem> sorted, Vec3 eye)
      : screens_(screens), sorted_(std::move(sorted)), eye_(eye) {}

  void build() {
    choose_side(16 * sorted_.size() + 64);
    auto& first = screens_.first_;
    first.assign(kScreens * screens_.side_ * screens_.side_ + 1, 0);
    for_each_listing([&](std::size_t square, std::uint32_t) { ++first[square + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    screens_.listed_.resize(first.back());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for_each_listing(
        [&](std::size_t square, std::uint32_t index) { screens_.listed_[next[square]++] = index; });
  }

 private:
  /// The finest division that lists no more than `most` in all, by steps of 2.
  void choose_side(std::size_t most) {
    const double squares = kDensity * static_cast<double>(sorted_.size()) / kScreens;
    screens_.side_ = static_cast<std::size_t>(std::clamp(std::sqrt(squares), 1.0, kMostSquares));
    while (screens_.side_ > 1 && listings() > most) screens_.side_ /= 2;
  }

  std::size_t listings() const {
    std::size_t total = 0;
    for (const BoxedItem& each : sorted_) {
      for (std::size_t screen = 0; screen < kScreens; ++screen) {
        total += project(relative(each.box, eye_), screen, screens_.side_).size();
      }
    }
    return total;
  }

  /// Calls `use(square, index)` for every square that an item covers, nearest items first.
  template <class Use>
  void for_each_listing(Use&& use) const {
    const std::size_t side = screens_.side_;
    for (std::uint32_t index = 0; index < sorted_.size(); ++index) {
      const Bounds seen = relative(sorted_[index].box, eye_);
      for (std::size_t screen = 0; screen < kScreens; ++screen) {
        const ScreenRectangle covered = project(seen, screen, side);
        for (auto v = covered.first[1]; v <= covered.last[1]; ++v) {
          for (auto u = covered.first[0]; u <= covered.last[0]; ++u) {
            use((screen * side + static_cast<std::size_t>(v)) * side + static_cast<std::size_t>(u),
                index);
          }
        }
      }
    }
  }

  ScreenExtents& screens_;
  std::vector<BoxedItem> sorted_;
  Vec3 eye_;
};

/// Passes on what the other structure finds, under the numbers of the items.
class ScreenExtents::Renumbering final : public LeafVisitor {
 public:
  Renumbering(const std::vector<std::uint32_t>& item_of, LeafVisitor& leaf)
      : item_of_(item_of), leaf_(leaf) {}
  bool visit(std::uint32_t index, Interval& range) override {
    return leaf_.visit(item_of_[index], range);
  }

 private:
  const std::vector<std::uint32_t>& item_of_;
  LeafVisitor& leaf_;
};

ScreenExtents::ScreenExtents(std::span<const BoxedItem> items, std::optional<Vec3> eye,
                             AcceleratorPtr others)
    : others_(std::move(others)) {
  for (const BoxedItem& each : items) item_of_.push_back(each.item);
  if (!eye || !moderate(*eye)) return;
  eye_ = eye;
  std::vector<BoxedItem> sorted(items.begin(), items.end());
  std::stable_sort(sorted.begin(), sorted.end(), [&eye](const BoxedItem& a, const BoxedItem& b) {
    return distance_to(relative(a.box, *eye)) < distance_to(relative(b.box, *eye));
  });
  for (const BoxedItem& each : sorted) {
    seen_.push_back({SlabBox(each.box), distance_to(relative(each.box, *eye)), each.item});
  }
  ScreenBuilder(*this, std::move(sorted), *eye).build();
}

void ScreenExtents::walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const {
  const double fastest = max_component(abs(ray.direction));
  const bool ordinary = is_finite(ray.direction) && fastest > 1e-100 && fastest < 1e100;
  if (eye_ && ray.origin == *eye_ && range.min >= 0 && ordinary) {
    look(ray, range, leaf, cost);
    return;
  }
  Renumbering renumbering(item_of_, leaf);
  others_->visit(ray, range, renumbering, cost);
}

void ScreenExtents::look(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const {
  ++cost.nodes;
  const SlabRay slabs(ray);
  // Rounded up, as the distances may be rounded by some units in their last place.
  const double speed = length(ray.direction) * (1 + 0x1p-45);
  double entry = 0;
  for (const std::uint32_t index : covering(ray.direction)) {
    const Seen& each = seen_[index];
    if (each.distance > range.max * speed) return;
    ++cost.boxes;
    if (!slabs.meets(each.box, range, entry)) continue;
    ++cost.items;
    if (!leaf.visit(each.item, range)) return;
  }
}

std::span<const std::uint32_t> ScreenExtents::covering(Vec3 direction) const {
  const ScreenPoint at = pierce(direction);
  const std::size_t square =
      (at.screen * side_ + square_of(at.v, side_)) * side_ + square_of(at.u, side_);
  return std::span(listed_).subspan(first_[square], first_[square + 1] - first_[square]);
}

void ScreenExtents::items_at(Vec3 p, std::vector<std::uint32_t>& items) const {
  const std::size_t first = items.size();
  others_->items_at(p, items);
  for (std::size_t i = first; i < items.size(); ++i) items[i] = item_of_[items[i]];
}

AcceleratorStatistics ScreenExtents::statistics() const {
  AcceleratorStatistics size = others_->statistics();
  size.nodes += first_.size();
  size.references += listed_.size();
  size.bytes +=
      (first_.capacity() + listed_.capacity() + item_of_.capacity()) * sizeof(std::uint32_t) +
      seen_.capacity() * sizeof(Seen);
  return size;
}

}  // namespace dioptre
