// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dioptre/core/color.h"
#include "dioptre/core/vec.h"
#include "dioptre/lights/light_shape.h"
#include "dioptre/scene/light.h"

namespace dioptre {

/// What arrives at a point from one light if nothing is in between.
struct Illumination {
  Vec3 to_light;  ///< unit
  /// To the light, or to the plane where its parallel rays begin. Parallel light also shines behind
  /// that plane, without shadows; there the distance is negative (measured).
  double distance = 0;
  Color intensity;  ///< not black
};

/// A light prepared for shading. The formulas are those of scene files: 2 / (1 + (d/fd)^power)
/// fading, cos^tightness spots with a smooth edge in the cosine, cylinders with parallel rays.
class LightSource {
 public:
  explicit LightSource(const Light& light);

  const Light& light() const { return light_; }

  /// The light at a point, or nothing where the light does not reach.
  std::optional<Illumination> illuminate(Vec3 point) const { return from(light_.location, point); }

  /// The same for one sample of an area light.
  std::optional<Illumination> from(Vec3 location, Vec3 point) const;

  /// Where sample (i, j) of an area light stands, as seen from a point; i < size1, j < size2.
  Vec3 sample(std::uint32_t i, std::uint32_t j, Vec3 seen_from) const;

  /// Where (u, v) of the unit square lies on an area light that is taken for a shape other than the
  /// grid, as seen from a point.
  Vec3 shape_point(LightShape shape, double u, double v, Vec3 seen_from) const;

 private:
  std::array<Vec3, 2> area_axes(Vec3 seen_from) const;
  double cone(Vec3 to_light) const;
  double beam(Vec3 point) const;

  Light light_;
  Vec3 axis_;  ///< unit, from location to point_at
  double cos_radius_ = 0, cos_falloff_ = 0;
};

}  // namespace dioptre
