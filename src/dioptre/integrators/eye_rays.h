// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "dioptre/core/ray.h"
#include "dioptre/core/result.h"
#include "dioptre/film/camera_rays.h"
#include "dioptre/film/lens_samples.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// The rays from the camera of a scene, with the bumps of its normal, for one size of the image.
/// Immutable; used by all threads at once.
class EyeRays {
 public:
  /// The error says what is wrong with the camera. The scene must outlive the rays.
  static Result<EyeRays> prepare(const RenderScene& scene, std::uint32_t width,
                                 std::uint32_t height);

  /// The ray through a place of the image, in pixels, as CameraRays::ray has it.
  std::optional<Ray> ray(double x, double y, Vec2 lens = {0.5, 0.5},
                         std::uint32_t number = 0) const;

  /// How many rays a pixel is the mean of; 1 but for some mesh cameras.
  std::uint32_t rays_per_pixel() const { return camera_.rays_per_pixel(); }

  /// The mean over the rays of a pixel at a place: `sample(number)` gives a FilmSample or something
  /// derived from it, or nothing for a ray that is not shot and does not count.
  template <class Sample>
  auto mean(Sample&& sample) const {
    typename std::invoke_result_t<Sample&, std::uint32_t>::value_type sum{};
    sum.alpha = 0;
    std::uint32_t count = 0;
    for (std::uint32_t number = 0; number < rays_per_pixel(); ++number) {
      const auto one = sample(number);
      if (!one) continue;
      sum = sum + *one;
      ++count;
    }
    return count > 1 ? sum * (1.0f / static_cast<float>(count)) : sum;
  }

  /// The points of the lens that are looked through; null for a pinhole.
  const LensSamples* lens() const { return camera_.has_lens() ? &lens_ : nullptr; }

 private:
  EyeRays(const RenderScene& scene, CameraRays camera, std::uint32_t width, std::uint32_t height);

  const RenderScene& scene_;
  CameraRays camera_;
  LensSamples lens_;
  std::uint32_t width_, height_;
};

}  // namespace dioptre
