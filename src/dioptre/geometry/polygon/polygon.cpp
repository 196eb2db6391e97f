// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/polygon/polygon.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "dioptre/geometry/outline/outline.h"
#include "dioptre/geometry/polygon/angle_sum.h"
#include "dioptre/geometry/triangle/smooth_normal.h"

namespace dioptre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

std::size_t longest_axis(Vec3 v) {
  const Vec3 size = abs(v);
  return size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
}

/// Through the first points that are not on one line; 0 if there are none.
Vec3 plane_normal(const std::vector<Vec3>& points) {
  std::size_t second = 1;
  while (second < points.size() && points[second] == points[0]) ++second;
  for (std::size_t third = second + 1; third < points.size(); ++third) {
    const Vec3 n = cross(points[second] - points[0], points[third] - points[0]);
    if (is_finite(n) && n != Vec3{}) return unit_or_zero(n);
  }
  return {};
}

class PreparedPolygon final : public Shape {
 public:
  explicit PreparedPolygon(const Polygon& polygon)
      : anchor_(polygon.outlines[0][0]), normal_(plane_normal(polygon.outlines[0])) {
    if (normal_ == Vec3{}) return;
    axis_ = longest_axis(normal_);
    for (const std::vector<Vec3>& points : polygon.outlines) {
      outline_.move_to(flat(points[0]));
      bounds_ = unite(bounds_, lifted(points[0]));
      for (std::size_t i = 1; i < points.size(); ++i) {
        outline_.add(line(flat(points[i - 1]), flat(points[i])));
        bounds_ = unite(bounds_, lifted(points[i]));
      }
    }
    outline_.close();
    if (polygon.test == PolygonTest::kAngles) {
      for (const std::vector<Vec3>& points : polygon.outlines) {
        for (std::vector<Vec2>& ring = rings_.emplace_back(); const Vec3 p : points) {
          ring.push_back(flat(p));
        }
      }
    }
  }

  Bounds bounds() const override { return bounds_; }
  bool solid() const override { return false; }
  bool contains(Vec3) const override { return false; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Crossing crossing;
    if (nearest(ray, range, crossing)) out.push_back(crossing);
    return false;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    const double slope = dot(normal_, ray.direction);
    if (slope == 0) return false;
    double t = dot(normal_, anchor_ - ray.origin) / slope;
    t += dot(normal_, (anchor_ - ray.origin) - t * ray.direction) / slope;
    if (!range.surrounds(t) || !std::isfinite(t)) return false;
    const Vec3 p = ray.at(t);
    const PlaneBounds& plane = outline_.bounds();
    const Vec2 q = flat(p);
    if (!(plane.min.x <= q.x && q.x <= plane.max.x && plane.min.y <= q.y && q.y <= plane.max.y) ||
        !inside(q)) {
      return false;
    }
    const Vec3 size = abs(anchor_) + abs(p) + abs(ray.origin) + std::fabs(t) * abs(ray.direction);
    out = Crossing{};
    out.t = t;
    out.error =
        6 * kEpsilon * dot(abs(normal_), size) / std::fabs(slope) + 2 * kEpsilon * std::fabs(t);
    out.entering = slope < 0;
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    Surface s;
    s.position = lifted(ray.at(crossing.t));
    s.normal = s.shading_normal = normal_;
    return s;
  }

 private:
  bool inside(Vec2 q) const {
    return rings_.empty() ? outline_.contains_even_odd(q) : inside_by_angles(rings_, q);
  }
  Vec2 flat(Vec3 p) const { return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]}; }
  /// p moved into the plane along the axis.
  Vec3 lifted(Vec3 p) const {
    p[axis_] -= dot(normal_, p - anchor_) / normal_[axis_];
    return p;
  }

  Vec3 anchor_, normal_;
  std::size_t axis_ = 0;
  Outline outline_;
  std::vector<std::vector<Vec2>> rings_;  ///< only for the test by angles
  Bounds bounds_;
};

}  // namespace

Result<ShapePtr> prepare(const Polygon& polygon) {
  if (polygon.outlines.empty()) return fail("polygon needs an outline");
  for (const std::vector<Vec3>& points : polygon.outlines) {
    if (points.size() < 3) {
      return fail("polygon needs at least three points, found " + std::to_string(points.size()));
    }
    for (const Vec3 p : points) {
      if (!is_finite(p)) return fail("polygon point is not finite");
    }
  }
  return std::make_unique<PreparedPolygon>(polygon);
}

}  // namespace dioptre
