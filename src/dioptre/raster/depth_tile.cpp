// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/depth_tile.h"

#include <algorithm>

namespace dioptre {
namespace {

/// Keeps the fragment if it is among the nearest, one for each item; those at the same depth in
/// order of the items.
void keep(DepthTile::Pixel& pixel, const Fragment& fragment) {
  const auto nearer = [](const Fragment& a, const Fragment& b) {
    return a.least != b.least ? a.least < b.least : a.item < b.item;
  };
  if (!nearer(fragment, pixel.back())) return;
  std::size_t place = 0;
  while (place + 1 < pixel.size() && pixel[place].item != fragment.item &&
         pixel[place].item != Fragment::kNoItem) {
    ++place;
  }
  if (pixel[place].item == fragment.item && !nearer(fragment, pixel[place])) return;
  for (; place > 0 && nearer(fragment, pixel[place - 1]); --place) pixel[place] = pixel[place - 1];
  pixel[place] = fragment;
}

}  // namespace

void DepthTile::begin(const PixelBox& box) {
  box_ = box;
  pixels_.assign(static_cast<std::size_t>(kSide * kSide), Pixel{});
}

void DepthTile::draw(const ScreenView& view, const FaceSet& set, const Face& face) {
  const std::array<Vec3, 3> corners{set.corners[face.corners[0]], set.corners[face.corners[1]],
                                    set.corners[face.corners[2]]};
  const PixelBox box = intersect(pixel_box(view, corners, face.margin), box_);
  if (box.empty()) return;
  const auto projected = ProjectedFace::prepare(view, corners, face.margin);
  if (!projected) return;
  constexpr double kRounding = 1e-9;
  for (std::int64_t row = box.first_row; row < box.end_row; ++row) {
    for (std::int64_t column = box.first_column; column < box.end_column; ++column) {
      const Vec2 center{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
      const auto depth = projected->depth(center);
      if (!depth) continue;
      const double least = *depth - kRounding * *depth - face.reach;
      keep(pixels_[index_of(column, row)], {least, *depth, face.item, face.reach == 0});
    }
  }
}

}  // namespace dioptre
