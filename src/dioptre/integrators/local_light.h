// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/integrators/direct_light.h"
#include "dioptre/integrators/integrator.h"
#include "dioptre/shading/texture_evaluator.h"
#include "dioptre/shading/thin_film.h"

namespace dioptre {

/// The surface at a hit, its normals turned to face the ray, and in `out` its texture there.
SurfaceInteraction see(const RenderScene& scene, const Ray& ray, const Hit& hit,
                       TextureSample& out);

/// A point of a surface, seen along a ray, in one stack of its texture's layers.
struct SeenPoint {
  const SurfaceInteraction& at;  ///< as see() gives it
  const TextureSample& sample;
  TextureSample::Stack stack;
  Vec3 direction;            ///< of the ray, unit
  Color share;               ///< of its light that counts for an observer
  const MediaStack& around;  ///< what the ray is in
  const SurfaceLayer& layer(std::uint32_t i) const { return sample.layers[stack.first + i]; }
};

/// What surfaces send back by themselves: their glow, and what they scatter and highlight of the
/// light that comes straight from the sources.
class LocalLight {
 public:
  LocalLight(const RenderScene& scene, const IntegratorOptions& options);

  /// The light of all layers of the stack.
  Color at(const SeenPoint& point, RayLog& log) const;

 private:
  Color of_source(const LightSource& light, const SeenPoint& point, RayLog& log) const;

  DirectLight direct_;
  Color ambient_light_;
  ThinFilms films_;
};

}  // namespace dioptre
