// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/uv_faces.h"

#include <algorithm>
#include <cmath>

namespace dioptre {
namespace {

constexpr std::uint32_t kMostCellsAcross = 1024;

/// A cell's number along one axis; what is outside the unit square counts to the cells at its edge.
std::uint32_t cell_of(double at, std::uint32_t side) {
  const double cell = at * side;
  if (!(cell > 0)) return 0;
  return cell >= side ? side - 1 : static_cast<std::uint32_t>(cell);
}

}  // namespace

UvFaces::UvFaces(const Shared<MeshData>& data) : data_(data) {
  if (data_->uvs.empty()) return;
  const double faces = static_cast<double>(data_->faces.size());
  side_ = std::clamp(static_cast<std::uint32_t>(std::sqrt(faces)), 1u, kMostCellsAcross);
  // Faces that reach over much of the square would fill too many cells.
  while (side_ > 1 && count_entries() > 8 * data_->faces.size() + 1024) side_ /= 2;
  fill();
}

std::array<Vec2, 3> UvFaces::corners(std::uint32_t face) const {
  const auto& uvs = data_->faces[face].uvs;
  return {data_->uvs[uvs[0]], data_->uvs[uvs[1]], data_->uvs[uvs[2]]};
}

UvFaces::Box UvFaces::box(std::uint32_t face) const {
  const auto [a, b, c] = corners(face);
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
}

UvFaces::Cells UvFaces::cells(const Box& box) const {
  const std::uint32_t column = cell_of(box.min.x, side_), row = cell_of(box.min.y, side_);
  return {column, std::max(column, cell_of(box.max.x, side_)) + 1, row,
          std::max(row, cell_of(box.max.y, side_)) + 1};
}

std::size_t UvFaces::count_entries() const {
  std::size_t count = 0;
  for (std::uint32_t face = 0; face < data_->faces.size(); ++face) {
    const Cells in = cells(box(face));
    count += std::size_t{in.end_column - in.first_column} * (in.end_row - in.first_row);
  }
  return count;
}

/// Counts the faces of each cell, then writes them in order.
void UvFaces::fill() {
  const auto for_each_cell = [&](std::uint32_t face, auto&& visit) {
    const Cells in = cells(box(face));
    for (std::uint32_t row = in.first_row; row < in.end_row; ++row) {
      for (std::uint32_t column = in.first_column; column < in.end_column; ++column) {
        visit(std::size_t{row} * side_ + column);
      }
    }
  };
  const auto count = static_cast<std::uint32_t>(data_->faces.size());
  starts_.assign(std::size_t{side_} * side_ + 1, 0);
  for (std::uint32_t face = 0; face < count; ++face) {
    for_each_cell(face, [&](std::size_t cell) { ++starts_[cell + 1]; });
  }
  for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  faces_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t face = 0; face < count; ++face) {
    for_each_cell(face, [&](std::size_t cell) { faces_[next[cell]++] = face; });
  }
}

std::optional<UvFaces::Place> UvFaces::find(Vec2 uv) const {
  if (starts_.empty()) return std::nullopt;
  const std::size_t cell = std::size_t{cell_of(uv.y, side_)} * side_ + cell_of(uv.x, side_);
  for (std::uint32_t at = starts_[cell]; at < starts_[cell + 1]; ++at) {
    const auto [a, b, c] = corners(faces_[at]);
    const double area = cross(b - a, c - a);
    const double v = cross(uv - a, c - a) / area, w = cross(b - a, uv - a) / area;
    if (v >= 0 && w >= 0 && v + w <= 1) return Place{faces_[at], v, w};
  }
  return std::nullopt;
}

}  // namespace dioptre
