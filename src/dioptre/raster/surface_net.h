// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/geometry/shape.h"
#include "dioptre/raster/faces.h"
#include "dioptre/raster/view_lattice.h"

namespace dioptre {

/// Where a line of a lattice meets a surface.
struct NetSample {
  std::uint64_t edge = 0;  ///< the piece of the line between two nodes
  Vec3 point, normal;      ///< in the world
};

/// One row of parallel lines of a lattice.
struct NetRow {
  std::size_t axis = 0;
  std::uint32_t number = 0;
};

/// All rows of a lattice.
std::vector<NetRow> net_rows(const ViewLattice& lattice);

/// Appends where the lines of a row meet the shape, in the order of their edges. Surfaces that
/// bound a solid but are not drawn count too: they close the net, and what is seen is decided
/// later.
void sample_row(const ViewLattice& lattice, const NetRow& row, const Shape& shape,
                std::vector<NetSample>& out);

/// Turns the samples of a surface into faces of about a cell in size: where an edge meets the
/// surface, a quadrilateral joins the four cells around the edge, each of which has one corner
/// where the surface in it is known best (Ju, Losasso, Schaefer and Warren 2002, "Dual contouring
/// of Hermite data"). Solids, sheets and surfaces within each other are the same to it.
FaceSet make_net(const ScreenView& view, const ViewLattice& lattice,
                 const std::vector<NetSample>& samples, std::uint32_t item);

}  // namespace dioptre
