// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/triangle/triangle.h"

#include <array>
#include <string>

#include "dioptre/geometry/triangle/smooth_normal.h"
#include "dioptre/geometry/triangle/triangle_hit.h"

namespace dioptre {
namespace {

class PreparedTriangle final : public Shape {
 public:
  explicit PreparedTriangle(const Triangle& t)
      : corners_{t.a, t.b, t.c}, smooth_(!t.normals.empty()), empty_(degenerate(t.a, t.b, t.c)) {
    for (std::size_t i = 0; smooth_ && i < 3; ++i) normals_[i] = unit_or_zero(t.normals[i]);
    if (!empty_) normal_ = unit_or_zero(cross(t.c - t.a, t.b - t.a));
  }

  Bounds bounds() const override {
    Bounds b;
    if (!empty_) {
      for (const Vec3 corner : corners_) b = unite(b, corner);
    }
    return b;
  }
  bool solid() const override { return false; }
  bool contains(Vec3) const override { return false; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Crossing crossing;
    if (nearest(ray, range, crossing)) out.push_back(crossing);
    return false;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    if (empty_) return false;
    const TriangleRay triangle_ray(ray);
    const auto& [a, b, c] = corners_;
    if (!line_meets_triangle(triangle_ray, a, b, c)) return false;
    const TriangleHit hit = triangle_hit(triangle_ray, a, b, c);
    if (!range.surrounds(hit.t)) return false;
    out = crossing_of(hit, 0);
    return true;
  }

  Surface surface(const Ray&, const Crossing& crossing) const override {
    const auto& [a, b, c] = corners_;
    Surface s;
    s.position = a + crossing.u * (b - a) + crossing.v * (c - a);
    s.normal = s.shading_normal = normal_;
    if (smooth_) s.shading_normal = smooth_normal(normals_, crossing.u, crossing.v, normal_);
    return s;
  }

  Vec2 uv(const Ray&, const Crossing& crossing) const override { return {crossing.u, crossing.v}; }

 private:
  std::array<Vec3, 3> corners_, normals_{};
  Vec3 normal_;
  bool smooth_, empty_;
};

}  // namespace

Result<ShapePtr> prepare(const Triangle& triangle) {
  if (!is_finite(triangle.a) || !is_finite(triangle.b) || !is_finite(triangle.c)) {
    return fail("triangle corner is not finite");
  }
  if (!triangle.normals.empty() && triangle.normals.size() != 3) {
    return fail("triangle needs one normal per corner or none, found " +
                std::to_string(triangle.normals.size()));
  }
  return std::make_unique<PreparedTriangle>(triangle);
}

}  // namespace dioptre
