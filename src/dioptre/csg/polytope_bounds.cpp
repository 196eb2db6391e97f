// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/polytope_bounds.h"

#include <algorithm>
#include <cmath>

namespace dioptre::csg {
namespace {

constexpr std::size_t kMost = 24;
constexpr double kTolerance = 1e-12;  ///< of sums of unit vectors
constexpr double kMargin = 1e-9;      ///< of coordinates

/// A half-space with a unit normal.
struct Side {
  Vec3 normal;
  double distance;
};

/// The bound on dot(p, direction) that a sum of half-spaces with these weights gives; infinity if
/// it gives none.
double bound_by(std::span<const Side* const> sides, std::span<const double> weights,
                Vec3 direction) {
  Vec3 sum;
  double bound = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!(weights[i] >= 0)) return kInfinity;
    sum += weights[i] * sides[i]->normal;
    bound += weights[i] * sides[i]->distance;
  }
  return max_component(abs(sum - direction)) <= kTolerance ? bound : kInfinity;
}

double bound_by(const Side& a, Vec3 direction) {
  const Side* const sides[] = {&a};
  const double weights[] = {1};
  return bound_by(sides, weights, direction);
}

double bound_by(const Side& a, const Side& b, Vec3 direction) {
  const double c = dot(a.normal, b.normal), det = 1 - c * c;
  const double u = dot(a.normal, direction), v = dot(b.normal, direction);
  const Side* const sides[] = {&a, &b};
  const double weights[] = {(u - c * v) / det, (v - c * u) / det};
  return bound_by(sides, weights, direction);
}

double bound_by(const Side& a, const Side& b, const Side& c, Vec3 direction) {
  const Vec3 bc = cross(b.normal, c.normal), ca = cross(c.normal, a.normal),
             ab = cross(a.normal, b.normal);
  const double det = dot(a.normal, bc);
  const Side* const sides[] = {&a, &b, &c};
  const double weights[] = {dot(direction, bc) / det, dot(direction, ca) / det,
                            dot(direction, ab) / det};
  return bound_by(sides, weights, direction);
}

/// The least bound that one, two or three of the half-spaces give.
double greatest(std::span<const Side> sides, Vec3 direction) {
  double least = kInfinity;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    least = std::min(least, bound_by(sides[i], direction));
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      least = std::min(least, bound_by(sides[i], sides[j], direction));
      for (std::size_t k = j + 1; k < sides.size(); ++k) {
        least = std::min(least, bound_by(sides[i], sides[j], sides[k], direction));
      }
    }
  }
  return least;
}

}  // namespace

Bounds polytope_bounds(std::span<const PlacedHalfSpace> half_spaces) {
  std::vector<Side> sides;
  for (const PlacedHalfSpace& half : half_spaces) {
    const double size = length(half.normal);
    if (size > 0 && std::isfinite(size) && sides.size() < kMost) {
      sides.push_back({half.normal / size, half.distance / size});
    }
  }
  if (sides.size() < 4) return Bounds::all();  // no fewer hold a finite part of space
  Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 direction;
    direction[axis] = 1;
    box.max[axis] = greatest(sides, direction);
    box.min[axis] = -greatest(sides, -direction);
  }
  if (!is_finite(box.min) || !is_finite(box.max)) return Bounds::all();
  const double size = std::max(max_component(abs(box.min)), max_component(abs(box.max)));
  const Vec3 margin{kMargin * size, kMargin * size, kMargin * size};
  return {box.min - margin, box.max + margin};
}

}  // namespace dioptre::csg
