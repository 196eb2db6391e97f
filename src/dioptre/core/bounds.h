// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/affine.h"
#include "dioptre/core/interval.h"
#include "dioptre/core/vec.h"

namespace dioptre {

/// An axis-aligned box; any side may be infinite. The default is empty.
struct Bounds {
  Vec3 min{kInfinity, kInfinity, kInfinity}, max{-kInfinity, -kInfinity, -kInfinity};

  static constexpr Bounds all() {
    return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
  }
  constexpr bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  bool finite() const { return is_finite(min) && is_finite(max); }
  constexpr Vec3 center() const { return 0.5 * (min + max); }
  constexpr Vec3 extent() const { return max - min; }
  /// Half the surface area; 0 when empty.
  constexpr double half_area() const {
    if (empty()) return 0;
    const Vec3 e = extent();
    return e.x * e.y + e.y * e.z + e.z * e.x;
  }
  constexpr bool contains(Vec3 p) const {
    return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y && min.z <= p.z &&
           p.z <= max.z;
  }
  bool operator==(const Bounds&) const = default;
};

Bounds unite(const Bounds& a, const Bounds& b);
Bounds unite(const Bounds& a, Vec3 p);
Bounds intersect(const Bounds& a, const Bounds& b);
/// A box that holds the image of `b` under `map`; infinite sides stay infinite where they must.
Bounds transform(const Bounds& b, const Affine& map);
/// The part of `range` in which the ray may be inside `b`: never too small (Ize, "Robust BVH Ray
/// Traversal", JCGT 2013: the exit is widened by 2 gamma_3). Empty if the ray misses.
Interval clip(const Bounds& b, const Ray& ray, Interval range);

}  // namespace dioptre
