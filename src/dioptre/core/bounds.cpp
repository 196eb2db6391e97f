// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/bounds.h"

#include <algorithm>
#include <limits>

namespace dioptre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;
constexpr double kGamma3 = 3 * kEpsilon / (1 - 3 * kEpsilon);

/// The product of a matrix entry and a coordinate, where 0 times infinity is 0.
double scaled(double entry, double coordinate) { return entry == 0 ? 0 : entry * coordinate; }

}  // namespace

Bounds unite(const Bounds& a, const Bounds& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

Bounds unite(const Bounds& a, Vec3 p) { return unite(a, Bounds{p, p}); }

Bounds intersect(const Bounds& a, const Bounds& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)}};
}

Bounds transform(const Bounds& b, const Affine& map) {
  if (b.empty()) return b;
  Bounds image{map.o, map.o};
  double size[3];
  for (int i = 0; i < 3; ++i) size[i] = std::fabs(map.o[i]);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 column = axis == 0 ? map.x : axis == 1 ? map.y : map.z;
    for (int i = 0; i < 3; ++i) {
      const double low = scaled(column[i], b.min[axis]), high = scaled(column[i], b.max[axis]);
      image.min[i] += std::min(low, high);
      image.max[i] += std::max(low, high);
      size[i] += std::max(std::fabs(low), std::fabs(high));
    }
  }
  // Room for the rounding of the sums above and of the points that will be mapped.
  for (int i = 0; i < 3; ++i) {
    const double slack = std::isfinite(size[i]) ? 8 * kEpsilon * size[i] : 0;
    image.min[i] = std::isnan(image.min[i]) ? -kInfinity : image.min[i] - slack;
    image.max[i] = std::isnan(image.max[i]) ? kInfinity : image.max[i] + slack;
  }
  return image;
}

Interval clip(const Bounds& b, const Ray& ray, Interval range) {
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], direction = ray.direction[axis];
    if (direction == 0) {
      if (!(b.min[axis] <= origin && origin <= b.max[axis])) return {};
      continue;
    }
    const double inverse = 1 / direction;
    double near = (b.min[axis] - origin) * inverse, far = (b.max[axis] - origin) * inverse;
    if (near > far) std::swap(near, far);
    // Both ends are moved outwards by the bound on their rounding errors; NaN changes nothing.
    near -= 2 * kGamma3 * std::fabs(near);
    far += 2 * kGamma3 * std::fabs(far);
    if (near > range.min) range.min = near;
    if (far < range.max) range.max = far;
    if (range.empty()) return {};
  }
  return range;
}

}  // namespace dioptre
