// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/core/bounds.h"
#include "dioptre/core/result.h"
#include "dioptre/geometry/blob/blob.h"
#include "dioptre/geometry/outline/bernstein.h"

namespace dioptre {

/// One component in its unit space: radius 1; a ball at the origin, or the points around the
/// segment from the origin to (0, 0, length).
struct FieldComponent {
  Affine to_unit;     ///< from the blob's space
  double length = 0;  ///< 0 for a ball
  double strength = 1;
  std::uint32_t index = 0;                       ///< in Blob::components
  std::uint32_t texture = TextureShare::kWhole;  ///< as BlobComponent has it
  Bounds bounds;                                 ///< of its influence, in the blob's space
};

/// A stretch of a ray on which one component's squared distance is one quadratic of t.
struct FieldPiece {
  double begin = 0, end = 0;
  Ray ray;  ///< in unit space; the distance is that from the origin, of a body that in x and y
  double strength = 1;
  std::uint32_t index = 0;  ///< in Blob::components

  /// The piece's field on [ta, tb], as a polynomial on [0,1].
  Bernstein<4> field(double ta, double tb) const;
};

/// The components that have an influence (neither radius nor strength 0). An error for a number
/// that is not finite, a cylinder without length, or a singular transform.
Result<std::vector<FieldComponent>> field_components(const Blob& blob);

/// Appends the pieces of a component along the ray (at most three, joined end to end).
void append_pieces(const FieldComponent& component, const Ray& ray,
                   std::vector<FieldPiece>& pieces);

/// The field of a component at p (blob space), and its gradient added to `gradient` if asked for.
double field_at(const FieldComponent& component, Vec3 p, Vec3* gradient = nullptr);

}  // namespace dioptre
