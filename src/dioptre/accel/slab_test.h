// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  explicit SlabRay(const Ray& ray) : origin_(ray.origin) {
    for (int axis = 0; axis < 3; ++axis) {
      inverse_[axis] = 1 / ray.direction[axis];
      const bool backward = std::signbit(ray.direction[axis]);
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
    const double near = latest(time(box, 0, near_), time(box, 1, near_), time(box, 2, near_));
    const double far = -latest(-time(box, 0, far_), -time(box, 1, far_), -time(box, 2, far_));
    const double begin = near * (1 - std::copysign(kMargin, near));
    const double end = far * (1 + std::copysign(kMargin, far));
    if (begin > range.min) range.min = begin;
    if (end < range.max) range.max = end;
    return range.min <= range.max;
  }

  /// The same for two boxes: bit 0 says that the ray meets the first, bit 1 the second.
  unsigned meets(const SlabPair& pair, const Interval& range, std::array<double, 2>& entry) const {
    using Lanes = SlabPair::Lanes;
    const auto time = [&](int axis, const std::array<int, 3>& side) {
      return (pair.plane_[static_cast<std::size_t>(side[axis])] - origin_[axis]) * inverse_[axis];
    };
    // As in latest(): a lane that is not a number loses every comparison and does not count.
    const auto later = [](Lanes a, Lanes b) { return a > b ? a : b; };
    const auto sooner = [](Lanes a, Lanes b) { return a < b ? a : b; };
    const Lanes lowest = {-kInfinity, -kInfinity}, highest = {kInfinity, kInfinity};
    const Lanes near = later(time(2, near_), later(time(1, near_), later(time(0, near_), lowest)));
    const Lanes far = sooner(time(2, far_), sooner(time(1, far_), sooner(time(0, far_), highest)));
    const Lanes less = {1 - kMargin, 1 - kMargin}, more = {1 + kMargin, 1 + kMargin};
    const Lanes begin = near * (near > 0 ? less : more);
    const Lanes end = far * (far > 0 ? more : less);
    const Lanes first = later(begin, Lanes{range.min, range.min});
    const Lanes last = sooner(end, Lanes{range.max, range.max});
    entry = {first[0], first[1]};
    return unsigned{first[0] <= last[0]} | unsigned{first[1] <= last[1]} << 1;
  }

 private:
  static constexpr double kMargin = 4 * std::numeric_limits<double>::epsilon();

  double time(const SlabBox& box, int axis, const std::array<int, 3>& side) const {
    return (box.plane[static_cast<std::size_t>(side[axis])] - origin_[axis]) * inverse_[axis];
  }
  /// The greatest of three numbers; those that are not numbers do not count.
  static double latest(double a, double b, double c) {
    double t = a > -kInfinity ? a : -kInfinity;
    t = b > t ? b : t;
    return c > t ? c : t;
  }

  Vec3 origin_, inverse_;
  std::array<int, 3> near_{}, far_{};
};

}  // namespace dioptre
