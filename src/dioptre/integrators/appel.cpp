// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/appel.h"

namespace dioptre {
namespace {

/// Quality 3 of the scene language is light without shadows.
IntegratorOptions local_options(IntegratorOptions options) {
  constexpr std::uint32_t kWithoutShadows = 3;
  if (!options.appel_shadows) options.quality = std::min(options.quality, kWithoutShadows);
  return options;
}

}  // namespace

Appel::Appel(const RenderScene& scene, const IntegratorOptions& options)
    : scene_(scene), local_(scene, local_options(options)), sky_(scene) {}

Radiance Appel::radiance(const Ray& camera_ray, RayLog& log) const {
  ++log.counts.camera;
  if (log.observer) log.observer->begin({RayKind::kCamera, camera_ray, {1, 1, 1}});
  Hit hit;
  const bool found = log.clock.time([&] {
    return scene_.nearest(camera_ray, {0, scene_.scene().camera.reach()}, RayPurpose::kCamera, hit,
                          log.walks);
  });
  Radiance result;
  if (found) {
    result = {surface(camera_ray, hit, log), 1};
  } else {
    result = {background(camera_ray.direction), 0};
    if (log.observer) log.observer->receive(LightTerm::kBackground, result.color);
  }
  if (log.observer) log.observer->end();
  return result;
}

Color Appel::surface(const Ray& ray, const Hit& hit, RayLog& log) const {
  thread_local TextureSample sample;
  const SurfaceInteraction at = see(scene_, ray, hit, sample);
  if (log.observer) log.observer->meet(hit, at, sample);
  Color radiance;
  const MediaStack open;
  for (const TextureSample::Stack& stack : sample.stacks) {
    const Color share = Color{1, 1, 1} * stack.weight;
    radiance += share * local_.at({at, sample, stack, ray.direction, share, open}, log);
  }
  return radiance;
}

}  // namespace dioptre
