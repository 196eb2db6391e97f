// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/geometry/superellipsoid/gauge.h"
#include "dioptre/geometry/superellipsoid/stretch.h"

namespace dioptre {

/// Finds where a line meets a superellipsoid that is not convex.
///
/// A point is inside where g(x, y) <= h(z), with g = (|x|^p + |y|^p)^(1/p) and
/// h = (1 - |z|^q)^(1/q). Within an octant g is convex for p >= 1 and concave for p <= 1, and h the
/// other way round by q; so g - h is the difference of two convex functions u and v of the line's
/// parameter. Chords and tangents at the ends of a piece bound them, and the slopes at the ends
/// bound their slopes: a piece is left out where u - v cannot vanish, taken as it is where u - v
/// only rises or only falls, and halved else.
class PinchedSearch {
 public:
  PinchedSearch(const SuperellipsoidGauge& gauge, const BoxStretch& stretch, StretchRoots& roots);

  /// Searches the whole stretch.
  void run();

 private:
  /// u and v with their slopes; a slope may be infinite or NaN, and then bounds nothing.
  struct Sample {
    double s = 0, u = 0, u_slope = 0, v = 0, v_slope = 0;
    bool inside() const { return u <= v; }
  };

  void search_octant(double low, double high);
  Sample sample(double s, Vec3 signs) const;
  void search(const Sample& a, const Sample& b, Vec3 signs, int depth);
  void add_root(double low, double high, bool inside_low);

  const SuperellipsoidGauge& gauge_;
  const BoxStretch& stretch_;
  StretchRoots& roots_;
  int left_ = 400;  ///< pieces that may still be halved
};

}  // namespace dioptre
