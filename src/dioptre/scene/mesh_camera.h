// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/core/shared.h"
#include "dioptre/geometry/mesh/mesh.h"

namespace dioptre {

/// One of the meshes that a mesh camera looks out of.
struct CameraMesh {
  Shared<MeshData> data;
  Affine transform;  ///< to the world
  bool operator==(const CameraMesh&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("data", self.data);
    visit("transform", self.transform);
  }
};

/// A camera whose pixels look along the normals of faces, each from the centroid of one. Pixels
/// are counted along the rows, from the top left; faces in the order of their mesh.
struct MeshCamera {
  enum class Distribution : std::uint8_t {
    kEach,  ///< ray k of a pixel leaves the pixel's face of mesh k
    kSum,   ///< the faces of all meshes in a row; more rays per pixel change nothing (measured)
    kSideBySide,  ///< each mesh has a column of the image of its own, the first on the left
    kUv,          ///< the place on the image is a texture coordinate of the face it leaves
  };
  Distribution distribution = Distribution::kEach;
  std::uint32_t rays_per_pixel = 1;
  double max_distance = 0;  ///< how far rays see that leave faces; 0: no limit
  double offset = 0;        ///< of the rays' origins from the faces, along the normals
  bool backwards = false;   ///< rays run against the normals
  bool smooth = false;      ///< kUv: normals are interpolated
  std::vector<CameraMesh> meshes;
  bool operator==(const MeshCamera&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("distribution", self.distribution);
    visit("rays_per_pixel", self.rays_per_pixel);
    visit("max_distance", self.max_distance);
    visit("offset", self.offset);
    visit("backwards", self.backwards);
    visit("smooth", self.smooth);
    visit("meshes", self.meshes);
  }
};

}  // namespace dioptre
