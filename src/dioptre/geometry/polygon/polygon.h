// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// How a point of the plane is told to be inside a polygon.
enum class PolygonTest : std::uint8_t {
  kCrossings,  ///< a line from it to infinity crosses the outlines an odd number of times
  kAngles,     ///< see inside_by_angles
};

/// A planar polygon of any shape, with holes: a sheet. Each outline is closed (its first point
/// need not be repeated); a point is inside where an odd number of outlines is around it.
///
/// The plane is that of the first outline's first three points that are not on one line, and its
/// normal their cross product; other points are moved into it along the normal's longest axis.
/// Outlines on one line make an empty shape.
struct Polygon {
  static constexpr const char* kName = "polygon";
  std::vector<std::vector<Vec3>> outlines;
  PolygonTest test = PolygonTest::kCrossings;

  bool operator==(const Polygon&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("outlines", self.outlines);
    visit("test", self.test);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for fewer than
/// three points in an outline, or a point that is not finite.
Result<ShapePtr> prepare(const Polygon& polygon);

}  // namespace dioptre
