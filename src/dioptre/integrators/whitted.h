// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/integrators/integrator.h"
#include "dioptre/integrators/local_light.h"
#include "dioptre/integrators/media_stack.h"
#include "dioptre/integrators/rainbow.h"
#include "dioptre/shading/dispersion.h"

namespace dioptre {

/// Recursive ray tracing with the scene language's rules (T. Whitted, "An Improved Illumination
/// Model for Shaded Display", 1980): local light with shadows, mirror reflection, refraction.
/// A ray is followed while its weight is at least adc_bailout and its level below max_trace_level;
/// going straight through a surface is no new level.
class Whitted final : public RayIntegrator {
 public:
  Whitted(const RenderScene& scene, const IntegratorOptions& options);

  Radiance radiance(const Ray& camera_ray, RayLog& log) const override;

 private:
  /// A ray on its way, and what it may still add to its pixel.
  struct Path {
    Ray ray;
    Color weight{1, 1, 1};  ///< from this ray to the pixel
    std::uint32_t level = 1;
    double attenuation = 0;  ///< as LengthAttenuation has it
    RayPurpose purpose = RayPurpose::kCamera;
    float spectral_position = kWhiteLight;  ///< of light that dispersion has split, in [0, 1]
    MediaStack media;
    double reach = kInfinity;  ///< how far the next surface may be; an eye ray may have a limit
  };
  /// What becomes of a path at a surface that lets light through.
  enum class Passage { kNone, kThrough, kMirrored };
  struct Scratch;
  /// A point of a path where it is shaded.
  struct Vertex : SeenPoint {
    const Path& path;
  };

  void begin(RayKind kind, const Path& path, Color share, RayObserver* observer) const;
  Radiance trace(Path& path, Scratch& scratch) const;
  Passage transmit(const Vertex& vertex, const Hit& hit, Color& transmitted, Path& next) const;
  Color left_by_mirrors(const Vertex& vertex) const;
  Color shade(const Vertex& vertex, Scratch& scratch, bool with_mirrors) const;
  Color mirrored(const Vertex& vertex, const SurfaceLayer& layer, Color share,
                 Scratch& scratch) const;
  Color seen(Path path, Scratch& scratch) const;
  std::uint32_t colors_behind(const Vertex& vertex) const;
  Color disperse(const Vertex& vertex, const Hit& hit, std::uint32_t colors, Scratch& scratch,
                 bool& mirrored) const;
  Color film_tint(const SurfaceLayer& layer, const SurfaceInteraction& at, Vec3 from,
                  Vec3 to) const;
  Passage pass(const SurfaceInteraction& at, const Hit& hit, Vec3 normal, Path& path) const;
  bool may_spawn(Color weight, std::uint32_t level) const;

  const RenderScene& scene_;
  LocalLight local_;
  Sky sky_;
  ThinFilms films_;
  Rainbows rainbows_;
  bool has_fog_;
  bool disperses_;
  MediaStack camera_media_;
  bool reflections_;
  LengthAttenuation attenuation_;
};

}  // namespace dioptre
