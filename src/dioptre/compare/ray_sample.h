// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"
#include "dioptre/core/result.h"
#include "dioptre/integrators/render_image.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// The sorts of rays that a comparison tells apart.
enum class RaySort : std::uint8_t { kEye, kShadow, kReflected, kTransmitted };
inline constexpr std::size_t kRaySorts = 4;
inline constexpr std::array kAllRaySorts{RaySort::kEye, RaySort::kShadow, RaySort::kReflected,
                                         RaySort::kTransmitted};

/// In words: "eye", "shadow", "reflected", "transmitted".
const char* name_of(RaySort sort);

/// How many there are of a sort.
std::uint64_t count_of(const RayCounts& rays, RaySort sort);

/// A ray as the renderer asks what it meets.
struct SampledRay {
  Ray ray;
  Interval range;
  RayPurpose purpose = RayPurpose::kCamera;
};

/// Rays of each sort, in the order in which one thread would trace them.
using RaySample = std::array<std::vector<SampledRay>, kRaySorts>;

/// Traces the picture once more, a ray through the centre of each pixel (or the samples of the
/// lens), and picks about `most` rays of each sort, or all if there are no more. `traced` tells how
/// many there were. The choice depends on nothing but the picture.
Result<RaySample> sample_rays(const RenderScene& scene, const RenderOptions& options,
                              const RayCounts& traced, std::size_t most);

}  // namespace dioptre
