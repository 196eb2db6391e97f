// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/quadric/quadric_bounds.h"

#include <cmath>

namespace dioptre {
namespace {

/// Room for the rounding of the bounds, relative to their size.
constexpr double kRoom = 0x1p-46;

void bound_axis(Bounds& box, std::size_t axis, double middle, double reach) {
  const double room = kRoom * (std::fabs(middle) + reach);
  if (!std::isfinite(room)) return;
  box.min[axis] = middle - reach - room;
  box.max[axis] = middle + reach + room;
}

/// The sum over the axes of s x^2 + l x is at most `level`. An axis with s > 0 is bounded if no
/// other axis can lower the sum without end; one with only l ends where the others are lowest.
Bounds aligned_bounds(const Quadric& q) {
  Bounds box = Bounds::all();
  double level = -q.constant, terms = std::fabs(q.constant);
  int linear_axes = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double s = q.squares[axis], l = q.linear[axis];
    if (s < 0) return box;
    if (s > 0) level += l * l / (4 * s), terms += l * l / (4 * s);
    linear_axes += s == 0 && l != 0;
  }
  if (linear_axes > 1) return box;
  if (!std::isfinite(terms)) return box;
  level += kRoom * terms;
  if (linear_axes == 0 && level < 0) return {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double s = q.squares[axis], l = q.linear[axis];
    if (s > 0 && linear_axes == 0) {
      bound_axis(box, axis, -l / (2 * s), std::sqrt(level / s));
    } else if (s == 0 && l != 0) {
      const double end = level / l + std::copysign(kRoom * std::fabs(level / l), l);
      if (std::isfinite(end)) (l > 0 ? box.max : box.min)[axis] = end;
    }
  }
  return box;
}

/// p^T A p + 2 b p + c <= 0 with a positive definite A reaches sqrt(level (A^-1)_ii) from the
/// centre -A^-1 b along axis i.
Bounds ellipsoid_bounds(const Quadric& q) {
  const Vec3 p = 0.5 * q.products, b = 0.5 * q.linear;
  const Vec3 x{q.squares.x, p.x, p.y}, y{p.x, q.squares.y, p.z}, z{p.y, p.z, q.squares.z};
  const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  const double determinant = dot(x, yz);
  const double size = max_component(abs(q.squares)) + max_component(abs(p));
  // Sylvester's criterion, with a margin that keeps the inverse accurate.
  const bool definite =
      x.x > 0 && xy.z > 0x1p-20 * size * size && determinant > 0x1p-20 * size * size * size;
  if (!definite || !std::isfinite(determinant)) return Bounds::all();
  const Vec3 to_center = (b.x * yz + b.y * zx + b.z * xy) / determinant;
  const double lowered = dot(b, to_center), terms = std::fabs(lowered) + std::fabs(q.constant);
  const double level = lowered - q.constant + 0x1p-24 * terms;
  if (level < 0) return {};
  Bounds box = Bounds::all();
  const Vec3 inverse_diagonal = Vec3{yz.x, zx.y, xy.z} / determinant;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double reach = std::sqrt(level * inverse_diagonal[axis]) * (1 + 0x1p-24);
    bound_axis(box, axis, -to_center[axis], reach + 0x1p-24 * std::fabs(to_center[axis]));
  }
  return box;
}

/// The least value of s x^2 + l x for x in [low, high].
double least(double s, double l, double low, double high) {
  const auto term = [&](double x) { return (s == 0 ? 0 : s * x * x) + (l == 0 ? 0 : l * x); };
  if (s > 0) {
    const double x = std::fmin(std::fmax(-l / (2 * s), low), high);
    return term(x);
  }
  return std::fmin(term(low), term(high));
}

}  // namespace

Bounds quadric_bounds_within(const Quadric& q, const Bounds& region) {
  Bounds box = intersect(quadric_bounds(q), region);
  if (q.products != Vec3{} || box.empty()) return box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double s = q.squares[axis], l = q.linear[axis];
    if (s < 0 || (s == 0 && l == 0)) continue;
    double level = -q.constant, terms = std::fabs(q.constant);
    for (std::size_t other = 0; other < 3; ++other) {
      if (other == axis) continue;
      const double part = least(q.squares[other], q.linear[other], box.min[other], box.max[other]);
      level -= part;
      terms += std::fabs(part);
    }
    if (!std::isfinite(terms)) continue;
    level += kRoom * terms;
    Bounds bounded = Bounds::all();
    if (s > 0) {
      const double squared = level / s + l * l / (4 * s * s);
      if (squared < 0) return {};
      bound_axis(bounded, axis, -l / (2 * s), std::sqrt(squared));
    } else {
      const double end = level / l;
      (l > 0 ? bounded.max : bounded.min)[axis] = end + std::copysign(kRoom * std::fabs(end), l);
    }
    box = intersect(box, bounded);
    if (box.empty()) return {};
  }
  return box;
}

Bounds quadric_bounds(const Quadric& q) {
  return q.products == Vec3{} ? aligned_bounds(q) : ellipsoid_bounds(q);
}

}  // namespace dioptre
