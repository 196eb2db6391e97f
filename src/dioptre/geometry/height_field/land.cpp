// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/height_field/land.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/triangle/smooth_normal.h"

namespace dioptre {
namespace {

constexpr double kStepsUp = 65536;
constexpr double kNormalSteps = 32767;

/// The cell of a coordinate in [0, 1], and where in it.
std::uint32_t cell_of(double x, std::uint32_t cells, double& rest) {
  const double scaled = std::fmin(std::fmax(x, 0), 1) * cells;
  const std::uint32_t cell = std::min(static_cast<std::uint32_t>(scaled), cells - 1);
  rest = scaled - cell;
  return cell;
}

}  // namespace

std::array<Vec3, 3> Land::triangle(std::uint32_t index) const {
  const std::uint32_t i = index / 2 % cells_x(), j = index / 2 / cells_x();
  if (index % 2 == 0) return {point(i, j), point(i + 1, j), point(i, j + 1)};
  return {point(i + 1, j + 1), point(i, j + 1), point(i + 1, j)};
}

LandPlace Land::place(double x, double z) const {
  LandPlace p;
  p.i = cell_of(x, cells_x(), p.u);
  p.j = cell_of(z, cells_z(), p.v);
  return p;
}

double Land::height_at(double x, double z) const {
  const auto [i, j, u, v] = place(x, z);
  const double right = height(i + 1, j), far = height(i, j + 1);
  if (u + v <= 1) return (1 - u - v) * height(i, j) + u * right + v * far;
  return (u + v - 1) * height(i + 1, j + 1) + (1 - v) * right + (1 - u) * far;
}

Vec3 Land::corner_normal(std::uint32_t i, std::uint32_t j) const {
  const double here = kStepsUp * height(i, j);
  Vec3 sum;
  for (const int x : {-1, 1}) {
    if (x < 0 ? i == 0 : i == cells_x()) continue;
    const double slope_x = x * (kStepsUp * height(i + static_cast<std::uint32_t>(x), j) - here);
    for (const int z : {-1, 1}) {
      if (z < 0 ? j == 0 : j == cells_z()) continue;
      const double slope_z = z * (kStepsUp * height(i, j + static_cast<std::uint32_t>(z)) - here);
      sum = sum + normalize(Vec3{-slope_x, 1, -slope_z});
    }
  }
  const Vec3 n = kNormalSteps * unit_or_zero(sum);
  const Vec3 unscaled{std::trunc(n.x) * cells_x(), std::trunc(n.y) * kStepsUp,
                      std::trunc(n.z) * cells_z()};
  return unit_or_zero({unscaled.x / scale_.x, unscaled.y / scale_.y, unscaled.z / scale_.z});
}

Vec3 Land::smooth_normal_at(double x, double z) const {
  const auto [i, j, u, v] = place(x, z);
  const Vec3 low = (1 - u) * corner_normal(i, j) + u * corner_normal(i + 1, j);
  const Vec3 high = (1 - u) * corner_normal(i, j + 1) + u * corner_normal(i + 1, j + 1);
  const Vec3 scaled = (1 - v) * low + v * high;
  return unit_or_zero({scaled.x * scale_.x, scaled.y * scale_.y, scaled.z * scale_.z});
}

}  // namespace dioptre
