// SPDX-License-Identifier: Apache-2.0
#include "dioptre/render/render_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre {
namespace {

bool hidden(const Item& item, RayPurpose purpose) {
  switch (purpose) {
    case RayPurpose::kCamera:
      return item.no_image;
    case RayPurpose::kReflection:
      return item.no_reflection;
    case RayPurpose::kShadow:
      return item.no_shadow;
  }
  return false;
}

/// Keeps the first crossing of all items offered.
class NearestVisitor final : public LeafVisitor {
 public:
  NearestVisitor(const std::vector<Item>& items, const Ray& ray, RayPurpose purpose, Hit& hit)
      : items_(items), ray_(ray), purpose_(purpose), hit_(hit) {}

  bool visit(std::uint32_t index, Interval& range) override {
    const Item& item = items_[index];
    Crossing crossing;
    if (hidden(item, purpose_) || !item.shape->nearest(ray_, range, crossing)) return true;
    // Of two items at the same distance the first in the file wins, whatever the order of visits.
    if (hit_.item && crossing.t == hit_.crossing.t && hit_.item < &item) return true;
    hit_ = {crossing, &item};
    range.max = just_above(crossing.t);
    return true;
  }

 private:
  const std::vector<Item>& items_;
  const Ray& ray_;
  RayPurpose purpose_;
  Hit& hit_;
};

template <class Function>
class FunctionVisitor final : public LeafVisitor {
 public:
  explicit FunctionVisitor(Function function) : function_(std::move(function)) {}
  bool visit(std::uint32_t item, Interval& range) override { return function_(item, range); }

 private:
  Function function_;
};

}  // namespace

bool RenderScene::nearest(const Ray& ray, Interval range, RayPurpose purpose, Hit& hit) const {
  WalkCost ignored;
  return nearest(ray, range, purpose, hit, ignored);
}

bool RenderScene::nearest(const Ray& ray, Interval range, RayPurpose purpose, Hit& hit,
                          WalkCost& cost) const {
  hit.item = nullptr;
  NearestVisitor visitor(items_, ray, purpose, hit);
  accelerator_->visit(ray, range, visitor, cost);
  return hit.item != nullptr;
}

SurfaceInteraction RenderScene::interaction(const Ray& ray, const Hit& hit) const {
  SurfaceInteraction at;
  at.surface = hit.item->shape->surface(ray, hit.crossing);
  at.part = &part(hit);
  if (at.part->needs.uv) at.uv = hit.item->shape->uv(ray, hit.crossing);
  // The error of t along the ray, the rounding of the ray in the space of the shape (8 epsilon of
  // its coordinates, in each of three), and that of origin + t * direction.
  constexpr double kRounding = 32 * std::numeric_limits<double>::epsilon();
  const Vec3 p = abs(at.surface.position), o = abs(ray.origin);
  at.error = hit.crossing.error * length(ray.direction) +
             kRounding * (max_component(p) + max_component(o));
  return at;
}

TexturePoint RenderScene::texture_point(const SurfaceInteraction& at, Vec3 view) const {
  const TexturePlacement& placement = placements_[at.part->placement];
  TexturePoint point{at.surface.position, at.surface.shading_normal, view, at.uv};
  if (placement.moved) {
    point.position = placement.to_object.point(point.position);
    if (at.part->needs.surface) {
      point.normal = normalize(placement.to_world.covector(point.normal));
      point.view = normalize(placement.to_object.vector(point.view));
    }
  }
  if (at.part->uv_mapping) point.position = {point.uv.x, point.uv.y, 0};
  return point;
}

void RenderScene::evaluate_texture(const SurfaceInteraction& at, Vec3 view, bool from_inside,
                                   TextureSample& out) const {
  out.clear();
  const TexturePoint point = texture_point(at, view);
  textures_->evaluate(from_inside ? at.part->interior_texture : at.part->texture, point, out);
  const TexturePlacement& placement = placements_[at.part->placement];
  if (!placement.moved) return;
  for (SurfaceLayer& layer : out.layers) {
    layer.normal = layer.normal == point.normal
                       ? at.surface.shading_normal
                       : normalize(placement.to_object.covector(layer.normal));
  }
}

/// How much a surface gathers the light that comes through it along the normal, as thick glass
/// would: 1 + cos^(45 caustics) of the angle to the disturbed normal (measured).
float RenderScene::caustic(const SurfaceInteraction& facing, Vec3 direction, bool leaving) const {
  const double caustics = dioptre::at(scene_.interiors, facing.part->interior).caustics;
  if (!(caustics > 0)) return 1;
  thread_local TextureSample sample;
  evaluate_texture(facing, direction, leaving, sample);
  const double cosine = sample.layers.empty() ? dot(facing.surface.shading_normal, direction)
                                              : dot(sample.layers.front().normal, direction);
  return static_cast<float>(1 + std::pow(std::fabs(cosine), 45 * caustics));
}

Color RenderScene::surface_transmittance(const Ray& ray, const Hit& hit) const {
  SurfaceInteraction facing = interaction(ray, hit);
  if (dot(facing.surface.shading_normal, ray.direction) > 0) {
    facing.surface.shading_normal = -facing.surface.shading_normal;
  }
  const Part& part = *facing.part;
  const bool leaving = !hit.crossing.entering;
  const Color through = textures_->transmittance(leaving ? part.interior_texture : part.texture,
                                                 texture_point(facing, ray.direction));
  if (!part.interior || is_black(through)) return through;
  return through * caustic(facing, ray.direction, leaving);
}

bool RenderScene::shadow_hits(const Ray& ray, Interval range, std::vector<Hit>& hits,
                              const Item*& blocker) const {
  WalkCost ignored;
  return shadow_hits(ray, range, hits, blocker, ignored);
}

bool RenderScene::shadow_hits(const Ray& ray, Interval range, std::vector<Hit>& hits,
                              const Item*& blocker, WalkCost& cost) const {
  thread_local Crossings crossings;
  Crossing nearest;
  if (blocker && blocker->shape->nearest(ray, range, nearest)) return false;
  hits.clear();
  blocker = nullptr;
  FunctionVisitor visitor([&](std::uint32_t index, Interval& r) {
    const Item& item = items_[index];
    if (item.no_shadow) return true;
    if (item.opaque) {
      if (item.shape->nearest(ray, r, nearest)) blocker = &item;
      return blocker == nullptr;
    }
    crossings.clear();
    item.shape->crossings(ray, r, crossings);
    for (const Crossing& crossing : crossings) {
      if (crossing.visible) hits.push_back({crossing, &item});
    }
    return true;
  });
  accelerator_->visit(ray, range, visitor, cost);
  if (blocker || hits.size() < 2) return blocker == nullptr;
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return a.crossing.t != b.crossing.t ? a.crossing.t < b.crossing.t : a.item < b.item;
  });
  double last = -kInfinity;
  std::erase_if(hits, [&](const Hit& hit) {
    if (hit.crossing.t <= last + shadow_gap_) return true;
    last = hit.crossing.t;
    return false;
  });
  return true;
}

}  // namespace dioptre
