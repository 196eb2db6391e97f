// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "dioptre/geometry/bicubic_patch/bicubic_patch.h"

namespace dioptre {

/// A part of a patch that is drawn as two triangles: the corners of the first row, then those of
/// the last one.
struct PatchPiece {
  std::array<Vec3, 4> corners;
  float column = 0, row = 0;  ///< where its first corner is, in parts of the patch
  float columns = 1, rows = 1;

  /// The triangle of a face: 0 lies at the first row, 1 at the last one.
  std::array<std::size_t, 3> triangle(std::size_t face) const {
    return face == 0 ? std::array<std::size_t, 3>{0, 1, 3} : std::array<std::size_t, 3>{0, 3, 2};
  }
  /// Where a corner is, in parts of the patch: (column, row).
  Vec2 place(std::size_t corner) const {
    return {double{column} + (corner & 1 ? double{columns} : 0),
            double{row} + (corner & 2 ? double{rows} : 0)};
  }
};

/// The pieces of a patch; nothing if there are more than `most`.
std::optional<std::vector<PatchPiece>> patch_pieces(const BicubicPatch& patch, std::size_t most);

/// The normal of the exact surface at a place (column, row) in [0,1]^2; x where it has none
/// (measured).
Vec3 patch_normal(const BicubicPatch& patch, Vec2 place);

}  // namespace dioptre
