// SPDX-License-Identifier: Apache-2.0
// Tubes wound about an axis or a circle. The formulas are geometry; where they begin, which way
// they turn and how they are cut off is as measured from POV-Ray 3.7.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dioptre/shading/functions/internal_function_families.h"

namespace dioptre::internal_functions {
namespace {

constexpr double kPi = std::numbers::pi;

double square(double v) { return v * v; }

double axis_distance(const double* a) { return std::sqrt(square(a[0]) + square(a[2])); }

/// The angle within -pi and pi.
double wrapped(double angle) { return angle - 2 * kPi * std::floor(angle / (2 * kPi) + 0.5); }

/// The size of a section (a superellipse) through u, v. Type 0 is a square, 1 a circle, 2 a
/// diamond, above that it is concave. At most |u| + |v| for types up to 2.
double section(double u, double v, double type) {
  u = std::abs(u), v = std::abs(v);
  if (type == 0) return std::max(u, v);
  if (type == 1) return std::sqrt(u * u + v * v);
  const double exponent = 2 / type;
  return std::pow(std::pow(u, exponent) + std::pow(v, exponent), 1 / exponent);
}

}  // namespace

double helix_1(const double* a) {
  // a[3] tubes of radius a[5] at a[6] from the axis, a[4] radians per unit of height; a[7]
  // stretches them in y, a[8] is the section's type and a[9] turns it, in degrees.
  const double r = axis_distance(a), turns = a[3];
  const double angle = wrapped(turns * (a[4] * a[1] + std::atan2(a[2], a[0])) + kPi);
  const double u = r - a[6], v = angle / (turns * a[4]) / a[7];
  const double turned = a[9] * kPi / 180, c = std::cos(turned), s = std::sin(turned);
  return std::min(r + a[6], section(u * c - v * s, u * s + v * c, a[8])) - a[5];
}

double helix_2(const double* a) {
  // One tube of radius a[5] whose centre is always in the plane y, a[6] from the axis; the section
  // turns with it. a[3], a[7] and a[9] do nothing.
  const double angle = a[4] * a[1], c = std::cos(angle), s = std::sin(angle);
  return section(a[0] * c + a[2] * s - a[6], a[2] * c - a[0] * s, a[8]) - a[5];
}

double spiral(const double* a) {
  // An Archimedean spiral in the plane y = 0: a[3] between windings, a[4] thick, within a sphere of
  // radius a[5]. a[6] and a[7] do nothing, a[8] is the section's type.
  const double r = axis_distance(a);
  const double winding = r / a[3] - (kPi - std::atan2(a[2], a[0])) / (2 * kPi);
  const double u = a[3] * (winding - std::floor(winding + 0.5));
  const double centre = std::sqrt(square(r > 0 ? r : 1e-6) + square(a[1]));  // (measured)
  return std::max(std::min(section(u, a[1], a[8]), centre) - a[4], centre - a[5]);
}

double polytubes(const double* a) {
  // a[3] tubes about the y axis, each at the radius that a quartic in y gives; measured in the
  // plane of equal y. The nearest tube is one of the two beside the point or, where a broken number
  // of them leaves a gap, the first or the last.
  constexpr double kNone = 10000;
  const double y = a[1], count = std::trunc(a[3]), step = 2 * kPi / a[3];
  if (!(count >= 1)) return kNone;
  const double at = a[4] + y * (a[5] + y * (a[6] + y * (a[7] + y * a[8])));
  double angle = std::atan2(at < 0 ? -a[0] : a[0], at < 0 ? -a[2] : a[2]);
  if (angle < 0) angle += 2 * kPi;
  const double before = std::floor(angle / step);
  double nearest = square(kNone);
  for (const double tube : {before, before + 1, 0.0, count - 1}) {
    const double direction = step * std::clamp(tube, 0.0, count - 1);
    nearest = std::min(
        nearest, square(a[0] - at * std::sin(direction)) + square(a[2] - at * std::cos(direction)));
  }
  return std::sqrt(nearest);
}

double helical_torus(const double* a) {
  // A tube (radius a[6]) wound a[4] times round a torus (radii a[3] and a[8]), with a[10] grooves
  // of depth a[11] that are turned by a[12] along it. a[7] is taken off at the end; a[9] is the
  // weight of the distance along the torus against that from it.
  const double major = a[3], minor = a[8], r = axis_distance(a);
  const double along = -std::atan2(a[0], a[2]), around = -std::atan2(r - major, a[1]);
  const double winding = wrapped(a[4] * along + a[5] * around + kPi);
  const double ring = std::sqrt(square(r - major) + square(a[1])), u = ring - minor;
  const double groove = std::atan2(a[11] * winding, u);
  const double tube = std::min(ring + minor, std::sqrt(square(u) + a[9] * square(winding))) -
                      a[6] * std::cos(a[10] * groove + a[12] * along);
  return std::min(r + major - minor, tube) - a[7];
}

}  // namespace dioptre::internal_functions
