// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/affine.h"
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

/// The background and the sky spheres of a scene made ready. Immutable; the scene must outlive it.
class Sky {
 public:
  explicit Sky(const RenderScene& scene);

  /// The light from where nothing is hit.
  Color radiance(Vec3 direction) const;

 private:
  struct Layer {
    PigmentId pigment;
    Affine to_sky;  ///< from directions in the world
    Color emission;
  };

  const RenderScene& scene_;
  std::vector<Layer> layers_;  ///< the one in front first
};

}  // namespace dioptre
