// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "dioptre/core/color.h"
#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"
#include "dioptre/render/render_scene.h"
#include "dioptre/shading/texture_evaluator.h"

namespace dioptre {

/// How a ray of the ray tree came to be.
enum class RayKind : std::uint8_t { kCamera, kReflected, kTransmitted };

/// What light is, that a ray brings back and no further ray of the tree does: the sky or a mist on
/// the way, or what the surface it meets glows, scatters or shows as highlights.
enum class LightTerm : std::uint8_t { kBackground, kAmbient, kDiffuse, kHighlight };

/// The start of a ray of the tree.
struct RayStart {
  RayKind kind = RayKind::kCamera;
  Ray ray;
  Color share;              ///< what the ray it comes from gets of this one's light
  std::uint32_t level = 1;  ///< as max_trace_level counts
  double ior = 1;           ///< of what the ray runs through
};

/// A ray towards a light.
struct ShadowRay {
  std::size_t light = 0;  ///< its number in the scene
  Ray ray;
  Interval range;
  const Item* blocker = nullptr;  ///< null if no opaque item is in the way
  Color visible;                  ///< what gets through
};

/// Is told all that happens to the rays of one pixel, as it happens: what comes between begin() and
/// end() concerns that ray. The light of a ray is the sum of what it receives and of the lights of
/// the rays begun within, times their shares.
class RayObserver {
 public:
  virtual ~RayObserver() = default;
  virtual void begin(const RayStart& start) = 0;
  /// The surface that the ray meets, if any; its normals face the ray.
  virtual void meet(const Hit& hit, const SurfaceInteraction& at, const TextureSample& texture) = 0;
  virtual void receive(LightTerm term, Color light) = 0;
  virtual void shadow(const ShadowRay& ray) = 0;
  virtual void end() = 0;
};

}  // namespace dioptre
