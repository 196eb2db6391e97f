// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/raster/faces.h"
#include "dioptre/raster/placed_primitive.h"
#include "dioptre/raster/screen_view.h"

namespace dioptre {

/// Adds faces that stand closely around a primitive: a sphere, a cylinder, a cone or a torus. They
/// cover every pixel that shows it, however thin it is, and no point of it is nearer than their
/// reach says; what sticks out shows nothing. False, with nothing added, for other primitives and
/// for parameters that leave no such hull.
bool add_hull_faces(const ScreenView& view, const PlacedPrimitive& primitive, std::uint32_t item,
                    FaceSet& out);

}  // namespace dioptre
