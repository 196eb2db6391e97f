// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/projected_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dioptre/core/interval.h"

namespace dioptre {
namespace {

/// A polygon in homogeneous coordinates; every one of four cuts adds one corner at most.
struct ClippedPolygon {
  std::array<Vec3, 8> corners;
  std::size_t count = 0;
  void add(Vec3 corner) {
    if (count < corners.size()) corners[count++] = corner;
  }
};

/// The part where dot(side, p) >= 0.
ClippedPolygon cut(const ClippedPolygon& polygon, Vec3 side) {
  ClippedPolygon out;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3 from = polygon.corners[i], to = polygon.corners[(i + 1) % polygon.count];
    const double a = dot(side, from), b = dot(side, to);
    if (a >= 0) out.add(from);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) out.add(from + a / (a - b) * (to - from));
  }
  return out;
}

/// The pixels with a centre between two places, one more on each side for rounding, in [0, size].
void span_of(double least, double most, std::uint32_t size, std::int64_t& first,
             std::int64_t& end) {
  const double limit = size;
  first = static_cast<std::int64_t>(std::clamp(std::ceil(least - 0.5) - 1, 0.0, limit));
  end = static_cast<std::int64_t>(std::clamp(std::floor(most - 0.5) + 2, 0.0, limit));
}

PixelBox whole(const ScreenView& view) { return {0, 0, view.width(), view.height()}; }

/// The box of corners that are not behind the eye; the whole image where one is at the eye.
PixelBox box_around(const ScreenView& view, const ClippedPolygon& polygon, double margin) {
  if (polygon.count == 0) return {};
  Vec2 least{kInfinity, kInfinity}, most{-kInfinity, -kInfinity};
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3 corner = polygon.corners[i];
    const Vec2 at{corner.x / corner.z, corner.y / corner.z};
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return whole(view);
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y)};
  }
  PixelBox box;
  span_of(least.x - margin, most.x + margin, view.width(), box.first_column, box.end_column);
  span_of(least.y - margin, most.y + margin, view.height(), box.first_row, box.end_row);
  return box;
}

}  // namespace

PixelBox intersect(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.first_column, b.first_column), std::max(a.first_row, b.first_row),
          std::min(a.end_column, b.end_column), std::min(a.end_row, b.end_row)};
}

PixelBox pixel_box(const ScreenView& view, const std::array<Vec3, 3>& corners, double margin) {
  ClippedPolygon polygon;
  bool in_front = true;
  for (const Vec3& corner : corners) {
    if (!is_finite(corner)) return {};
    polygon.add(view.homogeneous(corner));
    in_front = in_front && polygon.corners[polygon.count - 1].z > 0;
  }
  if (!in_front) {
    // Half a pixel of room on every side; the four sides meet in the eye and leave what is ahead.
    const double width = view.width() + 0.5, height = view.height() + 0.5;
    for (const Vec3 side :
         {Vec3{1, 0, 0.5}, Vec3{-1, 0, width}, Vec3{0, 1, 0.5}, Vec3{0, -1, height}}) {
      polygon = cut(polygon, side);
    }
  }
  return box_around(view, polygon, margin);
}

std::optional<ProjectedFace> ProjectedFace::prepare(const ScreenView& view,
                                                    const std::array<Vec3, 3>& corners,
                                                    double margin) {
  std::array<Vec3, 3> h;
  for (std::size_t i = 0; i < 3; ++i) h[i] = view.homogeneous(corners[i]);
  ProjectedFace face;
  face.perspective_ = view.perspective();
  face.edges_ = {cross(h[1], h[2]), cross(h[2], h[0]), cross(h[0], h[1])};
  face.size_ = dot(h[0], face.edges_[0]);
  if (!std::isfinite(face.size_) || face.size_ == 0) return std::nullopt;
  if (face.size_ < 0) {
    face.size_ = -face.size_;
    for (Vec3& edge : face.edges_) edge = -edge;
  }
  face.depths_ = {corners[0].z, corners[1].z, corners[2].z};
  const Vec3 d = face.depths_;
  face.least_ = margin > 0 ? std::min({d.x, d.y, d.z}) : std::numeric_limits<double>::min();
  face.most_ = margin > 0 ? std::max({d.x, d.y, d.z}) : std::numeric_limits<double>::max();
  const auto slack = [&](Vec3 edge) { return margin * (std::fabs(edge.x) + std::fabs(edge.y)); };
  face.margins_ = {slack(face.edges_[0]), slack(face.edges_[1]), slack(face.edges_[2])};
  return face;
}

}  // namespace dioptre
