// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "dioptre/accel/box_set.h"
#include "dioptre/accel/slab_test.h"

namespace dioptre {

/// The directions of slabs beyond the three axes: the diagonals of a cube, then of its faces.
inline constexpr std::array<Vec3, 10> kDiagonals{{{1, 1, 1},
                                                  {1, 1, -1},
                                                  {1, -1, 1},
                                                  {1, -1, -1},
                                                  {1, 1, 0},
                                                  {1, -1, 0},
                                                  {1, 0, 1},
                                                  {1, 0, -1},
                                                  {0, 1, 1},
                                                  {0, 1, -1}}};

/// A bounding volume between K pairs of parallel planes, for a VolumeHierarchy (Kay and Kajiya
/// 1986, "Ray tracing complex scenes"): the axes and the first K - 3 diagonals.
template <std::size_t K>
class SlabVolume {
  static_assert(K >= 3 && K <= 3 + kDiagonals.size());
  static constexpr std::size_t kMore = K - 3;
  static constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

 public:
  using Items = std::span<const BoxedItem>;

  explicit SlabVolume(Items items) : box_(bounds_of(items)) {
    for (std::size_t i = 0; i < kMore; ++i) {
      for (const BoxedItem& each : items) slabs_[i] = unite(slabs_[i], project(each.box, i));
    }
  }

  bool contains(Vec3 p) const {
    if (!box_.contains(p)) return false;
    for (std::size_t i = 0; i < kMore; ++i) {
      const double at = dot(p, kDiagonals[i]), error = rounding(p);
      if (at < slabs_[i].min - error || at > slabs_[i].max + error) return false;
    }
    return true;
  }

  /// A ray prepared for tests.
  class Probe {
   public:
    explicit Probe(const Ray& ray) : axes_(ray), error_(rounding(ray.origin)) {
      // A ray that a slab's planes are nearly parallel to has lost its digits and learns nothing.
      const double parallel = 0x1p-20 * rounding(ray.direction) / kEpsilon;
      for (std::size_t i = 0; i < kMore; ++i) {
        const double along = dot(ray.direction, kDiagonals[i]);
        origin_[i] = dot(ray.origin, kDiagonals[i]);
        inverse_[i] = std::fabs(along) > parallel ? 1 / along : 0;
      }
    }

    bool meets(const SlabVolume& volume, const Interval& range, double& entry) const {
      if (!axes_.meets(volume.box_, range, entry)) return false;
      double end = range.max;
      for (std::size_t i = 0; i < kMore; ++i) {
        if (inverse_[i] == 0) continue;
        const bool backward = inverse_[i] < 0;
        const Interval& slab = volume.slabs_[i];
        const double low = (slab.min - error_ - origin_[i]) * inverse_[i];
        const double high = (slab.max + error_ - origin_[i]) * inverse_[i];
        const double near = backward ? high : low, far = backward ? low : high;
        const double begin = near - kMargin * std::fabs(near);
        const double leave = far + kMargin * std::fabs(far);
        if (begin > entry) entry = begin;
        if (leave < end) end = leave;
      }
      return !(end < entry);
    }

   private:
    /// Bounds the relative error of a direction that has lost 20 of its 53 bits.
    static constexpr double kMargin = 0x1p-28;

    SlabRay axes_;
    double error_;
    std::array<double, kMore> origin_{}, inverse_{};
  };

 private:
  /// A bound on the rounding error of the dot product of p and a diagonal.
  static double rounding(Vec3 p) {
    return 4 * kEpsilon * (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
  }

  /// The extent of a box along a diagonal, no smaller than it is.
  static Interval project(const Bounds& box, std::size_t diagonal) {
    double low = 0, high = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double n = kDiagonals[diagonal][axis];
      low += n < 0 ? n * box.max[axis] : n * box.min[axis];
      high += n < 0 ? n * box.min[axis] : n * box.max[axis];
    }
    const double error = rounding(box.min) + rounding(box.max);
    return {low - error, high + error};
  }

  SlabBox box_;
  std::array<Interval, kMore> slabs_{};
};

}  // namespace dioptre
