// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "dioptre/core/ray.h"
#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A ray turned so that it looks along the third axis: what is the same for all its triangles.
/// (Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2013.)
class TriangleRay {
 public:
  explicit TriangleRay(const Ray& ray) : ray_(ray) {
    const Vec3 size = abs(ray.direction);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_x_ = ray.direction[x_] / ray.direction[z_];
    shear_y_ = ray.direction[y_] / ray.direction[z_];
  }

  const Ray& ray() const { return ray_; }
  /// Where p lies when looking along the ray, which is at 0. Depends on p and the ray only.
  Vec2 project(Vec3 p) const {
    const Vec3 q = p - ray_.origin;
    return {q[x_] - shear_x_ * q[z_], q[y_] - shear_y_ * q[z_]};
  }

 private:
  Ray ray_;
  std::size_t x_, y_, z_;
  double shear_x_, shear_y_;
};

/// What a hit of a triangle (a, b, c) yields: the point is (1-v-w) a + v b + w c.
struct TriangleHit {
  double t = 0, error = 0;
  double v = 0, w = 0;
  bool front = false;  ///< the ray goes against the normal, cross(c - a, b - a)
};

/// The hit as a crossing of the shape whose face the triangle is: u and v are the hit's v and w.
inline Crossing crossing_of(const TriangleHit& hit, std::uint32_t face) {
  Crossing crossing;
  crossing.t = hit.t;
  crossing.error = hit.error;
  crossing.face = face;
  crossing.u = hit.v;
  crossing.v = hit.w;
  crossing.entering = hit.front;
  return crossing;
}

/// The sign of cross(a, b), exact whatever the rounding, and never 0 for a != b: a point on an
/// edge counts as on the side it goes to when the ray is moved a little along +x, and less along
/// +y. So all triangles around an edge or a corner agree on which of them the ray hits.
inline int edge_side(Vec2 a, Vec2 b) {
  const double p = a.x * b.y, q = a.y * b.x;
  const double difference = p - q;
  if (std::fabs(difference) > 4e-16 * (std::fabs(p) + std::fabs(q))) return difference > 0 ? 1 : -1;
  const double exact = difference + (std::fma(a.x, b.y, -p) - std::fma(a.y, b.x, -q));
  if (exact != 0) return exact > 0 ? 1 : -1;
  if (a.y != b.y) return a.y > b.y ? 1 : -1;
  if (a.x != b.x) return b.x > a.x ? 1 : -1;
  return 0;
}

/// Whether the ray's line goes through the triangle; t is not looked at.
inline bool line_meets_triangle(const TriangleRay& ray, Vec3 a, Vec3 b, Vec3 c) {
  const Vec2 pa = ray.project(a), pb = ray.project(b), pc = ray.project(c);
  const int ab = edge_side(pa, pb);
  return ab != 0 && edge_side(pb, pc) == ab && edge_side(pc, pa) == ab;
}

/// Where the line, which goes through the triangle, does so. For one seen from the side, or without
/// area, t is still between those of its corners.
inline TriangleHit triangle_hit(const TriangleRay& ray, Vec3 a, Vec3 b, Vec3 c) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;
  const Vec3 o = ray.ray().origin, d = ray.ray().direction;
  const Vec3 e1 = b - a, e2 = c - a, to_a = a - o;
  const Vec3 n = cross(e2, e1);
  const double slope = dot(n, d);
  double t = dot(n, to_a) / slope;
  // Once more from the point found: the first quotient's errors grow with the distance.
  const Vec3 rest = to_a - t * d;
  t += dot(n, rest) / slope;
  const Vec3 size = abs(to_a) + std::fabs(t) * abs(d);
  const Vec3 s1 = abs(e1), s2 = abs(e2);
  const Vec3 normal_error{s1.y * s2.z + s1.z * s2.y, s1.z * s2.x + s1.x * s2.z,
                          s1.x * s2.y + s1.y * s2.x};
  TriangleHit hit;
  hit.error = kEpsilon * (4 * dot(abs(n), size) + 8 * dot(normal_error, abs(rest) + s1 + s2)) /
                  std::fabs(slope) +
              2 * kEpsilon * std::fabs(t);
  hit.front = slope < 0;

  const double squared = dot(d, d);
  const double ta = dot(to_a, d) / squared;
  const double tb = ta + dot(e1, d) / squared, tc = ta + dot(e2, d) / squared;
  const double low = std::fmin(ta, std::fmin(tb, tc)), high = std::fmax(ta, std::fmax(tb, tc));
  const double spread = high - low + 8 * kEpsilon * std::fmax(std::fabs(low), std::fabs(high));
  if (!(hit.error < spread)) hit.error = spread;
  hit.t = std::isfinite(t) ? std::fmin(std::fmax(t, low - spread), high + spread) : low;

  const Vec2 pa = ray.project(a), pb = ray.project(b), pc = ray.project(c);
  const double on_b = cross(pc, pa), on_c = cross(pa, pb);
  const double all = cross(pb, pc) + on_b + on_c;
  hit.v = all != 0 ? std::fmin(std::fmax(on_b / all, 0), 1) : 0;
  hit.w = all != 0 ? std::fmin(std::fmax(on_c / all, 0), 1 - hit.v) : 0;
  return hit;
}

/// Whether the corners span no plane.
inline bool degenerate(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 n = cross(b - a, c - a);
  return !is_finite(n) || n == Vec3{};
}

}  // namespace dioptre
