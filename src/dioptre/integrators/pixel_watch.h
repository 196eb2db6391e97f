// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/film/layers.h"
#include "dioptre/integrators/ray_observer.h"
#include "dioptre/integrators/term_sample.h"

namespace dioptre {

/// Sorts the light of eye rays into Whitted's terms, and counts what of their cost the renderer
/// itself does not.
class PixelWatch final : public RayObserver {
 public:
  /// Notes only what `wanted` needs. The scene must outlive the watch.
  PixelWatch(const RenderScene& scene, LayerSet wanted);

  /// The terms of all eye rays since this was last asked.
  TermLight take_terms();
  /// The distance of the nearest surface that eye rays met since this was last asked.
  double take_depth();

  /// All crossings so far of the watched rays with items, between where they start and end.
  std::uint64_t spans() const { return spans_; }
  /// How long counting those took, in nanoseconds; noted only if the time is wanted.
  std::int64_t own_time() const { return own_time_; }

  void begin(const RayStart& start) override;
  void meet(const Hit& hit, const SurfaceInteraction& at, const TextureSample& texture) override;
  void receive(LightTerm term, Color light) override;
  void shadow(const ShadowRay& ray) override;
  void end() override;

 private:
  /// A ray that has begun and not yet ended.
  struct OpenRay {
    Ray ray;
    Vec3 weight;  ///< of its light in that of the eye ray
    LayerKind term = LayerKind::kAmbient;
    bool from_eye = false;
    bool met = false;  ///< a surface
  };

  void count_spans(const Ray& ray, Interval range);

  const RenderScene& scene_;
  bool terms_wanted_, spans_wanted_, time_wanted_;
  std::vector<OpenRay> open_;
  TermLight terms_{};
  double depth_ = kInfinity;
  std::uint64_t spans_ = 0;
  std::int64_t own_time_ = 0;
  Crossings crossings_;
};

}  // namespace dioptre
