// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/lathe/lathe_curves.h"
#include "dioptre/geometry/outline/bernstein.h"
#include "dioptre/geometry/quadratic.h"

namespace dioptre {

/// The square of a polynomial.
template <std::size_t N>
Bernstein<2 * N> squared(const Bernstein<N>& p) {
  static_assert(N <= 3);
  if constexpr (N == 1) {
    return {p[0] * p[0], p[0] * p[1], p[1] * p[1]};
  } else if constexpr (N == 2) {
    return {p[0] * p[0], p[0] * p[1], (p[0] * p[2] + 2 * p[1] * p[1]) / 3, p[1] * p[2],
            p[2] * p[2]};
  } else {
    return {p[0] * p[0],
            p[0] * p[1],
            (2 * p[0] * p[2] + 3 * p[1] * p[1]) / 5,
            (p[0] * p[3] + 9 * p[1] * p[2]) / 10,
            (2 * p[1] * p[3] + 3 * p[2] * p[2]) / 5,
            p[2] * p[3],
            p[3] * p[3]};
  }
}

/// Whether a line outwards from a point (distance from the axis, height) crosses the curve, or its
/// mirror image behind the axis, an odd number of times.
bool odd_number_outwards(const Curve& curve, Vec2 from);

/// Where a ray goes through a revolved curve.
struct MeridianCrossing {
  double s = 0;         ///< on the curve
  double distance = 0;  ///< along the ray, from the point it was given by
  double error = 0;     ///< a bound on that of the distance
};

/// A ray seen in the turning plane through the y axis and its points: the hyperbola
/// radius^2 = miss^2 + along^2, along = at_origin + level * distance,
/// y = height + climb * distance, where level^2 + climb^2 = 1.
class Meridian {
 public:
  /// The direction has length 1; the origin may be off by `misplaced`.
  Meridian(Vec3 origin, Vec3 direction, double misplaced);

  /// False if the ray passes by a cylinder around the piece, or through the hole of the piece.
  bool may_meet(const LatheCurve& piece) const;

  /// Calls sink(const MeridianCrossing&) for each crossing. Pieces that join at a point agree on
  /// its side, so that the number of crossings of a closed outline is even.
  template <class Sink>
  void cross(const LatheCurve& piece, Sink&& sink) const {
    switch (piece.curve.degree) {
      case 1:
        return cross_degree<1>(piece.curve, sink);
      case 2:
        return cross_degree<2>(piece.curve, sink);
      default:
        return cross_degree<3>(piece.curve, sink);
    }
  }

 private:
  /// A ray as level as this is first taken as level: the two sides of a ring then are one root.
  static constexpr double kLevel = 2e-6;

  template <std::size_t N, class Sink>
  void cross_degree(const Curve& curve, Sink&& sink) const {
    Bernstein<N> x, above;
    for (std::size_t i = 0; i <= N; ++i) {
      x[i] = curve.points[i].x;
      above[i] = curve.points[i].y - height_;
    }
    if (std::fabs(climb_) < kLevel) return cross_level<N>(curve, above, sink);
    for (double& a : above) a = level_ * a + climb_ * at_origin_;
    // climb^2 (x^2 - radius^2) of the ray at the curve's height.
    const Bernstein<2 *N> own = squared<N>(x), ray = squared<N>(above);
    Bernstein<2 * N> within;
    const double climb2 = climb_ * climb_, miss2 = climb2 * miss_ * miss_;
    for (std::size_t i = 0; i <= 2 * N; ++i) within[i] = climb2 * own[i] - miss2 - ray[i];
    const SignChanges<2 * N> changes = sign_changes<2 * N>(within);
    for (std::size_t i = 0; i < changes.count; ++i) {
      const double s = changes.at[i].s;
      sink(polished(curve, s, (curve.at(s).y - height_) / climb_));
    }
  }

  template <std::size_t N, class Sink>
  void cross_level(const Curve& curve, const Bernstein<N>& above, Sink&& sink) const {
    const SignChanges<N> changes = sign_changes<N>(above);
    for (std::size_t i = 0; i < changes.count; ++i) {
      const double s = changes.at[i].s, x = curve.at(s).x;
      const double half = x * x - miss_ * miss_;
      if (!(half > 0)) continue;
      const double along = std::sqrt(half);
      sink(polished(curve, s, (-along - at_origin_) / level_));
      sink(polished(curve, s, (along - at_origin_) / level_));
    }
  }

  /// Newton's iteration in both unknowns, which is well conditioned where the polynomial is not.
  MeridianCrossing polished(const Curve& curve, double s, double distance) const;

  double height_, climb_, level_, at_origin_, miss_, misplaced_;
};

}  // namespace dioptre
