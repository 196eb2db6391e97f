// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "dioptre/raster/screen_view.h"

namespace dioptre {

/// A rectangle of pixels, ends excluded; empty where an end is not greater than the start.
struct PixelBox {
  std::int64_t first_column = 0, first_row = 0;
  std::int64_t end_column = 0, end_row = 0;
  bool empty() const { return first_column >= end_column || first_row >= end_row; }
};

PixelBox intersect(const PixelBox& a, const PixelBox& b);

/// The pixels whose centres a triangle with these corners in view space, or what is up to `margin`
/// pixels beside it, may cover. What of it lies behind the eye or beside the image is clipped away
/// (Sutherland and Hodgman 1974, "Reentrant polygon clipping"); the box may be too large, never too
/// small.
PixelBox pixel_box(const ScreenView& view, const std::array<Vec3, 3>& corners, double margin);

/// A triangle on the image, described by three functions that are linear in the place and not
/// negative inside. They come from homogeneous coordinates, so corners may lie behind the eye:
/// nothing is divided before a pixel is covered (Olano and Greer 1997, "Triangle scan conversion
/// using 2D homogeneous coordinates"). Triangles with a common edge leave no gap.
///
/// A triangle may be drawn wider than it is (Hasselgren, Akenine-Moller and Ohlsson 2005,
/// "Conservative rasterization"): all corners must then be in front of the eye, and what is beside
/// the triangle has the depth of its nearest or farthest corner at most.
class ProjectedFace {
 public:
  /// Nothing for a triangle that is seen from its edge, or is one.
  static std::optional<ProjectedFace> prepare(const ScreenView& view,
                                              const std::array<Vec3, 3>& corners, double margin);

  /// The depth at a place, with perspective; nothing if the triangle does not cover it.
  std::optional<double> depth(Vec2 place) const {
    const double a = inside(0, place), b = inside(1, place), c = inside(2, place);
    if (!(a >= -margins_.x && b >= -margins_.y && c >= -margins_.z)) return std::nullopt;
    const double sum = a + b + c;
    const double depth =
        perspective_ ? size_ / sum : (a * depths_.x + b * depths_.y + c * depths_.z) / sum;
    if (depth >= least_ && depth <= most_) return depth;
    if (margins_ == Vec3{}) return std::nullopt;
    return depth > most_ ? most_ : least_;
  }

 private:
  double inside(std::size_t edge, Vec2 p) const {
    return edges_[edge].x * p.x + edges_[edge].y * p.y + edges_[edge].z;
  }

  std::array<Vec3, 3> edges_;
  Vec3 margins_;                 ///< how far below 0 each function may be
  Vec3 depths_;                  ///< of the corners
  double least_ = 0, most_ = 0;  ///< what depths may be
  double size_ = 0;              ///< the determinant of the corners
  bool perspective_ = true;
};

}  // namespace dioptre
