// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "dioptre/core/affine.h"
#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// A Bezier patch of degree 3 x 3, drawn as triangles with smoothed normals: a sheet.
///
/// The flatness is a length in the space where the patch is prepared: a renderer moves a patch to
/// the world first (see transformed). The patch is halved u_steps times between its rows and
/// v_steps times between its columns; a piece that is flat enough is not halved further. Each piece
/// is two triangles, parted by the line from its first corner to its last, with the normals of the
/// exact surface at their corners. The front is that to which cross(d/drow, d/dcolumn) points.
struct BicubicPatch {
  static constexpr const char* kName = "bicubic_patch";
  std::array<Vec3, 16> points{};  ///< four rows of four; the patch goes through the outer corners
  std::uint32_t u_steps = 0;
  std::uint32_t v_steps = 0;
  /// A piece is flat if its control points are no further than this from the plane through three of
  /// its corners; 0 or less: pieces are always halved.
  double flatness = 0;
  /// The texture coordinates of the corners, around the patch: first row's first and last point,
  /// last row's last and first.
  std::array<Vec2, 4> uv_corners{Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}};

  bool operator==(const BicubicPatch&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("points", self.points);
    visit("u_steps", self.u_steps);
    visit("v_steps", self.v_steps);
    visit("flatness", self.flatness);
    visit("uv_corners", self.uv_corners);
  }
};

/// The patch whose control points are those of `patch` moved. Not the moved pieces of that patch:
/// how flat they are is measured where the patch is drawn.
inline BicubicPatch transformed(BicubicPatch patch, const Affine& by) {
  for (Vec3& point : patch.points) point = by.point(point);
  return patch;
}

/// Makes the triangles. An error for a number that is not finite and for more than 2^18 pieces.
Result<ShapePtr> prepare(const BicubicPatch& patch, const ShapeOptions& options = {});

}  // namespace dioptre
