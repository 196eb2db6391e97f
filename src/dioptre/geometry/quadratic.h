// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/convex.h"

namespace dioptre {

/// The real roots of a t^2 + 2 b t + c, the smaller first.
struct QuadraticRoots {
  int count = 0;
  double t[2] = {};
  double a, b, c_error;  ///< c_error bounds the rounding of c

  /// A bound on the error of a root.
  double error(int i) const {
    const double slope = 2 * std::fabs(a * t[i] + b);
    const double residual =
        8 * kRounding * (std::fabs(a) * t[i] * t[i] + 2 * std::fabs(b * t[i])) + c_error;
    const double rounding = 4 * kRounding * std::fabs(t[i]);
    // Where the slope is flat, the second order counts.
    if (residual * std::fabs(a) < slope * slope) return residual / slope + rounding;
    const double flat = std::sqrt(residual / std::max(std::fabs(a), 1e-300));
    return slope > 0 ? std::min(residual / slope, flat) + rounding : flat;
  }
};

/// `scale_c` bounds the terms that c was summed from: c is off by a few roundings of it. The
/// numerically stable form (W. Kahan): q = -(b + sign(b) sqrt(b^2 - a c)), t = q/a and c/q.
/// Roots that the arithmetic cannot tell from a tangent may be missing.
inline QuadraticRoots quadratic_roots(double a, double b, double c, double scale_c) {
  QuadraticRoots roots{.a = a, .b = b, .c_error = 8 * kRounding * (std::fabs(c) + scale_c)};
  const auto one = [&](double t) {
    roots.count = 1;
    roots.t[0] = t;
    return roots;
  };
  if (a == 0) return b == 0 ? roots : one(-c / (2 * b));
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0)) return roots;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double t0 = q / a, t1 = q != 0 ? c / q : 0;
  // One root may have gone to infinity: the other is that of the linear equation.
  if (!std::isfinite(t1)) return roots;
  if (!std::isfinite(t0)) return one(t1);
  roots.count = 2;
  roots.t[0] = std::min(t0, t1), roots.t[1] = std::max(t0, t1);
  return roots;
}

/// The ray parameter at which a ray comes closest to a point: solving from there keeps the
/// coefficients small however far away the ray begins.
inline double closest_approach(const Ray& ray, Vec3 point) {
  const double squared = dot(ray.direction, ray.direction);
  return squared > 0 ? dot(point - ray.origin, ray.direction) / squared : 0;
}

/// What moving the origin by `shift` along the ray costs: the error of a parameter t relative to
/// the moved origin, from the rounding of that origin.
inline double shift_error(const Ray& ray, double shift) {
  const double size =
      max_component(abs(ray.origin)) + std::fabs(shift) * max_component(abs(ray.direction));
  const double speed = length(ray.direction);
  return speed > 0 ? 4 * kRounding * size / speed : 0;
}

}  // namespace dioptre
