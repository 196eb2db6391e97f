// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/sphere_volume.h"

#include <algorithm>

namespace dioptre {

SphereVolume::SphereVolume(Items items) {
  const Bounds box = bounds_of(items);
  center_ = 0.5 * box.min + 0.5 * box.max;
  double farthest = 0;
  for (const BoxedItem& each : items) {
    const Vec3 low = abs(each.box.min - center_), high = abs(each.box.max - center_);
    const Vec3 corner{std::max(low.x, high.x), std::max(low.y, high.y), std::max(low.z, high.z)};
    farthest = std::max(farthest, length_squared(corner));
  }
  // The padding covers the rounding of all this, but for numbers so small that they underflow.
  constexpr double kSmallest = 1e-290;
  padded_squared_ = farthest * (1 + kPadding) + kSmallest;
}

SphereVolume::Probe::Probe(const Ray& ray)
    : origin_(ray.origin),
      direction_(ray.direction),
      squared_(length_squared(ray.direction)),
      inverse_squared_(1 / squared_),
      exact_(squared_ > 1e-100 && squared_ < 1e100) {}

}  // namespace dioptre
