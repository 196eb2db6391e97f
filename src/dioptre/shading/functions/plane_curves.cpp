// SPDX-License-Identifier: Apache-2.0
// Plane curves as cylinders along z or, with the switch on, as surfaces of revolution about y.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dioptre/shading/functions/internal_function_families.h"

namespace dioptre::internal_functions {
namespace {

constexpr double kLimit = 10;

struct PlanePoint {
  double x, y;
};

/// The point in the curve's plane; sor[0] switches revolution on, sor[1] is the curve's distance
/// from the axis and sor[2] turns it, in degrees.
PlanePoint plane_point(const double* a, const double* sor) {
  if (!(sor[0] > 0)) return {a[0], a[1]};
  const double x = std::sqrt(a[0] * a[0] + a[2] * a[2]) - sor[1];
  const double angle = sor[2] * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  return {x * c - a[1] * s, x * s + a[1] * c};
}

double limited(double value, double limit) { return std::min(std::max(value, -limit), limit); }

double square(double v) { return v * v; }

}  // namespace

double algebraic_cylinder_1(const double* a) {
  const auto [x, y] = plane_point(a, a + 5);
  return -limited(a[3] * (x * x - std::abs(x * x * x) - y * y), a[4]);
}

double algebraic_cylinder_2(const double* a) {
  const auto [x, y] = plane_point(a, a + 5);
  const double x2 = x * x;
  return limited(a[3] * (y * (3 * x2 + y * (y * (2 - y) - 1)) - 2 * x2 * x2), a[4]);
}

double algebraic_cylinder_3(const double* a) {
  const auto [x, y] = plane_point(a, a + 5);
  const double x2 = x * x, y2 = y * y;
  return limited(a[3] * (x * y2 + 2 * x2 * y - y2 - x2 * (x2 + y2)), a[4]);
}

double algebraic_cylinder_4(const double* a) {
  const auto [x, y] = plane_point(a, a + 5);
  const double x2 = x * x, y2 = y * y;
  return limited(a[3] * (y * (y2 - 3 * x2) - square(x2 + y2)), a[4]);
}

double devils_curve_2d(const double* a) {
  const auto [x, y] = plane_point(a, a + 6);
  const double x2 = x * x, y2 = y * y;
  return limited(a[3] * (y2 * (y2 - square(a[5])) - x2 * (x2 - square(a[4]))), kLimit);
}

double folium_surface_2d(const double* a) {
  const auto [x, y] = plane_point(a, a + 6);
  return limited(a[3] * (x * y * y * (4 * a[4] - a[5]) - y * y - (1 + a[5]) * x * x), kLimit);
}

double kampyle_of_eudoxus_2d(const double* a) {
  const auto [x, y] = plane_point(a, a + 6);
  return limited(a[3] * (square(a[5] * x) * (x * x - a[4] * a[5]) - y * y), kLimit);
}

double lemniscate_of_gerono_2d(const double* a) {
  const auto [x, y] = plane_point(a, a + 6);
  return limited(a[3] * (square(a[5] * x) * (square(a[4]) - x * x) - y * y), kLimit);
}

double piriform_2d(const double* a) {
  const auto [x, y] = plane_point(a, a + 7);
  return limited(a[3] * (square(a[6]) * x * x * x * (a[5] * x + a[4]) - y * y), kLimit);
}

double strophoid_2d(const double* a) {
  const auto [x, y] = plane_point(a, a + 7);
  return limited(a[3] * ((x - a[5]) * y * y + square(a[6] * x) * (x + a[4])), kLimit);
}

double witch_of_agnesi_2d(const double* a) {
  const auto [x, y] = plane_point(a, a + 6);
  return limited(a[3] * (a[5] - y * (x * x + square(a[4]))), kLimit);
}

}  // namespace dioptre::internal_functions
