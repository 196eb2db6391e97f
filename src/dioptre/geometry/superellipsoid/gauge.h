// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/superellipsoid/power_norm.h"

namespace dioptre {

/// N(p) = ((|x|^p + |y|^p)^(q/p) + |z|^q)^(1/q): homogeneous, and 1 on the surface of the
/// superellipsoid with e = 2/p and n = 2/q.
class SuperellipsoidGauge {
 public:
  PowerNorm flat, upright;

  SuperellipsoidGauge(double p, double q) : flat(p), upright(q) {}

  bool convex() const { return flat.convex() && upright.convex(); }

  double value(Vec3 p) const {
    return upright.value(flat.value(std::fabs(p.x), std::fabs(p.y)), std::fabs(p.z));
  }

  /// The gradient at p, which sets the value too.
  Vec3 gradient(Vec3 p, double& value) const {
    const Jet<double> jet = this->jet(std::fabs(p.x), std::fabs(p.y), std::fabs(p.z));
    value = jet.value;
    return {std::copysign(jet.x, p.x), std::copysign(jet.y, p.y), std::copysign(jet.z, p.z)};
  }
  /// Value and slope along d, to about six digits.
  void rough_slope(Vec3 p, Vec3 d, double& value, double& slope) const {
    const Jet<float> jet =
        this->jet(static_cast<float>(std::fabs(p.x)), static_cast<float>(std::fabs(p.y)),
                  static_cast<float>(std::fabs(p.z)));
    value = jet.value;
    slope = std::copysign(jet.x, p.x) * d.x + std::copysign(jet.y, p.y) * d.y +
            std::copysign(jet.z, p.z) * d.z;
  }

 private:
  template <class Real>
  struct Jet {
    Real value, x, y, z;
  };
  template <class Real>
  Jet<Real> jet(Real x, Real y, Real z) const {
    const auto in_plane = flat.jet(x, y);
    const auto all = upright.jet(in_plane.value, z);
    return {all.value, all.by_a * in_plane.by_a, all.by_a * in_plane.by_b, all.by_b};
  }
};

}  // namespace dioptre
