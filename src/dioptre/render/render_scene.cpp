// SPDX-License-Identifier: Apache-2.0
#include "dioptre/render/render_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

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
    range.max = std::nextafter(crossing.t, kInfinity);
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

/// The product of what items let through, multiplied in the order of the items whatever the order
/// in which a ray meets them: rounding is then the same for every accelerator.
class FilterProduct {
 public:
  void add(std::uint32_t item, Color through) {
    if (count_ < first_.size()) {
      first_[count_++] = {item, through};
    } else {
      more_.push_back({item, through});
    }
  }

  Color product() {
    if (!more_.empty()) more_.insert(more_.end(), first_.begin(), first_.begin() + count_);
    const std::span<Filter> all = more_.empty() ? std::span(first_).first(count_) : std::span(more_);
    std::sort(all.begin(), all.end(),
              [](const Filter& a, const Filter& b) { return a.item < b.item; });
    Color through{1, 1, 1};
    for (const Filter& each : all) through *= each.through;
    return through;
  }

 private:
  struct Filter {
    std::uint32_t item;
    Color through;
  };
  std::array<Filter, 16> first_;
  std::vector<Filter> more_;
  std::uint32_t count_ = 0;
};

}  // namespace

bool RenderScene::nearest(const Ray& ray, Interval range, RayPurpose purpose, Hit& hit) const {
  hit.item = nullptr;
  NearestVisitor visitor(items_, ray, purpose, hit);
  accelerator_->visit(ray, range, visitor);
  return hit.item != nullptr;
}

SurfaceInteraction RenderScene::interaction(const Ray& ray, const Hit& hit) const {
  SurfaceInteraction at;
  at.surface = hit.item->shape->surface(ray, hit.crossing);
  at.part = &part(hit);
  // The error of t along the ray, and the rounding of origin + t * direction.
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const Vec3 p = abs(at.surface.position), o = abs(ray.origin);
  at.error = hit.crossing.error * length(ray.direction) +
             4 * kEpsilon * (max_component(p) + max_component(o));
  return at;
}

TexturePoint RenderScene::texture_point(const SurfaceInteraction& at, Vec3 view) const {
  const Placement& placement = placements_[at.part->placement];
  TexturePoint point{placement.to_object.point(at.surface.position),
                     normalize(placement.to_world.covector(at.surface.shading_normal)),
                     normalize(placement.to_object.vector(view)), at.surface.uv};
  if (at.part->uv_mapping) point.position = {point.uv.x, point.uv.y, 0};
  return point;
}

void RenderScene::evaluate_texture(const SurfaceInteraction& at, Vec3 view, bool from_inside,
                                   TextureSample& out) const {
  out.clear();
  const TexturePoint point = texture_point(at, view);
  textures_->evaluate(from_inside ? at.part->interior_texture : at.part->texture, point, out);
  const Placement& placement = placements_[at.part->placement];
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

Color RenderScene::item_transmittance(const Item& item, const Ray& ray, Interval range) const {
  Color through{1, 1, 1};
  Hit hit{{}, &item};
  while (item.shape->nearest(ray, range, hit.crossing)) {
    SurfaceInteraction facing = interaction(ray, hit);
    if (dot(facing.surface.shading_normal, ray.direction) > 0) {
      facing.surface.shading_normal = -facing.surface.shading_normal;
    }
    const Part& part = *facing.part;
    const bool leaving = !hit.crossing.entering;
    through *= textures_->transmittance(leaving ? part.interior_texture : part.texture,
                                        texture_point(facing, ray.direction));
    if (is_black(through)) return through;
    if (part.interior) through *= caustic(facing, ray.direction, leaving);
    range.min = hit.crossing.t;
  }
  return through;
}

Color RenderScene::transmittance(const Ray& ray, Interval range) const {
  FilterProduct filters;
  bool blocked = false;
  FunctionVisitor visitor([&](std::uint32_t index, Interval& r) {
    const Item& item = items_[index];
    if (item.no_shadow) return true;
    if (item.opaque) {
      Crossing crossing;
      blocked = item.shape->nearest(ray, r, crossing);
    } else {
      const Color through = item_transmittance(item, ray, r);
      blocked = is_black(through);
      if (!blocked && through != Color{1, 1, 1}) filters.add(index, through);
    }
    return !blocked;
  });
  accelerator_->visit(ray, range, visitor);
  return blocked ? Color{} : filters.product();
}

}  // namespace dioptre
