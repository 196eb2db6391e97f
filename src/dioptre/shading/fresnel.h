// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "dioptre/core/vec.h"

namespace dioptre {

/// The share of unpolarised light that a smooth dielectric mirrors (A. Fresnel, 1823). `cosine` is
/// that of the angle to the normal, in [0, 1]; `ior` the index of refraction behind the surface
/// over the one before it. 1 for total reflection, 0 for an ior that is not positive.
inline double fresnel_reflectance(double cosine, double ior) {
  if (!(ior > 0)) return 0;
  const double c = std::clamp(cosine, 0.0, 1.0);
  const double beyond = 1 - (1 - c * c) / (ior * ior);
  if (!(beyond > 0)) return 1;
  const double t = std::sqrt(beyond);
  const double parallel = (ior * c - t) / (ior * c + t);
  const double perpendicular = (c - ior * t) / (c + ior * t);
  return (parallel * parallel + perpendicular * perpendicular) / 2;
}

/// The direction of a unit ray bent by Snell's law at a unit normal that faces it; `ratio` is the
/// index of refraction before the surface over the one behind it. Nothing if no light gets through.
inline std::optional<Vec3> refract(Vec3 direction, Vec3 normal, double ratio) {
  const double cosine = -dot(direction, normal);
  const double beyond = 1 - ratio * ratio * (1 - cosine * cosine);
  if (!(beyond >= 0)) return std::nullopt;
  return normalize(ratio * direction + (ratio * cosine - std::sqrt(beyond)) * normal);
}

}  // namespace dioptre
