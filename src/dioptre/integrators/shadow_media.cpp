// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/shadow_media.h"

#include <algorithm>

#include "dioptre/integrators/atmosphere.h"
#include "dioptre/integrators/media_stack.h"
#include "dioptre/shading/attenuation.h"

namespace dioptre {
namespace {

bool fades(const Interior& interior) {
  return interior.fade_distance != 0 && interior.fade_power > 0;
}

}  // namespace

ShadowMedia::ShadowMedia(const RenderScene& scene) : scene_(scene) {
  const Scene& plain = scene.scene();
  any_fades_ = std::any_of(plain.interiors.begin(), plain.interiors.end(), fades);
  any_fog_ = !plain.atmosphere.fogs.empty();
}

Color ShadowMedia::transmittance(const Ray& ray, double distance, bool in_fog) const {
  Color through{1, 1, 1};
  MediaStack media;
  Interval range{0, distance};
  const auto pass_fog = [&](double end) {
    if (!in_fog || !media.in_atmosphere()) return;
    const Ray stretch{ray.at(range.min), ray.direction};
    through *= fog_effect(scene_, stretch, end - range.min).transmittance;
  };
  Hit hit;
  while (scene_.nearest(ray, range, RayPurpose::kShadow, hit)) {
    pass_fog(hit.crossing.t);
    const InteriorId interior = scene_.part(hit).interior;
    const MediaStack::Entry entry = MediaStack::entry(interior, hit.item);
    if (media.contains(entry)) {
      media.leave(entry);
      if (interior && fades(at(scene_.scene().interiors, interior))) {
        through *= attenuation(at(scene_.scene().interiors, interior), hit.crossing.t - range.min);
      }
    } else if (hit.item->shape->solid()) {
      media.enter(entry, hit.item->hollow);
    }
    if (is_black(through)) return through;
    range.min = hit.crossing.t;
  }
  pass_fog(distance);
  return through;
}

}  // namespace dioptre
