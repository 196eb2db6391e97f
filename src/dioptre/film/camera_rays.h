// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "dioptre/core/ray.h"
#include "dioptre/core/result.h"
#include "dioptre/core/vec.h"
#include "dioptre/film/mesh_rays.h"
#include "dioptre/scene/camera.h"

namespace dioptre {

/// Turns places on the image into rays. Immutable; used by all threads at once.
class CameraRays {
 public:
  /// Checks the camera: its vectors must be finite and span the view.
  static Result<CameraRays> prepare(const Camera& camera);

  /// The world-space ray, with a unit direction, through a place of an image of width x height
  /// pixels: (i + 0.5, j + 0.5) is the centre of pixel (i, j), and y grows downwards. `lens` is a
  /// place in the unit square around the lens, which is half of Camera::aperture wide (as measured
  /// with POV-Ray); (0.5, 0.5) is its centre. It matters only if has_lens(). Nothing where the
  /// projection shows nothing (outside the circle of a fisheye). `number` is that of the ray if
  /// there are several per pixel.
  std::optional<Ray> ray(double x, double y, std::uint32_t width, std::uint32_t height,
                         Vec2 lens = {0.5, 0.5}, std::uint32_t number = 0) const;

  /// Whether the camera has depth of field.
  bool has_lens() const { return camera_.aperture > 0 && !mesh_; }

  /// How many rays a pixel is the mean of, those that are not there left out.
  std::uint32_t rays_per_pixel() const { return mesh_ ? mesh_->rays_per_pixel() : 1; }

 private:
  explicit CameraRays(const Camera& camera);
  std::optional<Ray> pinhole(double x, double y) const;
  std::optional<Ray> through_lens(const Ray& pinhole, Vec2 lens) const;

  Camera camera_;
  Vec3 forward_;     ///< unit direction
  Vec3 right_, up_;  ///< unit vectors of the view
  double right_length_, up_length_;
  std::optional<MeshRays> mesh_;  ///< of the mesh kind
};

}  // namespace dioptre
