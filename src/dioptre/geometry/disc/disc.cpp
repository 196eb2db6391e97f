// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/disc/disc.h"

#include "dioptre/geometry/convex.h"

namespace dioptre {
namespace {

class PreparedDisc final : public Shape {
 public:
  explicit PreparedDisc(const Disc& disc)
      : center_(disc.center),
        normal_(length(disc.normal) > 0 ? normalize(disc.normal) : Vec3{0, 1, 0}),
        radius_squared_(length(disc.normal) > 0 ? disc.radius * disc.radius : -1),
        hole_squared_(disc.hole_radius * disc.hole_radius),
        radius_(std::fabs(disc.radius)) {}

  Bounds bounds() const override {
    Vec3 reach;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      reach[axis] = radius_ * std::sqrt(std::fmax(0, 1 - normal_[axis] * normal_[axis]));
    }
    return {center_ - reach, center_ + reach};
  }

  bool solid() const override { return false; }
  bool contains(Vec3) const override { return false; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Crossing crossing;
    if (nearest(ray, range, crossing)) out.push_back(crossing);
    return false;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    const double slope = dot(ray.direction, normal_);
    if (slope == 0) return false;
    const Vec3 to_center = center_ - ray.origin;
    const double t = dot(to_center, normal_) / slope;
    if (!range.surrounds(t)) return false;
    const double apart = length_squared(ray.at(t) - center_);
    if (!(apart <= radius_squared_ && apart >= hole_squared_)) return false;
    const double terms =
        dot(abs(to_center), abs(normal_)) + std::fabs(t) * dot(abs(ray.direction), abs(normal_));
    out = {.t = t, .error = 6 * kRounding * terms / std::fabs(slope), .entering = slope < 0};
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    return {ray.at(crossing.t), normal_, normal_};
  }

 private:
  Vec3 center_, normal_;
  double radius_squared_, hole_squared_, radius_;
};

}  // namespace

Result<ShapePtr> prepare(const Disc& disc) {
  if (!std::isfinite(length(disc.normal))) return fail("disc: the normal is not finite");
  if (!is_finite(disc.center) || !std::isfinite(disc.radius) || !std::isfinite(disc.hole_radius)) {
    return fail("disc: a parameter is not finite");
  }
  return std::make_unique<PreparedDisc>(disc);
}

}  // namespace dioptre
