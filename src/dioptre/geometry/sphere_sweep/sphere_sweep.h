// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// How the spheres of a sweep make a path (as in a scene file).
enum class SphereSweepSpline : std::uint8_t {
  kLinear,   ///< straight from sphere to sphere. At least 2 spheres
  kBSpline,  ///< the uniform cubic B-spline of all, near them. At least 4
  kCubic,    ///< Catmull-Rom through all but the first and the last. At least 4
};

/// The space that a sphere of varying radius fills while its centre moves along a path.
struct SphereSweep {
  static constexpr const char* kName = "sphere_sweep";

  struct Sphere {
    Vec3 center;
    double radius = 1;
    bool operator==(const Sphere&) const = default;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit) {
      visit("center", self.center);
      visit("radius", self.radius);
    }
  };

  SphereSweepSpline spline = SphereSweepSpline::kLinear;
  std::vector<Sphere> spheres;
  double tolerance = 1e-6;  ///< kept for scene files; the surface is found exactly

  bool operator==(const SphereSweep&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("spline", self.spline);
    visit("spheres", self.spheres);
    visit("tolerance", self.tolerance);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for too few
/// spheres, or a number that is not finite.
Result<ShapePtr> prepare(const SphereSweep& sweep);

}  // namespace dioptre
