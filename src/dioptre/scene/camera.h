// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "dioptre/core/vec.h"
#include "dioptre/scene/ids.h"
#include "dioptre/scene/mesh_camera.h"

namespace dioptre {

/// The viewer, with look_at and angle already worked into the vectors.
struct Camera {
  enum class Kind : std::uint8_t {
    kPerspective,
    kOrthographic,
    kFisheye,
    kUltraWideAngle,
    kOmnimax,
    kPanoramic,
    kCylinder,
    kSpherical,
    kMesh,
  };
  Kind kind = Kind::kPerspective;
  Vec3 location;
  Vec3 direction{0, 0, 1};
  Vec3 right{1.33, 0, 0};
  Vec3 up{0, 1, 0};
  Vec3 sky{0, 1, 0};
  double angle = 0;           ///< degrees, of the wide-angle kinds
  double vertical_angle = 0;  ///< degrees, of the spherical kind
  std::uint32_t cylinder_type = 1;
  double aperture = 0;        ///< 0: everything is sharp
  double focal_distance = 1;  ///< along the unit direction
  std::uint32_t blur_samples = 9;
  std::uint32_t blur_samples_min = 0;
  double confidence = 0.9;
  double variance = 0.0078125;
  NormalId normal;
  MeshCamera mesh;  ///< all that counts for the mesh kind
  bool operator==(const Camera&) const = default;

  /// How far eye rays see.
  double reach() const {
    const bool limited = kind == Kind::kMesh && mesh.max_distance > 0;
    return limited ? mesh.max_distance : std::numeric_limits<double>::infinity();
  }

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("kind", self.kind);
    visit("location", self.location);
    visit("direction", self.direction);
    visit("right", self.right);
    visit("up", self.up);
    visit("sky", self.sky);
    visit("angle", self.angle);
    visit("vertical_angle", self.vertical_angle);
    visit("cylinder_type", self.cylinder_type);
    visit("aperture", self.aperture);
    visit("focal_distance", self.focal_distance);
    visit("blur_samples", self.blur_samples);
    visit("blur_samples_min", self.blur_samples_min);
    visit("confidence", self.confidence);
    visit("variance", self.variance);
    visit("normal", self.normal);
    visit("mesh", self.mesh);
  }
};

}  // namespace dioptre
