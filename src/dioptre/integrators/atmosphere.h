// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/color.h"
#include "dioptre/core/ray.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// What a stretch of a ray through mist does to the light behind it: light * transmittance + added.
struct FogEffect {
  Color transmittance{1, 1, 1};
  Color added;
};

/// How far away the sky is for mist and rainbows (measured).
constexpr double kSkyDistance = 2e10;

/// The effect of all fogs from the ray's origin over `distance` (infinite towards the sky).
FogEffect fog_effect(const RenderScene& scene, const Ray& ray, double distance);

/// The light from where nothing is hit, by background and sky sphere.
Color sky_radiance(const RenderScene& scene, Vec3 direction);

}  // namespace dioptre
