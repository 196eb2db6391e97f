// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/affine.h"
#include "dioptre/core/result.h"
#include "dioptre/scene/camera.h"

namespace dioptre {

/// The space that faces are projected from: view space. Its point (x, y, w) is seen at the place
/// (x / w, y / w) of the image by a perspective camera, if w > 0, and at (x, y) by an orthographic
/// one. Places are in pixels as in CameraRays::ray; w is the depth: along a ray it grows in
/// proportion to the distance. View space is an affine image of the world.
class ScreenView {
 public:
  /// An error for a camera that is not a pinhole with a flat image: no other projection takes
  /// straight edges to straight edges.
  static Result<ScreenView> prepare(const Camera& camera, std::uint32_t width,
                                    std::uint32_t height);

  bool perspective() const { return perspective_; }
  Vec3 to_view(Vec3 world) const { return to_view_.point(world); }
  Vec3 to_world(Vec3 view) const { return to_world_.point(view); }

  /// The point of view space at a place and depth.
  Vec3 at(Vec2 place, double w) const {
    return perspective_ ? Vec3{place.x * w, place.y * w, w} : Vec3{place.x, place.y, w};
  }
  /// Where a point is seen; for a perspective camera w must be positive.
  Vec2 place(Vec3 view) const {
    return perspective_ ? Vec2{view.x / view.z, view.y / view.z} : Vec2{view.x, view.y};
  }
  /// A point as homogeneous coordinates of the image.
  Vec3 homogeneous(Vec3 view) const { return {view.x, view.y, perspective_ ? view.z : 1}; }

  /// The way in the world from w = 0 to w = 1 at a place of the image.
  Vec3 forward(Vec2 place) const {
    return to_world_.vector(perspective_ ? Vec3{place.x, place.y, 1} : Vec3{0, 0, 1});
  }
  /// The steps in the world of one pixel to the right and of one down, at depth 1.
  Vec3 right() const { return to_world_.x; }
  Vec3 down() const { return to_world_.y; }
  /// The eye, or for an orthographic camera the upper left corner of the image.
  Vec3 origin() const { return to_world_.o; }
  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

 private:
  ScreenView() = default;

  Affine to_world_, to_view_;
  bool perspective_ = true;
  std::uint32_t width_ = 0, height_ = 0;
};

}  // namespace dioptre
