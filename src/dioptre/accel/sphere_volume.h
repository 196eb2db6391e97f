// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>

#include "dioptre/accel/box_set.h"
#include "dioptre/core/ray.h"

namespace dioptre {

/// A bounding sphere, for a VolumeHierarchy (Whitted 1980, "An improved illumination model for
/// shaded display": the first bounding volumes).
class SphereVolume {
 public:
  using Items = std::span<const BoxedItem>;
  /// Around the middle of the items' box, as small as their boxes' corners allow.
  explicit SphereVolume(Items items);
  bool contains(Vec3 p) const { return length_squared(p - center_) <= padded_squared_; }

  /// A ray prepared for tests.
  class Probe {
   public:
    explicit Probe(const Ray& ray);

    /// The distance of the center from the ray's line is |center x direction| / |direction|. The
    /// radius is first enlarged by the rounding error e of the center as seen from the origin:
    /// (r + e)^2 <= r^2 (1 + d) + e^2 (1 + 1 / d) with d = kPadding. What is not a number meets.
    bool meets(const SphereVolume& volume, const Interval& range, double& entry) const {
      const Vec3 center = volume.center_ - origin_;
      const double radius_squared = volume.padded_squared_ + kSeenError * length_squared(center);
      const double half_chord_squared =
          radius_squared * squared_ - length_squared(cross(center, direction_));
      if (half_chord_squared < 0 && exact_) return false;
      const double middle = dot(center, direction_) * inverse_squared_;
      const double half = exact_ ? std::sqrt(half_chord_squared) * inverse_squared_ : kInfinity;
      const double begin = middle - half, end = middle + half;
      entry = begin > range.min ? begin : range.min;
      return !((end < range.max ? end : range.max) < entry);
    }

   private:
    Vec3 origin_, direction_;
    double squared_, inverse_squared_;
    /// Whether the direction's square neither overflows nor underflows.
    bool exact_;
  };

 private:
  static constexpr double kPadding = 1e-6;
  /// e = 8 epsilon times the center's distance; squared, times 1 + 1 / kPadding.
  static constexpr double kSeenError = 4e-24;

  Vec3 center_;
  /// The radius squared, times 1 + kPadding.
  double padded_squared_;
};

}  // namespace dioptre
