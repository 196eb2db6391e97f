// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/attenuation.h"

#include <cmath>

namespace dioptre {

Color attenuation(const Interior& interior, double distance) {
  if (interior.fade_distance == 0) return {1, 1, 1};
  const double depth = distance / interior.fade_distance;
  const Color c = interior.fade_color;
  if (interior.fade_power >= 1000) {
    const auto channel = [&](float f) { return static_cast<float>(std::exp(-(1 - f) * depth)); };
    return {channel(c.r), channel(c.g), channel(c.b)};
  }
  const double left_of_all = 1 / (1 + std::pow(depth, interior.fade_power));
  const float left = left_of_all > 0 ? static_cast<float>(left_of_all) : 0;
  return c + (Color{1, 1, 1} - c) * left;
}

}  // namespace dioptre
