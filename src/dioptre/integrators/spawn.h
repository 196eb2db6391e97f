// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/ray.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// A ray that leaves a surface in a unit direction, its origin moved off the surface along the
/// geometric normal by the bound on the point's error, to the side the ray goes to: the ray does
/// not meet the surface it comes from, and misses nothing else. (Waechter and Binder, "A Fast and
/// Robust Method for Avoiding Self-Intersection", Ray Tracing Gems 2019.)
inline Ray spawn_ray(const SurfaceInteraction& from, Vec3 direction) {
  const Vec3 normal = from.surface.normal;
  const double offset = dot(direction, normal) < 0 ? -from.error : from.error;
  return {from.surface.position + offset * normal, direction};
}

}  // namespace dioptre
