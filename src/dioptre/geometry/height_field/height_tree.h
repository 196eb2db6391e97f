// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dioptre/core/bounds.h"
#include "dioptre/geometry/height_field/land.h"

namespace dioptre {

/// The lowest and highest point of each square of 2^level x 2^level cells of land.
class HeightTree {
 public:
  explicit HeightTree(const Land& land) : land_(&land) {
    const std::uint32_t most = std::max(land.cells_x(), land.cells_z());
    levels_.resize(static_cast<std::size_t>(std::bit_width(most - 1)) + 1);
    for (std::uint32_t level = 0; level < levels_.size(); ++level) fill(level);
  }

  /// The heights of all the land.
  Interval heights() const { return {levels_.back().ranges[0].low, levels_.back().ranges[0].high}; }

  /// Calls visit(cell, rest) for the cells that the ray may meet at y >= least in the range, the
  /// nearest first; it may lower rest.max.
  template <class Visit>
  void traverse(const Ray& ray, Interval range, double least, Visit&& visit) const {
    struct Entry {
      std::uint32_t level, i, j;
    };
    Entry stack[4 * 32];
    std::size_t size = 0;
    stack[size++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0, 0};
    const Vec3 inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z};
    const std::uint32_t far_x = ray.direction.x >= 0, far_z = ray.direction.z >= 0;
    Interval rest = range;
    while (size > 0) {
      const auto [level, i, j] = stack[--size];
      const Level& l = levels_[level];
      const Range& heights = l.ranges[std::size_t{j} * l.width + i];
      if (!(double{heights.high} >= least)) continue;
      if (!may_meet(box(level, i, j, heights), ray, inverse, rest)) continue;
      if (level == 0) {
        visit(j * land_->cells_x() + i, rest);
        continue;
      }
      const Level& below = levels_[level - 1];
      const auto push = [&](std::uint32_t x, std::uint32_t z) {
        const std::uint32_t ci = 2 * i + x, cj = 2 * j + z;
        if (ci < below.width && cj < below.depth) stack[size++] = {level - 1, ci, cj};
      };
      push(far_x, far_z);
      push(1 - far_x, far_z);
      push(far_x, 1 - far_z);
      push(1 - far_x, 1 - far_z);
    }
  }

 private:
  struct Range {
    float low = 0, high = 0;
  };
  struct Level {
    std::uint32_t width = 0, depth = 0;
    std::vector<Range> ranges;
  };

  /// As clip(), for rays whose inverse direction is known.
  static bool may_meet(const Bounds& b, const Ray& ray, const Vec3& inverse, Interval range) {
    constexpr double kRounding = 0x1p-50;
    for (const std::size_t axis : {1, 0, 2}) {
      const double origin = ray.origin[axis];
      if (!std::isfinite(inverse[axis])) {
        const bool within = b.min[axis] <= origin && origin <= b.max[axis];
        if (ray.direction[axis] == 0 && !within) return false;
        continue;
      }
      const double a = (b.min[axis] - origin) * inverse[axis];
      const double c = (b.max[axis] - origin) * inverse[axis];
      const double near = std::min(a, c), far = std::max(a, c);
      range.min = std::max(range.min, near - kRounding * std::fabs(near));
      range.max = std::min(range.max, far + kRounding * std::fabs(far));
    }
    return !range.empty();
  }

  void fill(std::uint32_t level) {
    const std::uint32_t side = 1u << level;
    Level& l = levels_[level];
    l.width = (land_->cells_x() - 1) / side + 1;
    l.depth = (land_->cells_z() - 1) / side + 1;
    l.ranges.resize(std::size_t{l.width} * l.depth);
    for (std::uint32_t j = 0; j < l.depth; ++j) {
      for (std::uint32_t i = 0; i < l.width; ++i) {
        l.ranges[std::size_t{j} * l.width + i] = level == 0 ? of_cell(i, j) : of_four(level, i, j);
      }
    }
  }

  Range of_cell(std::uint32_t i, std::uint32_t j) const {
    const auto [low, high] = std::minmax({land_->height(i, j), land_->height(i + 1, j),
                                          land_->height(i, j + 1), land_->height(i + 1, j + 1)});
    return {static_cast<float>(low), static_cast<float>(high)};
  }

  Range of_four(std::uint32_t level, std::uint32_t i, std::uint32_t j) const {
    const Level& below = levels_[level - 1];
    Range all = below.ranges[std::size_t{2 * j} * below.width + 2 * i];
    for (std::uint32_t z = 2 * j; z < std::min(2 * j + 2, below.depth); ++z) {
      for (std::uint32_t x = 2 * i; x < std::min(2 * i + 2, below.width); ++x) {
        const Range& one = below.ranges[std::size_t{z} * below.width + x];
        all = {std::min(all.low, one.low), std::max(all.high, one.high)};
      }
    }
    return all;
  }

  Bounds box(std::uint32_t level, std::uint32_t i, std::uint32_t j, const Range& heights) const {
    const double nx = land_->cells_x(), nz = land_->cells_z();
    const std::uint32_t side = 1u << level;
    return {{i * side / nx, heights.low, j * side / nz},
            {std::min<double>((i + 1.0) * side, nx) / nx, heights.high,
             std::min<double>((j + 1.0) * side, nz) / nz}};
  }

  const Land* land_;
  std::vector<Level> levels_;
};

}  // namespace dioptre
