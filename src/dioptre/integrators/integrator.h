// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "dioptre/core/color.h"
#include "dioptre/core/ray.h"
#include "dioptre/core/result.h"
#include "dioptre/integrators/query_clock.h"
#include "dioptre/integrators/ray_observer.h"
#include "dioptre/lights/light_shape.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// What a camera ray brings back.
struct Radiance {
  Color color;
  float alpha = 1;  ///< the share of the ray that ended on objects, not in the background
};

/// How many rays of each kind were traced.
struct RayCounts {
  std::uint64_t camera = 0, reflected = 0, transmitted = 0, shadow = 0;
  std::uint64_t total() const { return camera + reflected + transmitted + shadow; }
  RayCounts& operator+=(const RayCounts& b) {
    camera += b.camera, reflected += b.reflected;
    transmitted += b.transmitted, shadow += b.shadow;
    return *this;
  }
};

/// What is noted down while rays are traced.
struct RayLog {
  RayCounts counts;
  RayObserver* observer = nullptr;  ///< may be none; changes nothing in the picture
  QueryClock clock;                 ///< asks what rays meet
  WalkCost walks;                   ///< of all rays through the scene's accelerator
};

/// Computes the light that comes along a ray from the eye. Immutable; used by all threads at once.
class RayIntegrator {
 public:
  virtual ~RayIntegrator() = default;
  virtual Radiance radiance(const Ray& camera_ray, RayLog& log) const = 0;
};

/// How the light that a mirrored or transmitted ray brings from the surface it meets falls with its
/// length d in scene units: by exp(-k d), as in a medium that absorbs evenly (Bouguer 1729). A ray
/// that meets nothing brings the background as it is.
struct LengthAttenuation {
  double reflected = 0;    ///< k of mirrored rays, >= 0
  double transmitted = 0;  ///< k of rays through surfaces, >= 0
  bool operator==(const LengthAttenuation&) const = default;
};

/// How area lights are sampled.
struct Penumbra {
  LightShape shape = LightShape::kGrid;
  /// Of a shape other than the grid: at least as many, one at random in each cell of a grid (R. L.
  /// Cook, "Stochastic Sampling in Computer Graphics", 1986); 1 to 65536, else the nearer of them.
  std::uint32_t samples = 64;
};

/// Which parts of the light transport are computed.
struct IntegratorOptions {
  std::uint32_t quality = 9;  ///< 0 to 11, as in POV-Ray's +Q: 4 adds shadows, 8 reflection
  LengthAttenuation attenuation;
  Penumbra penumbra;
  bool appel_shadows = false;  ///< whether plain ray casting looks for shadows
};

/// The names that make_integrator knows, the default first.
std::span<const std::string_view> integrator_names();

/// An unknown name is an error that lists the names.
Result<std::unique_ptr<const RayIntegrator>> make_integrator(std::string_view name,
                                                             const RenderScene& scene,
                                                             const IntegratorOptions& options);

}  // namespace dioptre
