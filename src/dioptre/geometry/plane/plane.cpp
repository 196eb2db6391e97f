// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/plane/plane.h"

#include "dioptre/geometry/convex.h"

namespace dioptre {
namespace {

class PreparedPlane final : public ConvexShape<PreparedPlane> {
 public:
  PreparedPlane(Vec3 normal, double distance) : normal_(normal), distance_(distance) {}

  /// Infinite, except beyond the plane itself where it lies along the axes.
  Bounds bounds() const override {
    Bounds b = Bounds::all();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (normal_[axis] == 1) b.max[axis] = distance_;
      if (normal_[axis] == -1) b.min[axis] = -distance_;
    }
    return b;
  }
  bool contains(Vec3 p) const override { return dot(p, normal_) <= distance_; }
  std::optional<HalfSpace> half_space() const override { return HalfSpace{normal_, distance_}; }

  bool span(const Ray& ray, ConvexSpan& out) const {
    const double slope = dot(ray.direction, normal_);
    const double height = dot(ray.origin, normal_) - distance_;
    if (slope == 0) return height <= 0;
    const double t = -height / slope;
    const double terms = dot(abs(ray.origin), abs(normal_)) + std::fabs(distance_);
    const double slope_terms = dot(abs(ray.direction), abs(normal_));
    const double error = 4 * kRounding * (terms + std::fabs(t) * slope_terms) / std::fabs(slope);
    if (slope < 0) {
      out.clip_enter(t, error, 0);
    } else {
      out.clip_exit(t, error, 0);
    }
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    Vec3 position = ray.at(crossing.t);
    position -= (dot(position, normal_) - distance_) * normal_;
    return {position, normal_, normal_};
  }

 private:
  Vec3 normal_;
  double distance_;
};

}  // namespace

Result<ShapePtr> prepare(const Plane& plane) {
  const double size = length(plane.normal);
  if (!(size > 0) || !std::isfinite(size)) return fail("plane: the normal has no direction");
  if (!std::isfinite(plane.distance)) return fail("plane: the distance is not finite");
  return std::make_unique<PreparedPlane>(plane.normal / size, plane.distance);
}

}  // namespace dioptre
