// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dioptre/core/ray.h"
#include "dioptre/core/vec.h"

namespace dioptre {

/// An affine map, as the images of the three axes and of the origin: p -> p.x*x + p.y*y + p.z*z +
/// o. These are the four rows of a scene file's `matrix`.
struct Affine {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, o{0, 0, 0};

  constexpr Vec3 point(Vec3 p) const { return p.x * x + p.y * y + p.z * z + o; }
  constexpr Vec3 vector(Vec3 v) const { return v.x * x + v.y * y + v.z * z; }
  /// The transpose of the linear part applied to v. A normal goes to the target space of a map by
  /// the inverse map's `covector` (not normalised).
  constexpr Vec3 covector(Vec3 v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  constexpr Ray ray(const Ray& r) const { return {point(r.origin), vector(r.direction)}; }
  constexpr double determinant() const { return dot(x, cross(y, z)); }
  bool operator==(const Affine&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
    visit("o", self.o);
  }
};

/// First a, then b.
constexpr Affine then(const Affine& a, const Affine& b) {
  return {b.vector(a.x), b.vector(a.y), b.vector(a.z), b.point(a.o)};
}

/// The inverse map, or nothing if the map is singular or not finite.
std::optional<Affine> inverse(const Affine& a);

Affine translation(Vec3 by);
/// Scaling about the origin.
Affine scaling(Vec3 by);
/// Turns about x, then y, then z, by degrees, left-handed (y to z, z to x, x to y).
Affine rotation(Vec3 degrees);
/// A left-handed turn by `degrees` about an axis through the origin (need not be unit, not zero).
Affine axis_rotation(Vec3 axis, double degrees);

/// A map together with its inverse: what rendering needs to place an object or a texture.
struct Placement {
  Affine to_world, to_object;
};

}  // namespace dioptre
