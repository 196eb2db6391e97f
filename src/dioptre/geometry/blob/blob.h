// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A soft ball (a = b) or a soft cylinder from a to b, placed by `transform`.
struct BlobComponent {
  Vec3 a, b;
  bool cylinder = false;
  double radius = 1;
  double strength = 1;  ///< may be negative
  Affine transform;
  std::uint32_t texture =
      TextureShare::kWhole;  ///< index into Object::part_textures; none: the object's own
  bool operator==(const BlobComponent&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("a", self.a);
    visit("b", self.b);
    visit("cylinder", self.cylinder);
    visit("radius", self.radius);
    visit("strength", self.strength);
    visit("transform", self.transform);
    visit("texture", self.texture);
  }
};

/// The points where the sum of the components' fields reaches the threshold. The field of one
/// component is strength (1 - (d/radius)^2)^2 within its radius, d the distance to a point or to a
/// segment with round ends. Components of radius or strength 0 do nothing. Crossing::face is the
/// component whose field is the strongest there.
struct Blob {
  static constexpr const char* kName = "blob";
  double threshold = 1;
  std::vector<BlobComponent> components;
  bool sturm = false;

  bool operator==(const Blob&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("threshold", self.threshold);
    visit("components", self.components);
    visit("sturm", self.sturm);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error without
/// components, for a cylinder without length, a singular transform, or a number that is not finite.
Result<ShapePtr> prepare(const Blob& blob);

}  // namespace dioptre
