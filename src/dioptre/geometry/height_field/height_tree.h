// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "dioptre/core/bounds.h"
#include "dioptre/geometry/height_field/land.h"

namespace dioptre {

/// The lowest and highest point of each square of 2^level x 2^level cells of land, kept by four: a
/// ray is held against the four parts of a square at once.
class HeightTree {
 public:
  explicit HeightTree(const Land& land) : land_(&land) {
    const std::uint32_t most = std::max(land.cells_x(), land.cells_z());
    levels_.resize(static_cast<std::size_t>(std::max<int>(std::bit_width(most - 1), 1)));
    for (std::uint32_t level = 0; level < levels_.size(); ++level) fill(level);
  }

  /// The heights of all the land.
  Interval heights() const {
    const Range all = of_square(static_cast<std::uint32_t>(levels_.size()), 0, 0);
    return {all.low, all.high};
  }

  /// Calls visit(cell, rest) for the cells that the ray may meet at y >= least in the range, the
  /// nearest first; it may lower rest.max.
  template <class Visit>
  void traverse(const Ray& ray, Interval range, double least, Visit&& visit) const {
    const SquareRay squares(ray, land_->cells_x(), land_->cells_z());
    struct Pending {
      double entry;
      std::uint32_t level, i, j;
    };
    Pending stack[3 * 32 + 1];
    std::size_t size = 0;
    stack[size++] = {range.min, static_cast<std::uint32_t>(levels_.size()) - 1, 0, 0};
    Interval rest = range;
    while (size > 0) {
      const Pending square = stack[--size];
      if (square.entry > rest.max) continue;
      const Level& level = levels_[square.level];
      const Parts& parts = level.squares[std::size_t{square.j} * level.width + square.i];
      std::array<double, 4> entry;
      const unsigned met =
          squares.meets(parts, square.level, square.i, square.j, least, rest, entry);
      if (met == 0) continue;
      // The part that the ray comes to first is popped, or visited, first.
      const bool leaf = square.level == 0;
      for (unsigned k = 0; k < 4; ++k) {
        const unsigned part = squares.nearest_part() ^ (leaf ? k : 3 - k);
        if (!(met >> part & 1)) continue;
        const std::uint32_t i = 2 * square.i + part % 2, j = 2 * square.j + part / 2;
        if (!leaf) {
          stack[size++] = {entry[part], square.level - 1, i, j};
        } else if (!(entry[part] > rest.max)) {
          visit(j * land_->cells_x() + i, rest);
        }
      }
    }
  }

 private:
  using Lanes = double __attribute__((vector_size(16)));
  struct Range {
    float low = 0, high = 0;
  };
  /// The four quarters of a square, x running first: {low, high} of none are {infinity, -infinity}.
  struct Parts {
    std::array<float, 4> low, high;
  };
  /// The squares of 2^(level + 1) cells.
  struct Level {
    std::uint32_t width = 0, depth = 0;
    std::vector<Parts> squares;
  };

  /// A ray measured in cells, prepared for tests of squares: none is missed, as times are moved by
  /// the bound on their rounding error (see SlabRay).
  class SquareRay {
   public:
    SquareRay(const Ray& ray, std::uint32_t cells_x, std::uint32_t cells_z)
        : x_(ray.origin.x, ray.direction.x, cells_x),
          y_(ray.origin.y, ray.direction.y),
          z_(ray.origin.z, ray.direction.z, cells_z),
          margin_(std::max(x_.margin(cells_x), z_.margin(cells_z))) {}

    /// The part of any square that lies to the side where the ray comes from.
    unsigned nearest_part() const { return (x_.backward ? 1u : 0u) | (z_.backward ? 2u : 0u); }

