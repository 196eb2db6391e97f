// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/integrators/integrator.h"
#include "dioptre/integrators/media_stack.h"
#include "dioptre/integrators/shadow_media.h"
#include "dioptre/lights/light_source.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// A point of a surface that light falls on.
struct LitPoint {
  const SurfaceInteraction& at;
  const MediaStack& around;  ///< what the ray that sees it is in
};

/// The lights of a scene with their shadows.
class DirectLight {
 public:
  DirectLight(const RenderScene& scene, const IntegratorOptions& options);

  const std::vector<LightSource>& lights() const { return lights_; }

  /// The share of a light that reaches a surface point past everything in between; for an area
  /// light the mean over its samples.
  Color visibility(const LightSource& light, const Illumination& illumination,
                   const LitPoint& point, RayLog& log) const;

 private:
  Color shape_mean(std::size_t number, const LitPoint& point, RayLog& log) const;
  Color through(const Light& light, const Ray& ray, Interval range, const Item*& blocker,
                const MediaStack& around, RayLog& log) const;
  Color to_point(std::size_t number, Vec3 light_position, const LitPoint& point,
                 const Item*& blocker, RayLog& log) const;
  Color along(std::size_t number, Vec3 to_light, double distance, const LitPoint& point,
              const Item*& blocker, RayLog& log) const;

  const RenderScene& scene_;
  std::vector<LightSource> lights_;
  ShadowMedia media_;
  Penumbra penumbra_;
  bool shadows_;
};

}  // namespace dioptre
