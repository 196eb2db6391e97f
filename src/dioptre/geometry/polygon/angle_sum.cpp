// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/polygon/angle_sum.h"

#include <cmath>
#include <numbers>

namespace dioptre {

bool inside_by_angles(const std::vector<std::vector<Vec2>>& outlines, Vec2 p) {
  bool odd = false;
  for (const std::vector<Vec2>& outline : outlines) {
    double angle = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 from = outline[i] - p, to = outline[(i + 1) % outline.size()] - p;
      angle += std::atan2(cross(from, to), dot(from, to));
    }
    odd = odd != (std::lround(angle / (2 * std::numbers::pi)) % 2 != 0);
  }
  return odd;
}

}  // namespace dioptre
