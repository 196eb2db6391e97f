// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/blocks.h"

#include <cmath>
#include <numbers>

namespace dioptre {
namespace {

/// v modulo m, in [0, m).
double modulo(double v, double m) { return v - m * std::floor(v / m); }

bool odd(double floor) { return modulo(floor, 2) == 1; }

}  // namespace

double checker_block(Vec3 p) {
  return odd(std::floor(p.x) + std::floor(p.y) + std::floor(p.z)) ? 1 : 0;
}

double brick_block(Vec3 p, const Brick& brick) {
  const Vec3 size = brick.size;
  const auto in_mortar = [&](double v, double length) {
    return modulo(v, length) >= length - brick.mortar;
  };
  if (in_mortar(p.y, size.y)) return 0;
  const double row = std::floor(p.y / size.y);
  const double x = odd(row) ? p.x + 0.5 * size.x : p.x;
  const double z = odd(row) ? p.z : p.z + 0.5 * size.z;
  return in_mortar(x, size.x) || in_mortar(z, size.z) ? 0 : 1;
}

double cubic_block(Vec3 p) {
  const Vec3 a = abs(p);
  if (a.x >= a.y && a.x >= a.z) return p.x >= 0 ? 0 : 3;
  if (a.y >= a.z) return p.y >= 0 ? 1 : 4;
  return p.z >= 0 ? 2 : 5;
}

double hexagon_block(Vec3 p) {
  // Centres stand at i (1.5, h) + j (0, 2h) with h = sqrt(3)/2; the nearest one wins.
  constexpr double kHalf = std::numbers::sqrt3 / 2;
  const double column = std::floor(p.x / 1.5);
  double nearest = 1e300, i_nearest = 0, j_nearest = 0;
  for (const double i : {column, column + 1}) {
    const double j = std::round((p.z - i * kHalf) / (2 * kHalf));
    const double dx = p.x - 1.5 * i, dz = p.z - i * kHalf - j * 2 * kHalf;
    const double distance = dx * dx + dz * dz;
    if (distance < nearest) nearest = distance, i_nearest = i, j_nearest = j;
  }
  return modulo(j_nearest + 2 * i_nearest, 3);
}

double square_block(Vec3 p) {
  const bool x = odd(std::floor(p.x)), z = odd(std::floor(p.z));
  if (x) return z ? 2 : 3;
  return z ? 1 : 0;
}

double triangular_block(Vec3 p) {
  constexpr double kHeight = std::numbers::sqrt3 / 2;
  const double row = std::floor(p.z / kHeight);
  const double v = p.z / kHeight - row;
  const bool shifted = odd(row);
  const double x = shifted ? p.x + 0.5 : p.x;
  const double k = std::floor(x), u = x - k;
  const double step = shifted ? 1 : 0;
  if (u >= v / 2 && u <= 1 - v / 2) return modulo(4 * (k + step), 6);
  const double apex = u < v / 2 ? k : k + 1;
  return modulo(2 * apex + 1 + 2 * step, 6);
}

}  // namespace dioptre
