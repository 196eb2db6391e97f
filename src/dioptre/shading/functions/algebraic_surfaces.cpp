// SPDX-License-Identifier: Apache-2.0
// Classical algebraic surfaces (the equations are those of the literature); signs and constants are
// as measured from POV-Ray 3.7.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dioptre/shading/functions/internal_function_families.h"

namespace dioptre::internal_functions {
namespace {

constexpr double kLimit = 10;

double square(double v) { return v * v; }
double cube(double v) { return v * v * v; }

/// Field strength times value, held within the limit.
double field(const double* a, double value) {
  return std::min(std::max(a[3] * value, -kLimit), kLimit);
}

/// The quartic (s + k)^2 - 4 R^2 m of a torus with radii R, r and k = R^2 - r^2, negated.
double torus_quartic(const double* a, double s, double m) {
  const double k = square(a[4]) - square(a[5]);
  return field(a, 4 * square(a[4]) * m - square(s + k));
}

}  // namespace

double bicorn(const double* a) {
  const double y = a[1], r2 = square(a[0]) + square(a[2]), c = a[4];
  return field(a, square(y) * (square(c) - r2) - square(r2 + 2 * c * y - square(c)));
}

double bifolia(const double* a) {
  const double r2 = square(a[0]) + square(a[2]);
  return field(a, a[4] * r2 * a[1] - square(r2 + square(a[1])));
}

double boy_surface(const double* a) {
  // F. Apery, Models of the Real Projective Plane, 1987: the sextic of Boy's surface.
  constexpr double kRoot2 = std::numbers::sqrt2;
  const double x = a[0], y = a[1], z = a[2], c = 1 - z;
  const double x2 = x * x, y2 = y * y, z2 = z * z, r2 = x2 + y2, r4 = r2 * r2, z4 = z2 * z2;
  const double value =
      64 * cube(c * z) - 48 * square(c * z) * (3 * r2 + 2 * z2) +
      12 * c * z * (27 * r4 - 24 * z2 * r2 + 36 * kRoot2 * y * z * (y2 - 3 * x2) + 4 * z4) +
      (9 * r2 - 2 * z2) * (-81 * r4 - 72 * z2 * r2 + 108 * kRoot2 * x * z * (x2 - 3 * y2) + 4 * z4);
  return field(a, a[4] * value);
}

double crossed_trough(const double* a) { return field(a, square(a[0] * a[2]) - a[1]); }

double cubic_saddle(const double* a) { return field(a, cube(a[1]) - cube(a[0]) + a[2]); }

double cushion(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z = a[2], z2 = z * z;
  return field(
      a, x2 * z2 - square(z2) - square(x2 + y2) - y2 * z2 + 2 * z * (z2 + y2) - 2 * z2 + y2 + x2);
}

double devils_curve(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return field(a, y2 * (y2 - 0.25) + 0.36 * x2 - square(x2 + z2));
}

double dupin_cyclid(const double* a) {
  // The quartic of a torus (radii R and r, axis along y, centre X, Y, 0), inverted in a sphere.
  const double x = a[0], y = a[1], z = a[2], s = x * x + y * y + z * z;
  const double major2 = square(a[4]), tube = major2 - square(a[5]), k = square(a[8]);
  const double shift = square(a[6]) + square(a[7]);
  const double value = square(square(k) - 2 * k * (x * a[6] + y * a[7]) + s * (shift + tube)) -
                       4 * major2 * (square(k * x - a[6] * s) + square(k * z));
  return field(a, -(value + 8 * k * a[7] * y * s * tube));  // the last term: (measured)
}

double enneper(const double* a) {
  // Near the plane z = 0 the denominators stay away from it (measured).
  constexpr double kLeast = 0.2;
  const double z = a[2], w = std::abs(z) < kLeast ? kLeast : z;
  const double saddle = (square(a[1]) - square(a[0])) / (4 * w);
  return field(a, 6 * square(saddle) - cube(2 * saddle + 2 * z * z / 9));
}

double folium_surface(const double* a) {
  const double x = a[0], r2 = square(a[1]) + square(a[2]);
  return field(a, r2 + (1 + a[5]) * x * x - x * r2 * (4 * a[4] - a[5]));
}

double glob(const double* a) {
  const double x4 = square(square(a[0]));
  return field(a, 0.5 * x4 * (a[0] + 1) - square(a[1]) - square(a[2]));
}

double heart(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]), z3 = cube(a[2]);
  return field(a, (0.1 * x2 + y2) * z3 - cube(2 * x2 + y2 + z2 - 1));
}

