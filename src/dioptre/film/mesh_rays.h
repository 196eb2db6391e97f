// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "dioptre/core/ray.h"
#include "dioptre/core/result.h"
#include "dioptre/core/vec.h"
#include "dioptre/film/uv_faces.h"
#include "dioptre/scene/mesh_camera.h"

namespace dioptre {

/// Turns places on the image into rays from the faces of a mesh camera. Immutable; used by all
/// threads at once.
class MeshRays {
 public:
  /// An error for a mesh with indices that refer to nothing or numbers that are not finite, for
  /// fewer meshes than rays of a pixel that need one each.
  static Result<MeshRays> prepare(const MeshCamera& camera);

  /// World-space ray `number` of the pixel at a place of an image of width x height pixels, with a
  /// unit direction. Nothing where no face belongs to the place. Places are continuous, as in
  /// CameraRays::ray. As POV-Ray has it, the first row of faces is seen twice and the last not at
  /// all, and texture coordinates belong to the upper left corners of pixels (measured).
  std::optional<Ray> ray(double x, double y, std::uint32_t width, std::uint32_t height,
                         std::uint32_t number) const;

  /// Of one pixel: what they see is averaged.
  std::uint32_t rays_per_pixel() const { return rays_per_pixel_; }

 private:
  explicit MeshRays(const MeshCamera& camera);
  std::optional<Ray> from_face(std::size_t mesh, double face) const;
  std::optional<Ray> from_uv(Vec2 uv) const;
  std::optional<Ray> leaving(std::size_t mesh, Vec3 place, Vec3 normal) const;

  MeshCamera camera_;
  std::uint32_t rays_per_pixel_;
  std::vector<std::optional<Affine>> to_mesh_;  ///< inverses of the meshes' transforms
  UvFaces uv_faces_;
};

}  // namespace dioptre
