// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "dioptre/core/color.h"
#include "dioptre/core/ray.h"
#include "dioptre/integrators/media_stack.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// What lies between a surface and a light beside surfaces: the insides of solids, and mist.
class ShadowMedia {
 public:
  explicit ShadowMedia(const RenderScene& scene);

  /// Whether any solid dims the light inside.
  bool any_fades() const { return any_fades_; }
  /// Whether there is mist, which dims lights that ask for it.
  bool any_fog() const { return any_fog_; }

  /// The share of light left by what a ray is in, over the range of its length; of the fog only
  /// if `in_fog`. `hits` are the surfaces met (RenderScene::shadow_hits). A solid dims the light
  /// where the ray leaves it, by the distance since the surface met last. The ray starts in what
  /// the ray that sees its origin is in, whatever else is around; a fade_power of 0 does not dim
  /// (measured).
  Color transmittance(const Ray& ray, Interval range, std::span<const Hit> hits, MediaStack media,
                      bool in_fog) const;

 private:
  const RenderScene& scene_;
  bool any_fades_ = false;
  bool any_fog_ = false;
};

}  // namespace dioptre
