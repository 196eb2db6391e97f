// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "dioptre/geometry/bicubic_patch/bicubic_patch.h"
#include "dioptre/geometry/blob/blob.h"
#include "dioptre/geometry/box/box.h"
#include "dioptre/geometry/cone/cone.h"
#include "dioptre/geometry/cylinder/cylinder.h"
#include "dioptre/geometry/disc/disc.h"
#include "dioptre/geometry/height_field/height_field.h"
#include "dioptre/geometry/isosurface/isosurface.h"
#include "dioptre/geometry/julia_fractal/julia_fractal.h"
#include "dioptre/geometry/lathe/lathe.h"
#include "dioptre/geometry/mesh/mesh.h"
#include "dioptre/geometry/ovus/ovus.h"
#include "dioptre/geometry/plane/plane.h"
#include "dioptre/geometry/poly/poly.h"
#include "dioptre/geometry/polygon/polygon.h"
#include "dioptre/geometry/prism/prism.h"
#include "dioptre/geometry/quadric/quadric.h"
#include "dioptre/geometry/sor/sor.h"
#include "dioptre/geometry/sphere/sphere.h"
#include "dioptre/geometry/sphere_sweep/sphere_sweep.h"
#include "dioptre/geometry/superellipsoid/superellipsoid.h"
#include "dioptre/geometry/text/text.h"
#include "dioptre/geometry/torus/torus.h"
#include "dioptre/geometry/triangle/triangle.h"

namespace dioptre {

/// The one list of primitives. A new primitive adds its folder and its name here; laws, JSON and
/// the compiler then know it.
using ShapeData =
    std::variant<Sphere, Box, Plane, Cylinder, Cone, Torus, Disc, Quadric, Poly, Triangle, Mesh,
                 Polygon, Prism, Blob, Text, Superellipsoid, Lathe, Sor, SphereSweep, Ovus,
                 HeightField, Isosurface, BicubicPatch, JuliaFractal>;

/// Prepares whichever primitive it is; those that have a `prepare` with options are told them.
inline Result<ShapePtr> prepare_with(const ShapeOptions& options, const ShapeData& data) {
  return std::visit(
      [&options](const auto& shape) {
        if constexpr (requires { prepare(shape, options); }) {
          return prepare(shape, options);
        } else {
          return prepare(shape);
        }
      },
      data);
}

/// The same with the usual options.
inline Result<ShapePtr> prepare(const ShapeData& data) { return prepare_with({}, data); }

}  // namespace dioptre
