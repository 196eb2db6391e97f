// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dioptre/core/bounds.h"
#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"

namespace dioptre {

/// A box as its six planes: the least x, y and z, then the greatest.
struct SlabBox {
  std::array<double, 6> plane{};

  SlabBox() : SlabBox(Bounds{}) {}
  explicit SlabBox(const Bounds& b) : plane{b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z} {}
  bool contains(Vec3 p) const {
    return plane[0] <= p.x && p.x <= plane[3] && plane[1] <= p.y && p.y <= plane[4] &&
           plane[2] <= p.z && p.z <= plane[5];
  }
};

/// Two boxes side by side, for one test of both.
class SlabPair {
 public:
  SlabPair() = default;
  SlabPair(const SlabBox& first, const SlabBox& second) {
    for (std::size_t i = 0; i < 6; ++i) plane_[i] = Lanes{first.plane[i], second.plane[i]};
  }
  bool contains(std::size_t which, Vec3 p) const {
    return plane_[0][which] <= p.x && p.x <= plane_[3][which] && plane_[1][which] <= p.y &&
           p.y <= plane_[4][which] && plane_[2][which] <= p.z && p.z <= plane_[5][which];
  }

 private:
  friend class SlabRay;
  using Lanes = double __attribute__((vector_size(16)));
  std::array<Lanes, 6> plane_{};
};

/// A ray prepared for many box tests (Kay and Kajiya 1986, "Ray tracing complex scenes").
///
/// The test never misses a box: both ends are moved outwards by the bound on their rounding error
/// (Ize 2013, "Robust BVH ray traversal"), and 0 times infinity, which arises where a ray runs
/// within a face, counts as meeting.
class SlabRay {
 public:
  explicit SlabRay(const Ray& ray) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double origin = ray.origin[axis], direction = ray.direction[axis];
      origin_[axis] = Lanes{origin, origin};
      inverse_[axis] = 1 / Lanes{direction, direction};
      const bool backward = std::signbit(direction);
      near_[axis] = backward ? axis + 3 : axis;
      far_[axis] = backward ? axis : axis + 3;
    }
  }

  /// Whether the ray meets the box within `range`; `entry` is then a lower bound on where.
  bool meets(const SlabBox& box, const Interval& range, double& entry) const {
    Interval within = range;
    const bool met = clip(box, within);
    entry = within.min;
    return met;
  }

  /// Cuts `range` to a stretch that holds all of the box; false if nothing is left.
  bool clip(const SlabBox& box, Interval& range) const {
    const auto time = [&](std::size_t axis, const Sides& side) {
      return (box.plane[side[axis]] - origin_[axis][0]) * inverse_[axis][0];
    };
    const double near =
        later(time(2, near_), later(time(1, near_), later(time(0, near_), range.min)));
    const double far =
        sooner(time(2, far_), sooner(time(1, far_), sooner(time(0, far_), range.max)));
    if (near > range.min) range.min = std::max(range.min, near - std::fabs(near) * kMargin);
    if (far < range.max) range.max = std::min(range.max, far + std::fabs(far) * kMargin);
    return range.min <= range.max;
  }

  /// The same for two boxes: bit 0 says that the ray meets the first, bit 1 the second.
  unsigned meets(const SlabPair& pair, const Interval& range, std::array<double, 2>& entry) const {
    const auto time = [&](std::size_t axis, const Sides& side) {
      return (pair.plane_[side[axis]] - origin_[axis]) * inverse_[axis];
    };
    const Lanes first = {range.min, range.min}, last = {range.max, range.max};
    const Lanes near = later(time(2, near_), later(time(1, near_), later(time(0, near_), first)));
    const Lanes far = sooner(time(2, far_), sooner(time(1, far_), sooner(time(0, far_), last)));
    const Lanes begin = near - absolute(near) * kMargin, end = far + absolute(far) * kMargin;
    entry = {begin[0], begin[1]};
    const auto met = begin <= end;
    return static_cast<unsigned>(met[0] & 1) | static_cast<unsigned>(met[1] & 2);
  }

 private:
  using Lanes = SlabPair::Lanes;
  using Sides = std::array<std::size_t, 3>;
  static constexpr double kMargin = 4 * std::numeric_limits<double>::epsilon();

  // Of a time that is not a number and a bound, the bound counts. A box behind an infinite time is
  // not met: its end is not a number, or no later than its beginning.
  template <class T>
  static T later(T time, T bound) {
    return time > bound ? time : bound;
  }
  template <class T>
  static T sooner(T time, T bound) {
    return time < bound ? time : bound;
  }
  static Lanes absolute(Lanes a) { return a > -a ? a : -a; }

  std::array<Lanes, 3> origin_, inverse_;
  Sides near_, far_;  ///< which planes the ray meets first and last
};

}  // namespace dioptre
