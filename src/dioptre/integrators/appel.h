// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/integrators/atmosphere.h"
#include "dioptre/integrators/local_light.h"

namespace dioptre {

/// Ray casting (A. Appel, "Some Techniques for Shading Machine Renderings of Solids", 1968): the
/// surface nearest to the eye along each ray, in the light that it sends back by itself. Nothing is
/// mirrored, nothing lets light through, and there is no mist; shadows are cast if asked for.
class Appel final : public RayIntegrator {
 public:
  Appel(const RenderScene& scene, const IntegratorOptions& options);

  Radiance radiance(const Ray& camera_ray, RayLog& log) const override;

  /// The light of the surface at a hit.
  Color surface(const Ray& ray, const Hit& hit, RayLog& log) const;
  /// The light from where nothing is hit.
  Color background(Vec3 direction) const { return sky_.radiance(direction); }

 private:
  const RenderScene& scene_;
  LocalLight local_;
  Sky sky_;
};

}  // namespace dioptre
