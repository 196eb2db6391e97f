// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/screen_view.h"

#include "dioptre/film/camera_rays.h"

namespace dioptre {

Result<ScreenView> ScreenView::prepare(const Camera& camera, std::uint32_t width,
                                       std::uint32_t height) {
  if (camera.kind != Camera::Kind::kPerspective && camera.kind != Camera::Kind::kOrthographic) {
    return fail("zbuffer projects faces for a perspective or an orthographic camera only");
  }
  if (camera.normal) return fail("zbuffer cannot bend its view by the camera's normal");
  if (camera.aperture > 0) return fail("zbuffer has no focal blur: its camera is a pinhole");
  if (width == 0 || height == 0) return fail("an image without pixels cannot be rendered");
  if (auto valid = CameraRays::prepare(camera); !valid) return tl::unexpected(valid.error());
  ScreenView view;
  view.perspective_ = camera.kind == Camera::Kind::kPerspective;
  view.width_ = width, view.height_ = height;
  const Vec3 corner = 0.5 * (camera.up - camera.right);
  view.to_world_.x = camera.right / width;
  view.to_world_.y = -camera.up / height;
  view.to_world_.z = view.perspective_ ? camera.direction + corner : normalize(camera.direction);
  view.to_world_.o = view.perspective_ ? camera.location : camera.location + corner;
  const auto inverted = inverse(view.to_world_);
  if (!inverted) return fail("the camera's view is too flat to project faces");
  view.to_view_ = *inverted;
  return view;
}

}  // namespace dioptre
