// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/atmosphere.h"

#include <algorithm>
#include <cmath>

#include "dioptre/shading/noise/noise.h"

namespace dioptre {
namespace {

/// The integral of the density of ground fog between two heights (in units of the fog's altitude
/// above its offset), where the density is 1 below 0 and 1/(1 + h^2) above.
double density_integral(double h) { return h <= 0 ? h : std::atan(h); }

/// The mean density of ground fog along a stretch.
double mean_density(const Fog& fog, const Ray& ray, double distance) {
  const Vec3 up = normalize(fog.up);
  const double start = dot(ray.origin, up) - fog.offset;
  const double slope = dot(ray.direction, up);
  if (fog.altitude <= 0) return start <= 0 ? 1 : 0;
  const double h0 = start / fog.altitude, h1 = (start + slope * distance) / fog.altitude;
  if (std::fabs(h1 - h0) > 1e-6) return (density_integral(h1) - density_integral(h0)) / (h1 - h0);
  return h0 <= 0 ? 1 : 1 / (1 + h0 * h0);
}

NoiseGenerator noise_of(const Settings& settings) {
  return settings.noise_generator == 1   ? NoiseGenerator::kOriginal
         : settings.noise_generator == 3 ? NoiseGenerator::kPerlin
                                         : NoiseGenerator::kRangeCorrected;
}

/// How much of the light is lost, as an optical depth. Turbulence is looked up once, in the middle
/// of the stretch, and counts less the thicker the mist (measured):
/// depth (1 - min(1, turb_depth S) exp(-distance / fog distance)).
double optical_depth(const RenderScene& scene, const Fog& fog, const Ray& ray, double distance) {
  distance = std::min(distance, kSkyDistance);
  double depth = distance / fog.distance;
  const double thinning = std::exp(-depth);
  if (fog.ground) depth *= mean_density(fog, ray, distance);
  if (fog.turbulence == Vec3{}) return depth;
  const double s =
      scalar_turbulence(fog.turbulence * ray.at(distance / 2), {fog.octaves, fog.omega, fog.lambda},
                        noise_of(scene.scene().settings));
  return depth * (1 - std::min(1.0, fog.turb_depth * s) * thinning);
}

/// What the layers of a sky passed so far let through. Before version 3.7 the filtered and the
/// transmitted share were multiplied up apart, and only the background was tinted (measured).
class SkyTransmittance {
 public:
  explicit SkyTransmittance(double language_version) : apart_(language_version < 3.7) {}

  void pass(const PigmentColor& layer) {
    through_ *= layer.transmittance();
    tint_ *= layer.color * layer.filter;
    filter_ *= layer.filter;
    transmit_ *= layer.transmit;
    any_ = true;
  }
  Color to_layers() const {
    return apart_ && any_ ? Color{1, 1, 1} * (filter_ + transmit_) : through_;
  }
  Color to_background() const {
    return apart_ && any_ ? tint_ + Color{1, 1, 1} * transmit_ : through_;
  }

 private:
  Color through_{1, 1, 1};
  Color tint_{1, 1, 1};
  float filter_ = 1, transmit_ = 1;
  bool apart_, any_ = false;
};

}  // namespace

FogEffect fog_effect(const RenderScene& scene, const Ray& ray, double distance) {
  FogEffect effect;
  for (const Fog& fog : scene.scene().atmosphere.fogs) {
    if (fog.distance <= 0) continue;
    const auto through =
        std::max(static_cast<float>(std::exp(-optical_depth(scene, fog, ray, distance))),
                 fog.color.transmit);
    const float filter = fog.color.filter;
    const Color tint = Color{1, 1, 1} * (1 - filter) + fog.color.color * filter;
    effect.added += fog.color.color * (1 - through);
    effect.transmittance *= tint * through;
  }
  return effect;
}

Sky::Sky(const RenderScene& scene) : scene_(scene) {
  for (const SkySphere& sky : scene.scene().atmosphere.sky_spheres) {
    const Affine to_sky = inverse(sky.transform).value_or(Affine{});
    for (std::size_t i = sky.pigments.size(); i-- > 0;) {
      layers_.push_back({sky.pigments[i], to_sky, sky.emission});
    }
  }
}

Color Sky::radiance(Vec3 direction) const {
  const Color background = scene_.scene().atmosphere.background;
  if (layers_.empty()) return background;
  SkyTransmittance through(scene_.scene().settings.language_version);
  Color radiance;
  for (const Layer& layer : layers_) {
    const PigmentColor seen =
        scene_.textures().pigment(layer.pigment, layer.to_sky.point(direction));
    radiance += through.to_layers() * layer.emission * seen.color * seen.opacity();
    through.pass(seen);
  }
  return radiance + through.to_background() * background;
}

}  // namespace dioptre
