// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "dioptre/geometry/triangle/smooth_normal.h"

namespace dioptre {

/// Two unit vectors at right angles to a unit vector and to each other.
inline std::array<Vec3, 2> beside(Vec3 normal) {
  const Vec3 size = abs(normal);
  const Vec3 other = size.x < size.y && size.x < size.z ? Vec3{1, 0, 0}
                     : size.y < size.z                  ? Vec3{0, 1, 0}
                                                        : Vec3{0, 0, 1};
  const Vec3 u = normalize(cross(normal, other));
  return {u, cross(normal, u)};
}

}  // namespace dioptre
