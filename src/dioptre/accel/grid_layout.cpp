// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/grid_layout.h"

namespace dioptre {
namespace {

/// No axis has more cells.
constexpr double kMostCells = 0x1p20;
/// A ray whose origin is more cells away would lose a cell's margin by rounding.
constexpr double kFarthest = 0x1p36;
constexpr double kSmallest = 0x1p-500, kLargest = 0x1p500;

/// The numbers of cells along the axes for cubic cells. Axes too short for two cells get one, and
/// the others share what that leaves.
std::array<double, 3> cubic(Vec3 extent, double cells) {
  std::array<double, 3> count{1, 1, 1};
  std::array<bool, 3> divided{extent.x > 0, extent.y > 0, extent.z > 0};
  for (int round = 0; round < 3; ++round) {
    int axes = 0;
    // Logarithms, for the product of extents may be no number.
    double log_volume = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!divided[axis]) continue;
      ++axes;
      log_volume += std::log2(extent[axis]);
    }
    bool fits = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      count[axis] = 1;
      if (!divided[axis]) continue;
      count[axis] = std::exp2((std::log2(cells) - log_volume) / axes + std::log2(extent[axis]));
      if (count[axis] < 2) divided[axis] = fits = false;
    }
    if (fits) break;
  }
  return count;
}

}  // namespace

GridLayout::GridLayout(const Bounds& box, double cells) : box_(box), padded_(box) {
  const Vec3 extent = box.extent();
  const auto wanted = cubic(extent, std::max(cells, 1.0));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double count = std::floor(std::clamp(wanted[axis], 1.0, kMostCells));
    const double size = extent[axis] / count;
    const double magnitude = std::max(std::fabs(box.min[axis]), std::fabs(box.max[axis]));
    // Not divided where the margin of a cell would drown in the digits of its coordinates.
    if (count < 2 || !(size > 0x1p-36 * magnitude) || !(size > 1e-100)) continue;
    count_[axis] = static_cast<int>(count);
    scale_[axis] = count / extent[axis];
    padded_.min[axis] -= kMargin * size;
    padded_.max[axis] += kMargin * size;
  }
}

GridLayout::Range GridLayout::cells_of(const Bounds& box) const {
  Range range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = (box.min[axis] - box_.min[axis]) * scale_[axis];
    const double high = (box.max[axis] - box_.min[axis]) * scale_[axis];
    range.first[axis] = cell_of(axis, low - kMargin);
    range.last[axis] = cell_of(axis, high + kMargin);
  }
  return range;
}

Bounds GridLayout::bounds_of(const Cell& cell) const {
  Bounds box = padded_;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (count_[axis] == 1) continue;
    const double size = box_.extent()[axis] / count_[axis];
    box.min[axis] = box_.min[axis] + (cell[axis] - kMargin) * size;
    box.max[axis] = box_.min[axis] + (cell[axis] + 1 + kMargin) * size;
  }
  return box;
}

bool GridLayout::walkable(const Ray& ray) const {
  const double fastest = max_component(abs(ray.direction * scale_));
  const double farthest = max_component(abs((ray.origin - box_.min) * scale_));
  if (!is_finite(ray.direction) || !is_finite(ray.origin)) return false;
  return fastest > kSmallest && fastest < kLargest && farthest < kFarthest;
}

GridLayout::Axis GridLayout::start(const Ray& ray, std::size_t axis, double t) const {
  const double direction = ray.direction[axis] * scale_[axis];
  // So slow a ray crosses no plane before it leaves the grid along another axis.
  const bool still = std::fabs(direction) < kSmallest * kSmallest;
  Axis a;
  a.origin = (ray.origin[axis] - box_.min[axis]) * scale_[axis];
  a.inverse = still ? 0 : 1 / direction;
  a.cell = cell_of(axis, still ? a.origin : a.origin + t * direction);
  a.step = direction < 0 ? -1 : 1;
  a.last = still ? a.cell : a.step > 0 ? count_[axis] - 1 : 0;
  const std::ptrdiff_t row = count_[0], layer = row * count_[1];
  a.stride = a.step * (axis == 0 ? 1 : axis == 1 ? row : layer);
  a.look_ahead();
  return a;
}

}  // namespace dioptre
