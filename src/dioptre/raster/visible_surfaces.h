// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "dioptre/integrators/eye_rays.h"
#include "dioptre/integrators/render_image.h"
#include "dioptre/raster/depth_tile.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// What the centre of a pixel shows.
struct PixelHit {
  std::uint32_t column = 0, row = 0;
  Ray ray;                 ///< of the pixel's centre
  std::optional<Hit> hit;  ///< nothing: the background
};

/// Finds what an image shows by drawing faces into depth buffers, a tile at a time. Immutable once
/// prepared; tiles are independent of each other.
class VisibleSurfaces {
 public:
  /// Makes the faces and sorts them by the tiles they may touch. An error for a camera that does
  /// not project straight edges to straight edges, and for too many faces. The scene must outlive
  /// the result.
  static Result<VisibleSurfaces> prepare(const RenderScene& scene, std::uint32_t width,
                                         std::uint32_t height, const PixelRegion& region,
                                         std::uint32_t threads, const std::atomic<bool>* cancel);

  std::uint32_t tile_count() const { return across_ * down_; }
  std::size_t face_count() const { return set_.faces.size(); }

  /// Draws a tile and calls `pixel` for each of its pixels, row by row. The distances are those of
  /// the exact surfaces: the few items that the buffer holds for the pixel are met by the ray of
  /// its centre, the nearest first, until the next one cannot be in front.
  void draw_tile(std::uint32_t tile, const std::function<void(const PixelHit&)>& pixel) const;

 private:
  VisibleSurfaces(const RenderScene& scene, ScreenView view, EyeRays eye,
                  const PixelRegion& region);

  PixelBox tile_box(std::uint32_t tile) const;
  template <class Visit>
  void for_each_tile_of(const Face& face, Visit&& visit) const;
  Result<void> sort_into_tiles();
  std::optional<Hit> nearest(const Ray& ray, double depth_length,
                             const DepthTile::Pixel& fragments) const;

  const RenderScene& scene_;
  ScreenView view_;
  EyeRays eye_;
  PixelRegion region_;
  std::uint32_t across_, down_;  ///< tiles
  FaceSet set_;
  std::vector<std::uint64_t> first_;     ///< of each tile, into `of_tiles_`; and the end
  std::vector<std::uint32_t> of_tiles_;  ///< indices of faces
};

}  // namespace dioptre
