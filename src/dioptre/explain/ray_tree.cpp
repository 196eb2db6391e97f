// SPDX-License-Identifier: Apache-2.0
#include "dioptre/explain/ray_tree.h"

#include <algorithm>
#include <cmath>

namespace dioptre {
namespace {

Vec3 to_vec(Color c) { return {c.r, c.g, c.b}; }

/// Writes down what it is told.
class TreeBuilder final : public RayObserver {
 public:
  TreeBuilder(const RenderScene& scene, std::vector<TreeRay>& rays) : scene_(scene), rays_(rays) {}

  void begin(const RayStart& start) override {
    const auto index = static_cast<std::uint32_t>(rays_.size());
    TreeRay& ray = rays_.emplace_back();
    ray.start = start;
    if (!open_.empty()) {
      ray.parent = static_cast<std::int32_t>(open_.back());
      rays_[open_.back()].children.push_back(index);
    }
    open_.push_back(index);
  }

  void meet(const Hit& hit, const SurfaceInteraction& at, const TextureSample& texture) override {
    TreeRay& ray = rays_[open_.back()];
    const Ray& line = ray.start.ray;
    Meeting& meeting = ray.meeting.emplace();
    meeting.distance = hit.crossing.t * length(line.direction);
    meeting.position = at.surface.position;
    meeting.normal = at.surface.normal;
    meeting.shading_normal = at.surface.shading_normal;
    const double cosine = -dot(normalize(line.direction), at.surface.shading_normal);
    meeting.angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    meeting.object = at.part->object;
    meeting.item = static_cast<std::size_t>(hit.item - scene_.items().data());
    for (Hit part{{}, hit.item}; part.crossing.leaf < hit.item->part_count; ++part.crossing.leaf) {
      meeting.leaves.push_back(scene_.part(part).object);
    }
    meeting.stretches = csg::explain(*hit.item->shape, line, {0, kInfinity});
    meeting.layers = texture.layers;
  }

  void receive(LightTerm term, Color light) override {
    TreeRay& ray = rays_[open_.back()];
    if (is_black(light)) return;
    ray.received.push_back({term, to_vec(light)});
    ray.own += to_vec(light);
  }

  void shadow(const ShadowRay& shadow) override {
    std::vector<LightSeen>& lights = rays_[open_.back()].lights;
    if (lights.empty() || lights.back().light != shadow.light) {
      lights.push_back({.light = shadow.light});
    }
    LightSeen& seen = lights.back();
    ++seen.rays;
    const double share = 1.0 / seen.rays;
    seen.visible = (1 - share) * seen.visible + share * to_vec(shadow.visible);
    if (!shadow.blocker) return;
    ++seen.blocked;
    if (!seen.blocker) seen.blocker = scene_.first_part(*shadow.blocker).object;
  }

  void end() override {
    TreeRay& ray = rays_[open_.back()];
    open_.pop_back();
    ray.light += ray.own;
    if (ray.parent < 0) return;
    rays_[static_cast<std::size_t>(ray.parent)].light += to_vec(ray.start.share) * ray.light;
  }

 private:
  const RenderScene& scene_;
  std::vector<TreeRay>& rays_;
  std::vector<std::uint32_t> open_;
};

}  // namespace

double RayTree::gap() const {
  const Vec3 sum = rays.empty() ? Vec3{} : rays[0].light;
  const Vec3 wanted = to_vec(value);
  return max_component(abs(sum - wanted)) / std::max(1.0, max_component(abs(wanted)));
}

Result<RayTree> explain_pixel(const RenderScene& scene, const ExplainOptions& options) {
  if (options.column >= options.width || options.row >= options.height) {
    return fail("pixel " + std::to_string(options.column) + "," + std::to_string(options.row) +
                " is not in an image of " + std::to_string(options.width) + " x " +
                std::to_string(options.height) + "; columns and rows count from 0");
  }
  auto eye = EyeRays::prepare(scene, options.width, options.height);
  if (!eye) return tl::unexpected(eye.error());
  auto integrator = make_integrator(options.integrator, scene, options.integrator_options);
  if (!integrator) return tl::unexpected(integrator.error());
  const auto ray = eye->ray(options.column + 0.5, options.row + 0.5);
  if (!ray) return fail("the camera shows nothing at this pixel");
  if (eye->rays_per_pixel() > 1) {
    return fail("this camera shows the mean of several rays: there is no one tree to explain");
  }
  RayTree tree{options.column, options.row, options.width, options.height, {}, {}};
  RayLog plain;
  tree.value = (*integrator)->radiance(*ray, plain).color;
  TreeBuilder builder(scene, tree.rays);
  RayLog watched;
  watched.observer = &builder;
  (*integrator)->radiance(*ray, watched);
  return tree;
}

}  // namespace dioptre
