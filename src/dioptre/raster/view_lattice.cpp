// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/view_lattice.h"

#include <algorithm>
#include <cmath>

namespace dioptre {
namespace {

constexpr double kMostLayers = 1 << 14;
constexpr double kManyCellsAcross = 160;  ///< of what is large
constexpr double kMostCellsAcross = 768;  ///< of anything
constexpr double kLeastCellsAcross = 8;   ///< of anything
constexpr double kNearest = 1e-5;         ///< of a size: what is nearer is not seen
constexpr double kLayerCells = 1.5;       ///< the depth of a cell, in its sides
/// Nodes lie off the round places where surfaces like to be.
constexpr double kOffset = 0.3713;

/// The box in view space, cut off in front of a depth.
struct Seen {
  Vec2 least{kInfinity, kInfinity}, most{-kInfinity, -kInfinity};
  Interval depths;
};

Vec3 corner_of(const Bounds& box, std::uint32_t i) {
  return {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
          i & 4 ? box.max.z : box.min.z};
}

void add(const ScreenView& view, Vec3 p, Seen& seen) {
  const Vec2 at = view.place(p);
  seen.least = {std::min(seen.least.x, at.x), std::min(seen.least.y, at.y)};
  seen.most = {std::max(seen.most.x, at.x), std::max(seen.most.y, at.y)};
  seen.depths = unite(seen.depths, {p.z, p.z});
}

/// What of the box is farther than `nearest`: its corners, and where its edges come through.
Seen see(const ScreenView& view, const Bounds& box, double nearest) {
  Seen seen;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const Vec3 from = view.to_view(corner_of(box, i));
    if (from.z >= nearest) add(view, from, seen);
    for (std::uint32_t bit = 1; bit < 8; bit *= 2) {
      if (i & bit) continue;
      const Vec3 to = view.to_view(corner_of(box, i | bit));
      if ((from.z < nearest) == (to.z < nearest)) continue;
      Vec3 cut = from + (nearest - from.z) / (to.z - from.z) * (to - from);
      cut.z = nearest;
      add(view, cut, seen);
    }
  }
  return seen;
}

/// For what is so many pixels across.
double side_of_cell(double across) {
  if (!(across > 0)) return ViewLattice::kLeastCell;
  const double side =
      std::clamp(across / kManyCellsAcross, ViewLattice::kLeastCell, ViewLattice::kMostCell);
  return std::clamp(side, across / kMostCellsAcross, across / kLeastCellsAcross);
}

std::uint32_t count(double cells, double most) {
  return cells > 1 ? static_cast<std::uint32_t>(std::min(std::ceil(cells), most)) : 1;
}

}  // namespace

std::optional<ViewLattice> ViewLattice::around(const ScreenView& view, const Bounds& box,
                                               const ViewScale& scale) {
  const Vec3 far{scale.far, scale.far, scale.far};
  const Vec3 eye = view.to_world(view.at({view.width() / 2.0, view.height() / 2.0}, 0));
  const Bounds finite = intersect(box, {eye - far, eye + far});
  const double unit = length(view.forward({view.width() / 2.0, view.height() / 2.0}));
  if (finite.empty() || !finite.finite()) return std::nullopt;
  const double size =
      std::min(scale.near, max_component(finite.extent()) + length(finite.center() - eye));
  Seen seen = see(view, finite, kNearest * size / unit);
  const double width = view.width(), height = view.height();
  if (seen.depths.empty() || seen.most.x < 0 || seen.most.y < 0 || seen.least.x > width ||
      seen.least.y > height) {
    return std::nullopt;
  }
  seen.least = {std::max(seen.least.x, 0.0), std::max(seen.least.y, 0.0)};
  seen.most = {std::min(seen.most.x, width), std::min(seen.most.y, height)};
  const Vec2 extent = seen.most - seen.least;
  ViewLattice lattice(view);
  lattice.side_ = side_of_cell(std::max(extent.x, extent.y));
  lattice.corner_ = seen.least - Vec2{1, 1} * ((1 + kOffset) * lattice.side_);
  lattice.cells_[0] = count(extent.x / lattice.side_ + 3, kMostCellsAcross + 4);
  lattice.cells_[1] = count(extent.y / lattice.side_ + 3, kMostCellsAcross + 4);
  const double pixel = std::max(length(view.right()), length(view.down()));
  lattice.set_layers(seen.depths, kLayerCells * lattice.side_ * pixel / unit);
  return lattice;
}

/// `step` is the depth of a cell at depth 1 of a perspective view, or anywhere.
void ViewLattice::set_layers(Interval depths, double step) {
  const bool perspective = view_.perspective();
  const double length = perspective ? std::log(depths.max / depths.min) : depths.max - depths.min;
  step_ = std::max(perspective ? std::log1p(step) : step, length / kMostLayers);
  const double before = (1 + kOffset) * step_;
  first_depth_ = perspective ? depths.min * std::exp(-before) : depths.min - before;
  cells_[2] = count(length / step_ + 3, kMostLayers + 4);
}

double ViewLattice::depth(double layer) const {
  return view_.perspective() ? first_depth_ * std::exp(layer * step_)
                             : first_depth_ + layer * step_;
}

double ViewLattice::layer(double depth) const {
  return (view_.perspective() ? std::log(depth / first_depth_) : depth - first_depth_) / step_;
}

double ViewLattice::line_count() const {
  const double x = cells_[0] + 1.0, y = cells_[1] + 1.0, z = cells_[2] + 1.0;
  return x * y + y * z + z * x;
}

Ray ViewLattice::line(std::size_t axis, std::uint32_t u, std::uint32_t v) const {
  if (axis == 2) {
    const Vec2 place = corner_ + side_ * Vec2{static_cast<double>(u), static_cast<double>(v)};
    return {view_.to_world(view_.at(place, 0)), view_.forward(place)};
  }
  const double w = depth(v), along = side_ * u;
  const Vec2 place =
      axis == 0 ? Vec2{corner_.x, corner_.y + along} : Vec2{corner_.x + along, corner_.y};
  const Vec3 step = axis == 0 ? view_.right() : view_.down();
  return {view_.to_world(view_.at(place, w)), view_.perspective() ? w * step : step};
}

Interval ViewLattice::range(std::size_t axis) const {
  if (axis == 2) {
    const double first = depth(0);
    return {view_.perspective() ? first : std::max(first, 0.0), depth(cells_[2])};
  }
  return {0, side_ * cells_[axis]};
}

std::uint32_t ViewLattice::cell_at(std::size_t axis, double t) const {
  const double cell = std::floor(axis == 2 ? layer(t) : t / side_);
  const double last = cells_[axis] - 1.0;
  return cell > 0 ? static_cast<std::uint32_t>(std::min(cell, last)) : 0;
}

Vec3 ViewLattice::into_cell(const std::array<std::int64_t, 3>& cell, Vec3 view) const {
  const auto clamp = [](double value, double least, double most) {
    return value >= least && value <= most ? value
           : value < least                 ? least
           : value > most                  ? most
                                           : 0.5 * (least + most);
  };
  const auto x = static_cast<double>(cell[0]), y = static_cast<double>(cell[1]);
  const auto z = static_cast<double>(cell[2]);
  const double w = clamp(view.z, depth(z), depth(z + 1));
  const Vec2 place = view_.place(view);
  const double left = corner_.x + x * side_, top = corner_.y + y * side_;
  return view_.at({clamp(place.x, left, left + side_), clamp(place.y, top, top + side_)}, w);
}

}  // namespace dioptre