    /// Bit k says that the ray may meet part k of a square in the range, at y >= least; entry[k] is
    /// then a lower bound on where.
    unsigned meets(const Parts& parts, std::uint32_t level, std::uint32_t i, std::uint32_t j,
                   double least, Interval range, std::array<double, 4>& entry) const {
      const double half = std::uint32_t{1} << level;
      const auto x = x_.times(2.0 * i * half, half), z = z_.times(2.0 * j * half, half);
      Lanes x_near = Lanes{} + range.min, x_far = Lanes{} + range.max;
      clip(x_, Lanes{x[0], x[1]}, Lanes{x[1], x[2]}, x_near, x_far);
      unsigned met = 0;
      for (unsigned row = 0; row < 2; ++row) {
        Lanes near = x_near, far = x_far;
        clip(z_, Lanes{z[row], z[row]}, Lanes{z[row + 1], z[row + 1]}, near, far);
        const Lanes low{parts.low[2 * row], parts.low[2 * row + 1]};
        const Lanes high{parts.high[2 * row], parts.high[2 * row + 1]};
        clip(y_, (low - y_.origin) * y_.inverse, (high - y_.origin) * y_.inverse, near, far);
        near -= magnitude(near) * kRounding + margin_;
        far += magnitude(far) * kRounding + margin_;
        entry[2 * row] = near[0], entry[2 * row + 1] = near[1];
        const auto both = (near <= far) & (high >= least);
        met |= static_cast<unsigned>((both[0] & 1) | (both[1] & 2)) << (2 * row);
      }
      return met;
    }

   private:
    struct Axis {
      Axis(double o, double d, double cells = 1)
          : origin(o * cells), inverse(1 / (d * cells)), backward(std::signbit(d)) {}
      /// How far times can be off by the rounding of places up to `most`.
      double margin(double most) const {
        const double moved = kRounding * (std::fabs(origin) + most) * std::fabs(inverse);
        return std::isfinite(moved) ? moved : 0;
      }
      /// Where the ray passes three lines, `step` apart.
      std::array<double, 3> times(double first, double step) const {
        return {(first - origin) * inverse, (first + step - origin) * inverse,
                (first + 2 * step - origin) * inverse};
      }
      double origin, inverse;
      bool backward;
    };
    static constexpr double kRounding = 0x1p-50;

    // A time that is not a number, of a ray within a side, cuts nothing off.
    static void clip(const Axis& axis, const Lanes& low, const Lanes& high, Lanes& near,
                     Lanes& far) {
      const Lanes& first = axis.backward ? high : low;
      const Lanes& last = axis.backward ? low : high;
      near = first > near ? first : near;
      far = last < far ? last : far;
    }
    static Lanes magnitude(Lanes a) { return a > -a ? a : -a; }

    Axis x_, y_, z_;
    double margin_;
  };

  void fill(std::uint32_t level) {
    const std::uint32_t side = 2u << level;
    Level& l = levels_[level];
    l.width = (land_->cells_x() - 1) / side + 1;
    l.depth = (land_->cells_z() - 1) / side + 1;
    l.squares.resize(std::size_t{l.width} * l.depth);
    for (std::uint32_t j = 0; j < l.depth; ++j) {
      for (std::uint32_t i = 0; i < l.width; ++i) {
        Parts& parts = l.squares[std::size_t{j} * l.width + i];
        for (std::uint32_t k = 0; k < 4; ++k) {
          const Range range = of_square(level, 2 * i + k % 2, 2 * j + k / 2);
          parts.low[k] = range.low, parts.high[k] = range.high;
        }
      }
    }
  }

  /// The heights of a square of 2^level cells, of none beyond the land.
  Range of_square(std::uint32_t level, std::uint32_t i, std::uint32_t j) const {
    constexpr float kNone = std::numeric_limits<float>::infinity();
    if (level == 0) {
      return i < land_->cells_x() && j < land_->cells_z() ? of_cell(i, j) : Range{kNone, -kNone};
    }
    const Level& l = levels_[level - 1];
    if (i >= l.width || j >= l.depth) return {kNone, -kNone};
    const Parts& parts = l.squares[std::size_t{j} * l.width + i];
    return {*std::min_element(parts.low.begin(), parts.low.end()),
            *std::max_element(parts.high.begin(), parts.high.end())};
  }

  Range of_cell(std::uint32_t i, std::uint32_t j) const {
    const auto [low, high] = std::minmax({land_->height(i, j), land_->height(i + 1, j),
                                          land_->height(i, j + 1), land_->height(i + 1, j + 1)});
    return {static_cast<float>(low), static_cast<float>(high)};
  }

  const Land* land_;
  std::vector<Level> levels_;
};

}  // namespace dioptre
