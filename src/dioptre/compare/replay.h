// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "dioptre/accel/accelerator.h"
#include "dioptre/compare/ray_sample.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// What asking came to.
struct Walks {
  WalkCost cost;
  std::uint64_t answers = 0;  ///< a digest of what each ray met, and where
};

/// Asks what each ray meets.
Walks walk_all(const RenderScene& scene, std::span<const SampledRay> rays);

/// The time for one of the rays, in nanoseconds: the mean over all of them, walked over and over
/// until `least_seconds` have gone by.
double time_walks(const RenderScene& scene, std::span<const SampledRay> rays, double least_seconds);

}  // namespace dioptre
