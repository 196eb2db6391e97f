// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/pixel_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dioptre/integrators/thread_time.h"

namespace dioptre {
namespace {

Vec3 to_vec(Color c) { return {c.r, c.g, c.b}; }

LayerKind term_of(LightTerm term) {
  switch (term) {
    case LightTerm::kDiffuse:
      return LayerKind::kDiffuse;
    case LightTerm::kHighlight:
      return LayerKind::kSpecular;
    case LightTerm::kBackground:
    case LightTerm::kAmbient:
      break;
  }
  return LayerKind::kAmbient;
}

/// Counts the crossings of a ray with the items it is offered.
class CrossingCounter final : public LeafVisitor {
 public:
  CrossingCounter(const std::vector<Item>& items, const Ray& ray, Crossings& crossings)
      : items_(items), ray_(ray), crossings_(crossings) {}

  bool visit(std::uint32_t item, Interval& range) override {
    crossings_.clear();
    items_[item].shape->crossings(ray_, range, crossings_);
    count += crossings_.size();
    return true;
  }

  std::uint64_t count = 0;

 private:
  const std::vector<Item>& items_;
  const Ray& ray_;
  Crossings& crossings_;
};

}  // namespace

PixelWatch::PixelWatch(const RenderScene& scene, LayerSet wanted)
    : scene_(scene),
      terms_wanted_(wanted.has_any(LayerSet::terms())),
      spans_wanted_(wanted.has(LayerKind::kSpans)),
      time_wanted_(wanted.has(LayerKind::kTime)) {}

TermLight PixelWatch::take_terms() { return std::exchange(terms_, {}); }

double PixelWatch::take_depth() { return std::exchange(depth_, kInfinity); }

void PixelWatch::begin(const RayStart& start) {
  OpenRay ray{start.ray, to_vec(start.share)};
  if (open_.empty()) {
    ray.from_eye = true;
  } else {
    const OpenRay& parent = open_.back();
    ray.weight = parent.weight * ray.weight;
    const LayerKind own =
        start.kind == RayKind::kReflected ? LayerKind::kReflected : LayerKind::kRefracted;
    ray.term = parent.from_eye ? own : parent.term;
  }
  open_.push_back(ray);
}

void PixelWatch::meet(const Hit& hit, const SurfaceInteraction&, const TextureSample&) {
  OpenRay& ray = open_.back();
  ray.met = true;
  if (ray.from_eye) depth_ = std::min(depth_, hit.crossing.t * length(ray.ray.direction));
  count_spans(ray.ray, {0, std::nextafter(hit.crossing.t, kInfinity)});
}

void PixelWatch::receive(LightTerm term, Color light) {
  if (!terms_wanted_) return;
  const OpenRay& ray = open_.back();
  const LayerKind kind = ray.from_eye ? term_of(term) : ray.term;
  terms_[static_cast<std::size_t>(kind)] += ray.weight * to_vec(light);
}

void PixelWatch::shadow(const ShadowRay& ray) { count_spans(ray.ray, ray.range); }

void PixelWatch::end() {
  const OpenRay ray = open_.back();
  open_.pop_back();
  if (!ray.met) count_spans(ray.ray, {0, kInfinity});
}

void PixelWatch::count_spans(const Ray& ray, Interval range) {
  if (!spans_wanted_) return;
  const std::int64_t begin = time_wanted_ ? thread_nanoseconds() : 0;
  CrossingCounter counter(scene_.items(), ray, crossings_);
  scene_.accelerator().visit(ray, range, counter);
  spans_ += counter.count;
  if (time_wanted_) own_time_ += thread_nanoseconds() - begin;
}

}  // namespace dioptre
