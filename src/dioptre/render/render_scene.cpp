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

TexturePoint RenderScene::texture_point(const SurfaceInteraction& at, Vec3 view,
                                        const TexturePlacement& placement) const {
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

/// Calls visit(texture, share, placement) for the textures that show at a surface: that of the
/// whole, or those of the shape's parts. An interior texture covers these.
template <class Visitor>
void RenderScene::for_each_texture(const SurfaceInteraction& at, const Ray& ray, const Hit& hit,
                                   bool from_inside, Visitor&& visit) const {
  const Part& part = *at.part;
  const TextureId whole = from_inside ? part.interior_texture : part.texture;
  const TexturePlacement& placement = placements_[part.placement];
  if (!part.has_part_textures || whole != part.texture) return visit(whole, 1.0f, placement);
  thread_local std::vector<TextureShare> shares;
  shares.clear();
  hit.item->shape->texture_shares(ray, hit.crossing, shares);
  if (shares.empty()) return visit(whole, 1.0f, placement);
  const std::vector<TextureId>& own = dioptre::at(scene_.objects, part.object).part_textures;
  for (const TextureShare& each : shares) {
    const auto share = static_cast<float>(each.share);
    if (each.part < own.size()) {
      visit(own[each.part], share, placements_[part.part_placement]);
    } else {
      visit(whole, share, placement);
    }
  }
}

void RenderScene::evaluate_texture(const SurfaceInteraction& at, const Ray& ray, const Hit& hit,
                                   bool from_inside, TextureSample& out) const {
  out.clear();
  for_each_texture(at, ray, hit, from_inside,
                   [&](TextureId texture, float share, const TexturePlacement& placement) {
                     append_texture(at, ray.direction, texture, share, placement, out);
                   });
}

void RenderScene::append_texture(const SurfaceInteraction& at, Vec3 view, TextureId texture,
                                 float share, const TexturePlacement& placement,
                                 TextureSample& out) const {
  const TexturePoint point = texture_point(at, view, placement);
  std::size_t i = out.layers.size();
  textures_->append(texture, share, point, out);
  if (!placement.moved) return;
  for (; i < out.layers.size(); ++i) {
    SurfaceLayer& layer = out.layers[i];
    layer.normal = layer.normal == point.normal
                       ? at.surface.shading_normal
                       : normalize(placement.to_object.covector(layer.normal));
  }
}

/// How much a surface gathers the light that comes through it along the normal, as thick glass
/// would: 1 + cos^(45 caustics) of the angle to the disturbed normal (measured).
float RenderScene::caustic(const SurfaceInteraction& facing, const Ray& ray, const Hit& hit,
                           bool leaving) const {
  const double caustics = dioptre::at(scene_.interiors, facing.part->interior).caustics;
  if (!(caustics > 0)) return 1;
  thread_local TextureSample sample;
  evaluate_texture(facing, ray, hit, leaving, sample);
  const double cosine = sample.layers.empty() ? dot(facing.surface.shading_normal, ray.direction)
                                              : dot(sample.layers.front().normal, ray.direction);
  return static_cast<float>(1 + std::pow(std::fabs(cosine), 45 * caustics));
}

Color RenderScene::surface_transmittance(const Ray& ray, const Hit& hit) const {
  SurfaceInteraction facing = interaction(ray, hit);
  if (dot(facing.surface.shading_normal, ray.direction) > 0) {
    facing.surface.shading_normal = -facing.surface.shading_normal;
  }
  const Part& part = *facing.part;
  const bool leaving = !hit.crossing.entering;
  Color through;
  for_each_texture(facing, ray, hit, leaving,
                   [&](TextureId texture, float share, const TexturePlacement& placement) {
                     const TexturePoint point = texture_point(facing, ray.direction, placement);
                     through += textures_->transmittance(texture, point) * share;
                   });
  if (!part.interior || is_black(through)) return through;
  return through * caustic(facing, ray, hit, leaving);
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
