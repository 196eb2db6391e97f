// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/eye_rays.h"

#include <utility>

namespace dioptre {

Result<EyeRays> EyeRays::prepare(const RenderScene& scene, std::uint32_t width,
                                 std::uint32_t height) {
  auto camera = CameraRays::prepare(scene.scene().camera);
  if (!camera) return tl::unexpected(camera.error());
  return EyeRays(scene, std::move(*camera), width, height);
}

EyeRays::EyeRays(const RenderScene& scene, CameraRays camera, std::uint32_t width,
                 std::uint32_t height)
    : scene_(scene),
      camera_(std::move(camera)),
      lens_(scene.scene().camera),
      width_(width),
      height_(height) {}

std::optional<Ray> EyeRays::ray(double x, double y, Vec2 lens, std::uint32_t number) const {
  const NormalId bumps = scene_.scene().camera.normal;
  if (!bumps) return camera_.ray(x, y, width_, height_, lens, number);
  auto ray = camera_.ray(x, y, width_, height_, lens, number);
  if (!ray) return ray;
  // Bumps are looked up by heights and widths from the centre, x to the right and y upwards
  // (measured).
  const Vec3 place{x / width_ - 0.5, 0.5 - y / height_, 0};
  ray->direction = scene_.textures().perturb(bumps, place, ray->direction);
  return ray;
}

}  // namespace dioptre
