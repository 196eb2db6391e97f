// SPDX-License-Identifier: Apache-2.0
#include "dioptre/lights/light_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dioptre {

Vec2 disc_point(double u, double v) {
  const double x = 2 * u - 1, y = 2 * v - 1;
  if (x == 0 && y == 0) return {};
  constexpr double kEighth = std::numbers::pi / 4;
  const bool across = std::fabs(x) > std::fabs(y);
  const double radius = 0.5 * (across ? x : y);
  const double angle = across ? kEighth * (y / x) : 2 * kEighth - kEighth * (x / y);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Vec3 sphere_point(Vec3 center, double radius, Vec3 seen_from, double u, double v) {
  const Vec3 to_center = center - seen_from;
  const double distance = length(to_center);
  if (!(distance > radius)) return center;
  const Vec3 axis = to_center / distance;
  const double widest = radius / distance;  // the sine of the angle to the rim
  const double cosine = 1 - u * (1 - std::sqrt(1 - widest * widest));
  const double sine_squared = std::max(0.0, 1 - cosine * cosine);
  const double near =
      distance * cosine -
      std::sqrt(std::max(0.0, radius * radius - distance * distance * sine_squared));
  const Vec3 side =
      normalize(std::fabs(axis.y) < 0.9 ? cross(Vec3{0, 1, 0}, axis) : cross(Vec3{1, 0, 0}, axis));
  const double turn = 2 * std::numbers::pi * v, sine = std::sqrt(sine_squared);
  const Vec3 direction =
      cosine * axis + sine * std::cos(turn) * side + sine * std::sin(turn) * cross(axis, side);
  return seen_from + near * direction;
}

}  // namespace dioptre
