// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/two_level_grid.h"

namespace dioptre {
namespace {

/// Cells per item of the top grid and of the grids within its cells.
constexpr double kTopDensity = 0.5, kInnerDensity = 4;
/// A cell that lists no more items has no grid of its own.
constexpr std::size_t kCrowd = 8;

}  // namespace

TwoLevelGrid::TwoLevelGrid(std::span<const BoxedItem> items)
    : items_(slabs_of(items)),
      bounds_(dioptre::bounds_of(items)),
      top_(items, numbers_below(items.size()), items.empty() ? Bounds{{}, {}} : bounds_,
           kTopDensity * static_cast<double>(items.size()), 4 * items.size() + 64),
      inner_of_(top_.layout().size(), kNoGrid) {
  divide_cells(items);
}

void TwoLevelGrid::divide_cells(std::span<const BoxedItem> items) {
  const GridLayout& layout = top_.layout();
  for (std::size_t cell = 0; cell < layout.size(); ++cell) {
    const auto listed = top_.listed(cell);
    if (listed.size() <= kCrowd) continue;
    Bounds around;
    for (const std::uint32_t each : listed) around = unite(around, items[each].box);
    const Bounds part = intersect(around, layout.bounds_of(layout.cell(cell)));
    if (part.empty()) continue;
    GridCells inner(items, listed, part, kInnerDensity * static_cast<double>(listed.size()),
                    4 * listed.size());
    if (inner.layout().size() == 1) continue;
    inner_of_[cell] = static_cast<std::uint32_t>(inner_.size());
    inner_.push_back(std::move(inner));
  }
  inner_.shrink_to_fit();
}

void TwoLevelGrid::walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const {
  if (clip(bounds_, ray, range).empty()) return;
  CellWalk walk(ray, range, leaf, cost);
  if (!top_.layout().walkable(ray)) {
    walk.offer_all(items_);
    return;
  }
  top_.layout().walk(ray, walk.range(), [&](std::size_t cell) {
    walk.step();
    const std::uint32_t inner = inner_of_[cell];
    if (inner == kNoGrid) return walk.offer(top_.listed(cell), items_);
    return walk_cell(inner_[inner], ray, walk);
  });
}

bool TwoLevelGrid::walk_cell(const GridCells& grid, const Ray& ray, CellWalk& walk) const {
  if (!grid.layout().walkable(ray)) return walk.offer(grid.listed(), items_);
  return grid.layout().walk(ray, walk.range(), [&](std::size_t cell) {
    walk.step();
    return walk.offer(grid.listed(cell), items_);
  });
}

void TwoLevelGrid::items_at(Vec3 p, std::vector<std::uint32_t>& items) const {
  if (!bounds_.contains(p)) return;
  const GridLayout& layout = top_.layout();
  for (const std::uint32_t each : top_.listed(layout.index(layout.cell_at(p)))) {
    if (items_[each].box.contains(p)) items.push_back(items_[each].item);
  }
}

AcceleratorStatistics TwoLevelGrid::statistics() const {
  AcceleratorStatistics size = top_.statistics();
  for (const GridCells& grid : inner_) {
    const AcceleratorStatistics more = grid.statistics();
    size.nodes += more.nodes;
    size.references += more.references;
    size.bytes += more.bytes + sizeof(GridCells);
  }
  size.bytes +=
      inner_of_.capacity() * sizeof(std::uint32_t) + items_.capacity() * sizeof(ItemSlabs);
  return size;
}

}  // namespace dioptre
