// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/surface_net.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dioptre {
namespace {

constexpr std::uint32_t kBits = 20;  ///< of a cell's number along an axis; one more than it is
constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;

std::uint64_t key(const std::array<std::uint64_t, 3>& cell) {
  return (cell[2] << (2 * kBits)) | (cell[1] << kBits) | cell[0];
}

std::array<std::uint64_t, 3> cell_of(std::uint64_t key) {
  return {key & kMask, (key >> kBits) & kMask, (key >> (2 * kBits)) & kMask};
}

std::uint64_t edge_key(std::size_t axis, const std::array<std::uint64_t, 3>& cell) {
  return (std::uint64_t{axis} << (3 * kBits)) | key(cell);
}

/// The cells around an edge, in turn. Nodes and cells of the same number share their least corner.
std::array<std::uint64_t, 4> cells_around(std::uint64_t edge) {
  const std::size_t axis = edge >> (3 * kBits);
  const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  std::array<std::uint64_t, 4> keys;
  for (std::size_t i = 0; i < 4; ++i) {
    auto cell = cell_of(edge);
    if (i == 1 || i == 2) --cell[u];
    if (i >= 2) --cell[v];
    keys[i] = key(cell);
  }
  return keys;
}

/// A sample as one cell sees it.
struct CellSample {
  std::uint64_t cell;
  std::uint32_t sample;
  bool operator<(const CellSample& b) const {
    return cell != b.cell ? cell < b.cell : sample < b.sample;
  }
};

/// The point with the least squared distances from the tangent planes of the samples, and slightly
/// from their mean, where the planes leave it free.
Vec3 best_point(const std::vector<NetSample>& samples, std::span<const CellSample> of_cell) {
  constexpr double kPull = 1e-3;
  const double number = static_cast<double>(of_cell.size());
  Vec3 mean;
  for (const CellSample& each : of_cell) mean += samples[each.sample].point;
  mean = mean / number;
  const double pull = kPull * number;
  Vec3 x{pull, 0, 0}, y{0, pull, 0}, z{0, 0, pull}, right;
  for (const CellSample& each : of_cell) {
    const NetSample& sample = samples[each.sample];
    const Vec3 n = sample.normal;
    if (!is_finite(n)) continue;
    x += n.x * n, y += n.y * n, z += n.z * n;
    right += dot(n, sample.point - mean) * n;
  }
  // The matrix is symmetric: Cramer's rule with its rows.
  const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  const Vec3 offset = Vec3{dot(right, yz), dot(right, zx), dot(right, xy)} / dot(x, yz);
  return is_finite(offset) ? mean + offset : mean;
}

std::vector<CellSample> by_cell(const std::vector<NetSample>& samples) {
  std::vector<CellSample> entries;
  entries.reserve(4 * samples.size());
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    for (const std::uint64_t cell : cells_around(samples[i].edge)) entries.push_back({cell, i});
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// The cell as ViewLattice counts.
std::array<std::int64_t, 3> numbers_of(std::uint64_t key) {
  const auto cell = cell_of(key);
  std::array<std::int64_t, 3> numbers;
  for (std::size_t i = 0; i < 3; ++i) numbers[i] = static_cast<std::int64_t>(cell[i]) - 1;
  return numbers;
}

/// Joins the corners of the cells around an edge; the corners stand in the order of `cells`.
void add_quad(const ViewLattice& lattice, std::uint64_t edge,
              const std::vector<std::uint64_t>& cells, std::uint32_t item, FaceSet& net) {
  std::array<std::uint32_t, 4> corners;
  double near = kInfinity, far = -kInfinity;
  const auto around = cells_around(edge);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto found = std::lower_bound(cells.begin(), cells.end(), around[i]) - cells.begin();
    corners[i] = static_cast<std::uint32_t>(found);
    near = std::min(near, net.corners[corners[i]].z);
    far = std::max(far, net.corners[corners[i]].z);
  }
  const std::int64_t layer = numbers_of(edge & (~std::uint64_t{0} >> 4))[2];
  const auto reach = static_cast<float>(far - near + lattice.cell_depth(layer));
  const auto margin = static_cast<float>(lattice.side() / 2);
  net.faces.push_back({{corners[0], corners[1], corners[2]}, item, reach, margin});
  net.faces.push_back({{corners[0], corners[2], corners[3]}, item, reach, margin});
}

}  // namespace

std::vector<NetRow> net_rows(const ViewLattice& lattice) {
  std::vector<NetRow> rows;
  const std::array<std::uint32_t, 3> numbers{lattice.cells(2), lattice.cells(2), lattice.cells(1)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::uint32_t i = 0; i <= numbers[axis]; ++i) rows.push_back({axis, i});
  }
  return rows;
}

void sample_row(const ViewLattice& lattice, const NetRow& row, const Shape& shape,
                std::vector<NetSample>& out) {
  const std::size_t axis = row.axis, u_axis = axis == 0 ? 1 : 0;
  thread_local Crossings crossings;
  for (std::uint32_t u = 0; u <= lattice.cells(u_axis); ++u) {
    const Ray line = lattice.line(axis, u, row.number);
    crossings.clear();
    shape.crossings(line, lattice.range(axis), crossings);
    for (const Crossing& crossing : crossings) {
      const std::uint64_t along = lattice.cell_at(axis, crossing.t);
      std::array<std::uint64_t, 3> cell;
      cell[axis] = along + 1;
      cell[u_axis] = u + 1;
      cell[3 - axis - u_axis] = row.number + 1;
      const Surface surface = shape.surface(line, crossing);
      const Vec3 point = line.at(crossing.t);
      if (is_finite(point)) out.push_back({edge_key(axis, cell), point, surface.normal});
    }
  }
}

FaceSet make_net(const ScreenView& view, const ViewLattice& lattice,
                 const std::vector<NetSample>& samples, std::uint32_t item) {
  FaceSet net;
  const std::vector<CellSample> entries = by_cell(samples);
  std::vector<std::uint64_t> cells;
  for (std::size_t i = 0; i < entries.size();) {
    std::size_t end = i;
    while (end < entries.size() && entries[end].cell == entries[i].cell) ++end;
    const Vec3 best = best_point(samples, std::span(entries).subspan(i, end - i));
    cells.push_back(entries[i].cell);
    net.corners.push_back(lattice.into_cell(numbers_of(entries[i].cell), view.to_view(best)));
    i = end;
  }
  std::uint64_t last = ~std::uint64_t{0};
  for (const NetSample& sample : samples) {
    if (sample.edge == last) continue;
    last = sample.edge;
    add_quad(lattice, sample.edge, cells, item, net);
  }
  return net;
}

}  // namespace dioptre
