// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/raster/faces.h"
#include "dioptre/raster/placed_primitive.h"
#include "dioptre/raster/screen_view.h"
#include "dioptre/raster/view_lattice.h"

namespace dioptre {

/// What came of adding the faces of a primitive.
enum class FlatFaces {
  kAdded,
  kCurved,   ///< its surface is not flat, or too intricate to be cut into triangles
  kTooMany,  ///< the set has no room for them
};

/// Adds the faces of a primitive that has a flat surface: a triangle, a mesh, a polygon, a box, a
/// disc or a plane. A plane becomes a square far larger than the scene; a disc, a ring that is
/// slightly larger than it. All other faces are exact.
FlatFaces add_flat_faces(const ScreenView& view, const PlacedPrimitive& primitive,
                         const ViewScale& scale, std::uint32_t item, FaceSet& out);

}  // namespace dioptre
