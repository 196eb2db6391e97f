// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/bicubic_patch/bicubic_patch.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dioptre/accel/part_structure.h"
#include "dioptre/geometry/bicubic_patch/patch_pieces.h"
#include "dioptre/geometry/triangle/smooth_normal.h"
#include "dioptre/geometry/triangle/triangle_hit.h"

namespace dioptre {
namespace {

constexpr std::size_t kMostPieces = 1 << 18;

/// The order of hits along a ray; hits at the same t come in the order of their faces.
bool before(const Crossing& a, const Crossing& b) {
  return a.t != b.t ? a.t < b.t : a.face < b.face;
}

/// Faces 2i and 2i + 1 are the two triangles of piece i.
class PreparedPatch final : public Shape {
 public:
  PreparedPatch(const BicubicPatch& patch, std::vector<PatchPiece> pieces,
                const ShapeOptions& options)
      : patch_(patch), pieces_(std::move(pieces)) {
    std::vector<Bounds> boxes(pieces_.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (const Vec3 corner : pieces_[i].corners) boxes[i] = unite(boxes[i], corner);
    }
    tree_ = PartStructure(options.accelerator, boxes, 2);
  }

  Bounds bounds() const override { return tree_.bounds(); }
  bool solid() const override { return false; }
  bool contains(Vec3) const override { return false; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const std::size_t first = out.size();
    for_each_hit(ray, range, [&](const Crossing& hit, Interval&) { out.push_back(hit); });
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), before);
    return false;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    bool found = false;
    for_each_hit(ray, range, [&](const Crossing& hit, Interval& rest) {
      if (found && !before(hit, out)) return;
      found = true;
      out = hit;
      rest.max = hit.t;
    });
    return found;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const PatchPiece& piece = pieces_[crossing.face / 2];
    const auto triangle = piece.triangle(crossing.face % 2);
    const Vec3 a = piece.corners[triangle[0]], b = piece.corners[triangle[1]];
    const Vec3 c = piece.corners[triangle[2]];
    const double v = crossing.u, w = crossing.v;
    Surface s;
    s.position = a + v * (b - a) + w * (c - a);
    s.normal = unit_or_zero(cross(c - a, b - a));
    if (s.normal == Vec3{}) s.normal = (crossing.entering ? -1 : 1) * unit_or_zero(ray.direction);
    const auto normal = [&](std::size_t i) {
      return patch_normal(patch_, piece.place(triangle[i]));
    };
    s.shading_normal = unit_or_zero((1 - v - w) * normal(0) + v * normal(1) + w * normal(2));
    if (s.shading_normal == Vec3{}) s.shading_normal = s.normal;
    return s;
  }

  Vec2 uv(const Ray&, const Crossing& crossing) const override {
    const PatchPiece& piece = pieces_[crossing.face / 2];
    const auto triangle = piece.triangle(crossing.face % 2);
    const double v = crossing.u, w = crossing.v;
    const Vec2 place = (1 - v - w) * piece.place(triangle[0]) + v * piece.place(triangle[1]) +
                       w * piece.place(triangle[2]);
    const auto& corners = patch_.uv_corners;
    return (1 - place.y) * ((1 - place.x) * corners[0] + place.x * corners[1]) +
           place.y * ((1 - place.x) * corners[3] + place.x * corners[2]);
  }

 private:
  /// Calls sink(hit, range) for the hits in the range, in no order; it may lower range.max.
  template <class Sink>
  void for_each_hit(const Ray& ray, Interval range, Sink&& sink) const {
    if (ray.direction == Vec3{}) return;
    const TriangleRay triangle_ray(ray);
    const double least = range.min, most = range.max;
    tree_.traverse(ray, range, [&](std::uint32_t index, Interval& rest) {
      const PatchPiece& piece = pieces_[index];
      for (std::uint32_t face = 0; face < 2; ++face) {
        const auto triangle = piece.triangle(face);
        const Vec3 a = piece.corners[triangle[0]], b = piece.corners[triangle[1]];
        const Vec3 c = piece.corners[triangle[2]];
        if (!line_meets_triangle(triangle_ray, a, b, c) || degenerate(a, b, c)) continue;
        const TriangleHit hit = triangle_hit(triangle_ray, a, b, c);
        if (least < hit.t && hit.t < most) sink(crossing_of(hit, 2 * index + face), rest);
      }
      return true;
    });
  }

  BicubicPatch patch_;
  std::vector<PatchPiece> pieces_;
  PartStructure tree_;
};

}  // namespace

Result<ShapePtr> prepare(const BicubicPatch& patch, const ShapeOptions& options) {
  const auto& uvs = patch.uv_corners;
  if (!std::all_of(patch.points.begin(), patch.points.end(), [](Vec3 p) { return is_finite(p); })) {
    return fail("bicubic_patch has a control point that is not finite");
  }
  if (std::isnan(patch.flatness) || !std::all_of(uvs.begin(), uvs.end(), [](Vec2 uv) {
        return std::isfinite(uv.x) && std::isfinite(uv.y);
      })) {
    return fail("bicubic_patch has a number that is not finite");
  }
  auto pieces = patch_pieces(patch, kMostPieces);
  if (!pieces)
    return fail("bicubic_patch has more than " + std::to_string(kMostPieces) + " pieces");
  return std::make_unique<PreparedPatch>(patch, std::move(*pieces), options);
}

}  // namespace dioptre
