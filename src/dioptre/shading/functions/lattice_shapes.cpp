// SPDX-License-Identifier: Apache-2.0
// Hexagonal lattices in x and y, and a woven mesh in x and z.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dioptre/shading/functions/internal_function_families.h"

namespace dioptre::internal_functions {
namespace {

constexpr double kRoot3 = std::numbers::sqrt3;

double square(double v) { return v * v; }

/// The distance from v to the nearest multiple of period.
double from_multiple(double v, double period) {
  return std::abs(v - period * std::floor(v / period + 0.5));
}

/// |x| and |y| from the centre of the hexagon that the point is in. Hexagons have sides of length
/// 1, two of them along y; one is about the origin.
struct HexagonPoint {
  double x, y;
};
HexagonPoint hexagon_point(const double* a) {
  const HexagonPoint even{from_multiple(a[0], kRoot3), from_multiple(a[1], 3)};
  const HexagonPoint odd{from_multiple(a[0] - kRoot3 / 2, kRoot3), from_multiple(a[1] - 1.5, 3)};
  return square(even.x) + square(even.y) <= square(odd.x) + square(odd.y) ? even : odd;
}

/// The squared distance from the threads of one direction: they lie `period` apart across it, and
/// their height waves along it, each against its neighbours.
double thread_distance(double across, double along_height, double period, double y,
                       double across_scale, double y_scale) {
  const double below = std::floor(across / period);
  const double sign = std::fmod(below, 2) == 0 ? 1 : -1;
  double nearest = INFINITY;
  for (int i = -1; i <= 2; ++i) {
    const double height = i % 2 == 0 ? sign * along_height : -sign * along_height;
    nearest = std::min(nearest, square(across_scale * (across - (below + i) * period)) +
                                    square(y_scale * (y - height)));
  }
  return nearest;
}

}  // namespace

double hexagonal_columns(const double* a) {
  const HexagonPoint p = hexagon_point(a);
  return std::max(p.x, (p.x + kRoot3 * p.y) / 2);
}

double hexagonal_lines(const double* a) {
  const HexagonPoint p = hexagon_point(a);
  return std::min(p.y, std::abs(kRoot3 * p.x - p.y) / 2);
}

double woven_mesh(const double* a) {
  const double pi = std::numbers::pi;
  const double along_x = a[6] * std::cos(pi * a[0] / a[3]);
  const double along_z = -a[6] * std::cos(pi * a[2] / a[4]);
  return std::sqrt(std::min(thread_distance(a[2], along_x, a[4], a[1], a[5], a[7]),
                            thread_distance(a[0], along_z, a[3], a[1], a[5], a[7])));
}

}  // namespace dioptre::internal_functions