double hunt_surface(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return field(a, -4 * cube(x2 + y2 + z2 - 13) - 27 * square(3 * x2 + y2 - 4 * z2 - 12));
}

double hyperbolic_torus(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return torus_quartic(a, x2 + y2 - z2, x2 - z2);
}

double kampyle_of_eudoxus(const double* a) {
  const double x2 = square(a[0]);
  return field(a, square(a[5]) * x2 * (x2 - square(a[4])) - square(a[1]) - square(a[2]));
}

double klein_bottle(const double* a) {
  const double x = a[0], y = a[1], z = a[2], s = x * x + y * y + z * z - 1, d = s - 2 * y;
  return field(a, (s + 2 * y) * (8 * z * z - d * d) - 16 * x * z * d);
}

double kummer_surface_v1(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return field(
      a, x2 * y2 + y2 * z2 + z2 * x2 - square(x2) - square(y2) - square(z2) + x2 + y2 + z2 - 1);
}

double kummer_surface_v2(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return field(a, 1 - square(x2) - square(y2) - square(z2) - a[4] * (x2 + y2 + z2) -
                      a[5] * (x2 * y2 + y2 * z2 + z2 * x2) - a[6] * a[0] * a[1] * a[2]);
}

double lemniscate_of_gerono(const double* a) {
  const double x2 = square(a[0]);
  return field(a, x2 * (1 - x2) - square(a[1]) - square(a[2]));
}

double mitre(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return field(a, y2 - 4 * x2 * (x2 + y2 + z2) - y2 * (y2 + z2));
}

double nodal_cubic(const double* a) { return field(a, 6 * a[1] * a[2] - cube(a[1]) - cube(a[2])); }

double odd(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z = a[2], z2 = z * z;
  return field(
      a, x2 * z2 - square(z2) - square(x2 + y2) - y2 * z2 + 2 * z * (z2 + y2) - 2 * z2 + y2 + x2);
}

double ovals_of_cassini(const double* a) {
  const double r2 = square(a[0]) + square(a[2]), k = square(a[4]);
  return field(a, a[6] * k * r2 + square(a[5]) - square(r2 + square(a[1]) + k));
}

double paraboloid(const double* a) { return field(a, a[1] - square(a[0]) - square(a[2])); }

double parabolic_torus(const double* a) {
  const double x2 = square(a[0]), s = x2 + square(a[1]) - a[2];
  const double k = square(a[4]) - square(a[5]);
  return field(a, 2 * square(a[4]) * (x2 - a[2]) - s * (s + k) - k * k);
}

double pillow(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return field(a, x2 * (x2 - 1) + y2 * (y2 - 1) + z2 * (z2 - 1));
}

double piriform(const double* a) {
  return field(a, cube(a[0]) * (a[0] - 1) + square(a[1]) + square(a[2]));
}

double quartic_paraboloid(const double* a) {
  return field(a, a[1] - square(square(a[0])) - square(square(a[2])));
}

double quartic_saddle(const double* a) {
  return field(a, a[1] + square(square(a[2])) - square(square(a[0])));
}

double quartic_cylinder(const double* a) {
  const double r2 = square(a[0]) + square(a[2]), width = square(a[5]);
  return field(a, square(a[4]) * width - r2 * (square(a[1]) + width));
}

double steiners_roman(const double* a) {
  const double x = a[0], y = a[1], z = a[2];
  return field(a, -square(x * y) - square(y * z) - square(z * x) - x * y * z);
}

double strophoid(const double* a) {
  const double x = a[0];
  return field(a, (x - a[5]) * (square(a[1]) + square(a[2])) + square(a[6] * x) * (x + a[4]));
}

double torus2(const double* a) {
  const double r2 = square(a[0]) + square(a[2]);
  return torus_quartic(a, r2 + square(a[1]), r2);
}

double torus_gumdrop(const double* a) {
  const double x2 = square(a[0]), r2 = square(a[1]) + square(a[2]);
  return field(a, 20 * (x2 + r2) - 4 * square(x2) - 4 * square(r2) - 17 * (x2 * r2 + 1));
}

double umbrella(const double* a) { return field(a, a[1] * square(a[2]) - square(a[0])); }

double witch_of_agnesi(const double* a) {
  const double r2 = square(a[0]) + square(a[2]);
  return field(a, a[4] * (1 - a[1]) - a[1] * r2);
}

}  // namespace dioptre::internal_functions
