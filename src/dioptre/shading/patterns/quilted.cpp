// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/quilted.h"

#include <cmath>
#include <numbers>

namespace dioptre {

double quilted_curve(double distance, const Quilted& quilted) {
  // The scene language keeps the controls in single precision.
  const double control0 = static_cast<float>(quilted.control0);
  const double control1 = static_cast<float>(quilted.control1);
  const double t = distance, rest = 1 - t;
  return 3 * t * rest * rest * control0 + 3 * t * t * rest * control1 + t * t * t;
}

double quilted_value(Vec3 p, const Quilted& quilted) {
  const auto off = [](double v) { return std::fabs(v - std::floor(v) - 0.5); };
  const Vec3 q{off(p.x), off(p.y), off(p.z)};
  return 2 / (3 * std::numbers::sqrt3) * (q.x + q.y + q.z) * quilted_curve(length(q), quilted);
}

}  // namespace dioptre
