// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "dioptre/core/vec.h"

namespace dioptre {

/// What an area light is taken for.
enum class LightShape : std::uint8_t {
  kGrid,       ///< point lights in rows, as scene files have it
  kRectangle,  ///< the parallelogram of both axes
  kDisc,       ///< the ellipse within it
  kSphere,     ///< around its middle, as wide as the axes are long in the mean
};

/// By their numbers.
inline constexpr std::array<std::string_view, 4> kLightShapeNames{"grid", "rectangle", "disc",
                                                                  "sphere"};

/// Where (u, v) of the unit square lies in the disc of radius 1/2 around the origin, areas in
/// proportion (P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", 1997).
Vec2 disc_point(double u, double v);

/// Where (u, v) of the unit square lies on the part of a sphere that is seen from a point, solid
/// angles in proportion (P. Shirley, C. Wang and K. Zimmerman, "Monte Carlo Techniques for Direct
/// Lighting Calculations", 1996). The center, if the point is not outside.
Vec3 sphere_point(Vec3 center, double radius, Vec3 seen_from, double u, double v);

}  // namespace dioptre
