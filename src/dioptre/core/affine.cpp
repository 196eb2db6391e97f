// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/affine.h"

#include <numbers>

namespace dioptre {
namespace {

/// Cosine and sine of an angle in degrees, exact at the quarter turns.
struct Turn {
  double cos, sin;
  explicit Turn(double degrees) {
    const double quarters = degrees / 90;
    if (quarters == std::floor(quarters) && std::fabs(quarters) < 1e9) {
      const auto q = static_cast<long>(quarters) & 3;
      cos = q == 0 ? 1 : q == 2 ? -1 : 0;
      sin = q == 1 ? 1 : q == 3 ? -1 : 0;
    } else {
      const double angle = degrees * (std::numbers::pi / 180);
      cos = std::cos(angle);
      sin = std::sin(angle);
    }
  }
};

}  // namespace

std::optional<Affine> inverse(const Affine& a) {
  // Rows of the inverse linear part are the cross products of the images of the axes.
  const Vec3 yz = cross(a.y, a.z), zx = cross(a.z, a.x), xy = cross(a.x, a.y);
  const double determinant = dot(a.x, yz);
  if (determinant == 0 || !std::isfinite(determinant)) return std::nullopt;
  const double s = 1 / determinant;
  Affine inverse;
  inverse.x = s * Vec3{yz.x, zx.x, xy.x};
  inverse.y = s * Vec3{yz.y, zx.y, xy.y};
  inverse.z = s * Vec3{yz.z, zx.z, xy.z};
  inverse.o = -inverse.vector(a.o);
  if (!is_finite(inverse.x) || !is_finite(inverse.y) || !is_finite(inverse.z) ||
      !is_finite(inverse.o)) {
    return std::nullopt;
  }
  return inverse;
}

Affine translation(Vec3 by) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by}; }

Affine scaling(Vec3 by) { return {{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}, {}}; }

Affine rotation(Vec3 degrees) {
  const Turn x(degrees.x), y(degrees.y), z(degrees.z);
  const Affine about_x{{1, 0, 0}, {0, x.cos, x.sin}, {0, -x.sin, x.cos}, {}};
  const Affine about_y{{y.cos, 0, -y.sin}, {0, 1, 0}, {y.sin, 0, y.cos}, {}};
  const Affine about_z{{z.cos, z.sin, 0}, {-z.sin, z.cos, 0}, {0, 0, 1}, {}};
  return then(then(about_x, about_y), about_z);
}

Affine axis_rotation(Vec3 axis, double degrees) {
  // Rodrigues' formula on the three axes.
  const Vec3 n = normalize(axis);
  const Turn turn(degrees);
  const auto turned = [&](Vec3 v) {
    return turn.cos * v + turn.sin * cross(n, v) + (1 - turn.cos) * dot(n, v) * n;
  };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {}};
}

}  // namespace dioptre
