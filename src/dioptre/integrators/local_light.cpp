// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/local_light.h"

#include "dioptre/shading/finish.h"

namespace dioptre {
namespace {

Vec3 facing(Vec3 normal, Vec3 direction) { return dot(normal, direction) > 0 ? -normal : normal; }

/// Lights of a group shine on that group alone; the others on what is in no group or in one that
/// lets them in.
bool lights(const Light& light, const Part& part) {
  return light.group == part.light_group || (light.group == 0 && part.global_lights);
}

}  // namespace

SurfaceInteraction see(const RenderScene& scene, const Ray& ray, const Hit& hit,
                       TextureSample& out) {
  SurfaceInteraction at = scene.interaction(ray, hit);
  const bool from_inside = dot(at.surface.normal, ray.direction) > 0;
  at.surface.normal = facing(at.surface.normal, ray.direction);
  at.surface.shading_normal = facing(at.surface.shading_normal, ray.direction);
  scene.evaluate_texture(at, ray, hit, from_inside, out);
  return at;
}

LocalLight::LocalLight(const RenderScene& scene, const IntegratorOptions& options)
    : direct_(scene, options),
      ambient_light_(scene.scene().settings.ambient_light),
      films_(scene.scene().settings) {}

Color LocalLight::at(const SeenPoint& point, RayLog& log) const {
  Color radiance;
  Color filter{1, 1, 1};
  for (std::uint32_t i = 0; i < point.stack.count; ++i) {
    radiance += filter * glow(point.layer(i), ambient_light_);
    filter *= point.layer(i).pigment.transmittance();
  }
  if (log.observer) log.observer->receive(LightTerm::kAmbient, point.share * radiance);
  for (const LightSource& light : direct_.lights()) {
    if (lights(light.light(), *point.at.part)) radiance += of_source(light, point, log);
  }
  return radiance;
}

/// The light of one source, shaded by every layer of the stack. The shadow is looked for once, and
/// only if a layer can show the light.
Color LocalLight::of_source(const LightSource& light, const SeenPoint& point, RayLog& log) const {
  const SurfaceInteraction& at = point.at;
  const auto illumination = light.illuminate(at.surface.position);
  if (!illumination) return {};
  ReflectedLight reflected;
  Color filter{1, 1, 1};
  for (std::uint32_t i = 0; i < point.stack.count; ++i) {
    const SurfaceLayer& layer = point.layer(i);
    const LightGeometry geometry{layer.normal, -point.direction, illumination->to_light};
    ReflectedLight own =
        reflected_light(layer, geometry, at.part->double_illuminate, light.light().shadowless);
    if (layer.finish->irid != 0) {
      const double cosines = dot(layer.normal, geometry.to_light + geometry.to_viewer);
      const Color tint = films_.tint(*layer.finish, at.surface.position, cosines);
      own.diffuse *= tint;
      own.highlights *= tint;
    }
    reflected.diffuse += filter * own.diffuse;
    reflected.highlights += filter * own.highlights;
    filter *= layer.pigment.transmittance();
  }
  if (is_black(reflected.sum())) return {};
  const Color arriving =
      illumination->intensity * direct_.visibility(light, *illumination, {at, point.around}, log);
  if (log.observer) {
    const Color share = point.share * arriving;
    log.observer->receive(LightTerm::kDiffuse, share * reflected.diffuse);
    log.observer->receive(LightTerm::kHighlight, share * reflected.highlights);
  }
  return reflected.sum() * arriving;
}

}  // namespace dioptre
