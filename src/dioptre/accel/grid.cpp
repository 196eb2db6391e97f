// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/grid.h"

#include <numeric>

namespace dioptre {
namespace {

/// Cells per item.
constexpr double kDensity = 4;

/// How many cells list an item.
std::size_t cells_in(const GridLayout::Range& range) {
  std::size_t cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cells *= static_cast<std::size_t>(range.last[axis] - range.first[axis] + 1);
  }
  return cells;
}

template <class Use>
void for_each_cell(const GridLayout& layout, const Bounds& box, Use&& use) {
  const auto [first, last] = layout.cells_of(box);
  for (int z = first[2]; z <= last[2]; ++z) {
    for (int y = first[1]; y <= last[1]; ++y) {
      for (int x = first[0]; x <= last[0]; ++x) use(layout.index({x, y, z}));
    }
  }
}

/// The finest layout of at most `cells` cells, by steps of 8, that lists no more than `most`.
GridLayout fitting(std::span<const BoxedItem> items, std::span<const std::uint32_t> named,
                   const Bounds& box, double cells, std::size_t most) {
  for (;; cells /= 8) {
    const GridLayout layout(box, cells);
    std::size_t total = 0;
    for (const std::uint32_t each : named) total += cells_in(layout.cells_of(items[each].box));
    if (total <= most || layout.size() == 1) return layout;
  }
}

}  // namespace

GridCells::GridCells(std::span<const BoxedItem> items, std::span<const std::uint32_t> named,
                     const Bounds& box, double cells, std::size_t most)
    : layout_(fitting(items, named, box, cells, most)), first_(layout_.size() + 1) {
  for (const std::uint32_t each : named) {
    for_each_cell(layout_, items[each].box, [&](std::size_t cell) { ++first_[cell]; });
  }
  // Sums of what the cells up to each one list; filling backwards makes them the beginnings.
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  listed_.resize(first_.back());
  for (std::size_t i = named.size(); i-- > 0;) {
    for_each_cell(layout_, items[named[i]].box,
                  [&](std::size_t cell) { listed_[--first_[cell]] = named[i]; });
  }
}

AcceleratorStatistics GridCells::statistics() const {
  return {layout_.size(), listed_.size(),
          (first_.capacity() + listed_.capacity()) * sizeof(std::uint32_t)};
}

Grid::Grid(std::span<const BoxedItem> items)
    : items_(slabs_of(items)),
      bounds_(dioptre::bounds_of(items)),
      cells_(items, numbers_below(items.size()), items.empty() ? Bounds{{}, {}} : bounds_,
             kDensity * static_cast<double>(items.size()), 16 * items.size() + 64) {}

void Grid::walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const {
  if (clip(bounds_, ray, range).empty()) return;
  CellWalk walk(ray, range, leaf, cost);
  if (!cells_.layout().walkable(ray)) {
    walk.offer_all(items_);
    return;
  }
  cells_.layout().walk(ray, walk.range(), [&](std::size_t cell) {
    walk.step();
    return walk.offer(cells_.listed(cell), items_);
  });
}

void Grid::items_at(Vec3 p, std::vector<std::uint32_t>& items) const {
  if (!bounds_.contains(p)) return;
  const GridLayout& layout = cells_.layout();
  for (const std::uint32_t each : cells_.listed(layout.index(layout.cell_at(p)))) {
    if (items_[each].box.contains(p)) items.push_back(items_[each].item);
  }
}

AcceleratorStatistics Grid::statistics() const {
  AcceleratorStatistics size = cells_.statistics();
  size.bytes += items_.capacity() * sizeof(ItemSlabs);
  return size;
}

}  // namespace dioptre
