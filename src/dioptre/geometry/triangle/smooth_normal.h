// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "dioptre/core/vec.h"

namespace dioptre {

/// The unit vector along n, or 0 where n has no direction.
inline Vec3 unit_or_zero(Vec3 n) {
  const double scale = max_component(abs(n));
  if (!(scale > 0) || !std::isfinite(scale)) return {};
  return normalize(n / scale);
}

/// The corners' unit normals mixed at (1-v-w, v, w), made unit and turned to the side of `flat`;
/// `flat` itself where they cancel.
inline Vec3 smooth_normal(const std::array<Vec3, 3>& normals, double v, double w, Vec3 flat) {
  const Vec3 n = (1 - v - w) * normals[0] + v * normals[1] + w * normals[2];
  const Vec3 unit = unit_or_zero(n);
  if (unit == Vec3{}) return flat;
  return dot(unit, flat) < 0 ? -unit : unit;
}

}  // namespace dioptre
