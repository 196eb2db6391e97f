// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/visible_surfaces.h"

#include <algorithm>

#include "dioptre/raster/scene_faces.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kSide = DepthTile::kSide;

std::uint32_t tiles_along(std::uint32_t first, std::uint32_t end) {
  return (end - first + kSide - 1) / kSide;
}

/// Where the item is met by the ray. A face that is the surface itself tells where to look.
bool meet(const Item& item, const Ray& ray, const Fragment& fragment, double depth_length,
          double farthest, Crossing& out) {
  constexpr double kRounding = 1e-6;
  if (fragment.exact) {
    const double t = fragment.depth * depth_length;
    const Interval about{t - kRounding * t, std::min(t + kRounding * t, farthest)};
    if (about.min < about.max && item.shape->nearest(ray, about, out)) return true;
  }
  return item.shape->nearest(ray, {0, farthest}, out);
}

}  // namespace

VisibleSurfaces::VisibleSurfaces(const RenderScene& scene, ScreenView view, EyeRays eye,
                                 const PixelRegion& region)
    : scene_(scene),
      view_(view),
      eye_(std::move(eye)),
      region_(region),
      across_(tiles_along(region.first_column, region.end_column)),
      down_(tiles_along(region.first_row, region.end_row)) {}

Result<VisibleSurfaces> VisibleSurfaces::prepare(const RenderScene& scene, std::uint32_t width,
                                                 std::uint32_t height, const PixelRegion& region,
                                                 std::uint32_t threads,
                                                 const std::atomic<bool>* cancel) {
  auto view = ScreenView::prepare(scene.scene().camera, width, height);
  if (!view) return tl::unexpected(view.error());
  auto eye = EyeRays::prepare(scene, width, height);
  if (!eye) return tl::unexpected(eye.error());
  auto faces = scene_faces(scene, *view, threads, cancel);
  if (!faces) return tl::unexpected(faces.error());
  VisibleSurfaces surfaces(scene, *view, std::move(*eye), region_within(region, width, height));
  surfaces.set_ = std::move(*faces);
  if (auto sorted = surfaces.sort_into_tiles(); !sorted) return tl::unexpected(sorted.error());
  return surfaces;
}

PixelBox VisibleSurfaces::tile_box(std::uint32_t tile) const {
  const std::int64_t column = region_.first_column + std::int64_t{tile % across_} * kSide;
  const std::int64_t row = region_.first_row + std::int64_t{tile / across_} * kSide;
  return {column, row, std::min<std::int64_t>(column + kSide, region_.end_column),
          std::min<std::int64_t>(row + kSide, region_.end_row)};
}

template <class Visit>
void VisibleSurfaces::for_each_tile_of(const Face& face, Visit&& visit) const {
  const PixelBox region{region_.first_column, region_.first_row, region_.end_column,
                        region_.end_row};
  const PixelBox box =
      intersect(region, pixel_box(view_,
                                  {set_.corners[face.corners[0]], set_.corners[face.corners[1]],
                                   set_.corners[face.corners[2]]},
                                  face.margin));
  if (box.empty()) return;
  const std::int64_t left = (box.first_column - region.first_column) / kSide;
  const std::int64_t right = (box.end_column - 1 - region.first_column) / kSide;
  for (std::int64_t y = (box.first_row - region.first_row) / kSide;
       y <= (box.end_row - 1 - region.first_row) / kSide; ++y) {
    for (std::int64_t x = left; x <= right; ++x) visit(static_cast<std::size_t>(y * across_ + x));
  }
}

/// Counts first, so that every tile's faces stand together in one list.
Result<void> VisibleSurfaces::sort_into_tiles() {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 28;
  first_.assign(std::size_t{tile_count()} + 1, 0);
  for (const Face& face : set_.faces) {
    for_each_tile_of(face, [&](std::size_t tile) { ++first_[tile + 1]; });
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  if (first_.back() > kMost) return too_many_faces();
  of_tiles_.resize(first_.back());
  std::vector<std::uint64_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < set_.faces.size(); ++i) {
    for_each_tile_of(set_.faces[i], [&](std::size_t tile) { of_tiles_[next[tile]++] = i; });
  }
  return {};
}

void VisibleSurfaces::draw_tile(std::uint32_t tile,
                                const std::function<void(const PixelHit&)>& pixel) const {
  thread_local DepthTile depths;
  const PixelBox box = tile_box(tile);
  depths.begin(box);
  for (std::uint64_t i = first_[tile]; i < first_[tile + 1]; ++i) {
    depths.draw(view_, set_, set_.faces[of_tiles_[i]]);
  }
  for (std::int64_t row = box.first_row; row < box.end_row; ++row) {
    for (std::int64_t column = box.first_column; column < box.end_column; ++column) {
      const Vec2 center{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
      const auto ray = eye_.ray(center.x, center.y);
      if (!ray) continue;
      PixelHit found{static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), *ray, {}};
      found.hit = nearest(*ray, length(view_.forward(center)), depths.pixel(column, row));
      pixel(found);
    }
  }
}

/// `depth_length` is the distance along the ray for a depth of 1.
std::optional<Hit> VisibleSurfaces::nearest(const Ray& ray, double depth_length,
                                            const DepthTile::Pixel& fragments) const {
  std::optional<Hit> best;
  for (const Fragment& fragment : fragments) {
    if (fragment.item == Fragment::kNoItem) break;
    const double least = fragment.least * depth_length;
    if (best && least > best->crossing.t) break;
    const Item& item = scene_.items()[fragment.item];
    const double farthest = best ? just_above(best->crossing.t) : kInfinity;
    Crossing crossing;
    if (!meet(item, ray, fragment, depth_length, farthest, crossing)) continue;
    // Of two items at the same distance the first in the file is seen, as by rays.
    if (best && crossing.t == best->crossing.t && best->item < &item) continue;
    best = Hit{crossing, &item};
  }
  return best;
}

}  // namespace dioptre
