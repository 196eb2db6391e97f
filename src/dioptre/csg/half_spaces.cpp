// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/half_spaces.h"

#include <algorithm>
#include <cmath>

namespace dioptre::csg {

void HalfSpaces::add(const HalfSpace& half, std::uint32_t leaf) {
  x_.push_back(half.normal.x);
  y_.push_back(half.normal.y);
  z_.push_back(half.normal.z);
  distance_.push_back(half.distance);
  leaves_.push_back(leaf);
}

bool HalfSpaces::clip(const Ray& ray, double margin, Interval& range,
                      std::vector<double>& times) const {
  // Below this angle to a face the place where it is crossed is too uncertain.
  constexpr double kGrazing = 1e-5;
  const Vec3 o = ray.origin, d = ray.direction;
  const double flat = kGrazing * (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z));
  times.resize(size());
  double enter = -kInfinity, exit = kInfinity;
  for (std::size_t i = 0; i < size(); ++i) {
    const double slope = x_[i] * d.x + y_[i] * d.y + z_[i] * d.z;
    const double height = x_[i] * o.x + y_[i] * o.y + z_[i] * o.z - distance_[i];
    const double t = std::fabs(slope) > flat ? -height / slope : NAN;
    times[i] = t;
    enter = slope < 0 && t > enter ? t : enter;
    exit = slope > 0 && t < exit ? t : exit;
  }
  range.min = std::max(range.min, enter - margin * (1 + std::fabs(enter)));
  range.max = std::min(range.max, exit + margin * (1 + std::fabs(exit)));
  return range.min <= range.max;
}

}  // namespace dioptre::csg
