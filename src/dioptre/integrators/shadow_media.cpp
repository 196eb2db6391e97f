// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/shadow_media.h"

#include <algorithm>

#include "dioptre/integrators/atmosphere.h"
#include "dioptre/shading/attenuation.h"

namespace dioptre {
namespace {

bool fades(const Interior& interior) {
  return interior.fade_distance != 0 && interior.fade_power > 0;
}

/// Whether light comes through the item to be dimmed inside.
bool fades(const RenderScene& scene, const Item& item) {
  if (item.opaque || item.no_shadow) return false;
  Hit hit{{}, &item};
  for (; hit.crossing.leaf < item.part_count; ++hit.crossing.leaf) {
    const InteriorId interior = scene.part(hit).interior;
    if (interior && fades(at(scene.scene().interiors, interior))) return true;
  }
  return false;
}

}  // namespace

ShadowMedia::ShadowMedia(const RenderScene& scene) : scene_(scene) {
  any_fades_ = std::any_of(scene.items().begin(), scene.items().end(),
                           [&](const Item& item) { return fades(scene, item); });
  any_fog_ = !scene.scene().atmosphere.fogs.empty();
}

Color ShadowMedia::transmittance(const Ray& ray, Interval range, std::span<const Hit> hits,
                                 MediaStack media, bool in_fog) const {
  Color through{1, 1, 1};
  double last = 0;
  const auto pass_fog = [&](double end) {
    if (!in_fog || !media.in_atmosphere()) return;
    const Ray stretch{ray.at(last), ray.direction};
    through *= fog_effect(scene_, stretch, end - last).transmittance;
  };
  for (const Hit& hit : hits) {
    pass_fog(hit.crossing.t);
    const Part& part = scene_.part(hit);
    const InteriorId interior = part.interior;
    const MediaStack::Entry entry = MediaStack::entry(part, hit.item);
    if (media.contains(entry)) {
      media.leave(entry);
      if (interior && fades(at(scene_.scene().interiors, interior))) {
        through *= attenuation(at(scene_.scene().interiors, interior), hit.crossing.t - last);
      }
    } else if (hit.item->shape->solid()) {
      media.enter(entry, hit.item->hollow);
    }
    if (is_black(through)) return through;
    last = hit.crossing.t;
  }
  pass_fog(range.max);
  return through;
}

}  // namespace dioptre
