// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/flat_faces.h"

#include <array>
#include <cmath>
#include <numbers>

#include "dioptre/raster/axes.h"
#include "dioptre/raster/cut_polygon.h"

namespace dioptre {
namespace {

/// Adds corners given in the primitive's space, and faces between them.
class Adder {
 public:
  Adder(const ScreenView& view, const PlacedPrimitive& primitive, const ViewScale& scale,
        std::uint32_t item, FaceSet& out)
      : view_(view), to_world_(primitive.to_world), scale_(scale), item_(item), out_(out) {}

  FlatFaces operator()(const Triangle& triangle) {
    return triangles({triangle.a, triangle.b, triangle.c});
  }

  FlatFaces operator()(const Mesh& mesh) {
    const MeshData& data = *mesh.data;
    if (!begin(data.corners.size(), data.faces.size())) return FlatFaces::kTooMany;
    for (const Vec3 corner : data.corners) add(to_world_.point(corner));
    for (const MeshData::Face& face : data.faces) {
      join(face.corners[0], face.corners[1], face.corners[2]);
    }
    return FlatFaces::kAdded;
  }

  FlatFaces operator()(const Polygon& polygon) {
    const auto corners = cut_into_triangles(polygon);
    return corners ? triangles(*corners) : FlatFaces::kCurved;
  }

  FlatFaces operator()(const Box& box) {
    if (!begin(8, 12)) return FlatFaces::kTooMany;
    for (std::uint32_t i = 0; i < 8; ++i) {
      const auto pick = [&](std::uint32_t bit, std::size_t axis) {
        return (i & bit ? box.corner1 : box.corner2)[axis];
      };
      add(to_world_.point({pick(1, 0), pick(2, 1), pick(4, 2)}));
    }
    constexpr std::uint32_t kSides[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                            {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    for (const auto& side : kSides) join_quad(side[0], side[1], side[2], side[3]);
    return FlatFaces::kAdded;
  }

  FlatFaces operator()(const Disc& disc) {
    constexpr std::uint32_t kSectors = 64;
    const Vec3 normal = unit_or_zero(disc.normal);
    if (!begin(2 * kSectors, 2 * kSectors)) return FlatFaces::kTooMany;
    if (normal == Vec3{}) return FlatFaces::kAdded;
    const auto [u, v] = beside(normal);
    const double outer = std::fabs(disc.radius) / std::cos(std::numbers::pi / kSectors);
    const double inner = std::fabs(disc.hole_radius) * std::cos(std::numbers::pi / kSectors);
    for (std::uint32_t i = 0; i < kSectors; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSectors;
      const Vec3 out = std::cos(angle) * u + std::sin(angle) * v;
      add(to_world_.point(disc.center + inner * out));
      add(to_world_.point(disc.center + outer * out));
    }
    for (std::uint32_t i = 0; i < kSectors; ++i) {
      const std::uint32_t next = (i + 1) % kSectors;
      join_quad(2 * i, 2 * i + 1, 2 * next + 1, 2 * next);
    }
    return FlatFaces::kAdded;
  }

  FlatFaces operator()(const Plane& plane) {
    constexpr double kBeyond = 1e3;  // of where everything else ends
    const auto to_object = inverse(to_world_);
    const Vec3 own_normal = unit_or_zero(plane.normal);
    if (!to_object || own_normal == Vec3{}) return FlatFaces::kCurved;
    const Vec3 normal = unit_or_zero(to_object->covector(own_normal));
    if (!is_finite(normal) || normal == Vec3{}) return FlatFaces::kCurved;
    if (!begin(4, 2)) return FlatFaces::kTooMany;
    const Vec3 eye = view_.to_world(view_.at({view_.width() / 2.0, view_.height() / 2.0}, 0));
    const Vec3 point = to_world_.point(plane.distance * own_normal);
    const double height = dot(eye - point, normal);
    const Vec3 foot = eye - height * normal;
    const auto [u, v] = beside(normal);
    const double size = kBeyond * (scale_.far + std::fabs(height));
    for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
      add(foot + size * (corner.x * u + corner.y * v));
    }
    join_quad(0, 1, 2, 3);
    return FlatFaces::kAdded;
  }

  template <class Other>
  FlatFaces operator()(const Other&) {
    return FlatFaces::kCurved;
  }

 private:
  bool begin(std::size_t corners, std::size_t faces) {
    first_ = static_cast<std::uint32_t>(out_.corners.size());
    return out_.has_room(corners, faces);
  }
  void add(Vec3 world) { out_.corners.push_back(view_.to_view(world)); }
  void join(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    out_.faces.push_back({{first_ + a, first_ + b, first_ + c}, item_});
  }
  void join_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    join(a, b, c);
    join(a, c, d);
  }
  /// Every three corners make one.
  FlatFaces triangles(const std::vector<Vec3>& corners) {
    if (!begin(corners.size(), corners.size() / 3)) return FlatFaces::kTooMany;
    for (const Vec3 corner : corners) add(to_world_.point(corner));
    for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3) join(i, i + 1, i + 2);
    return FlatFaces::kAdded;
  }

  const ScreenView& view_;
  const Affine& to_world_;
  const ViewScale& scale_;
  std::uint32_t item_, first_ = 0;
  FaceSet& out_;
};

}  // namespace

FlatFaces add_flat_faces(const ScreenView& view, const PlacedPrimitive& primitive,
                         const ViewScale& scale, std::uint32_t item, FaceSet& out) {
  return std::visit(Adder(view, primitive, scale, item, out), *primitive.shape);
}

}  // namespace dioptre
