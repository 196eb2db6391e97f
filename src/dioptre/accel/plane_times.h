// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"

namespace dioptre {

/// When a ray crosses an axis-aligned plane: it is on the near side up to `until` and on the far
/// side from `since` on. The two overlap by the bound on the rounding error (Ize 2013, "Robust BVH
/// ray traversal"), so that no point of the ray falls between the sides.
struct PlaneTimes {
  double until, since;
};

/// A ray prepared for the times at which it crosses axis-aligned planes.
class PlaneRay {
 public:
  explicit PlaneRay(const Ray& ray) : origin_(ray.origin) {
    for (int axis = 0; axis < 3; ++axis) {
      inverse_[axis] = 1 / ray.direction[axis];
      backward_[static_cast<std::size_t>(axis)] = std::signbit(ray.direction[axis]);
    }
  }

  /// Whether the near side of a plane is the one of greater coordinates.
  bool backward(int axis) const { return backward_[static_cast<std::size_t>(axis)]; }

  /// Neither time is a number for a ray that runs within the plane: it is on both sides all the
  /// time, and so a time that is not a number must not cut anything off.
  PlaneTimes times(int axis, double plane) const {
    const double t = (plane - origin_[axis]) * inverse_[axis];
    const double margin = std::copysign(4 * std::numeric_limits<double>::epsilon(), t);
    return {t * (1 + margin), t * (1 - margin)};
  }

  /// The part of `inside` on the near side.
  static Interval near_part(Interval inside, const PlaneTimes& times) {
    if (times.until < inside.max) inside.max = times.until;
    return inside;
  }
  /// The part of `inside` on the far side.
  static Interval far_part(Interval inside, const PlaneTimes& times) {
    if (times.since > inside.min) inside.min = times.since;
    return inside;
  }

 private:
  Vec3 origin_, inverse_;
  std::array<bool, 3> backward_{};
};

}  // namespace dioptre
