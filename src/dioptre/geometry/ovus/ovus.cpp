// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/ovus/ovus.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/convex_newton.h"

namespace dioptre {
namespace {

/// Works in units of the larger radius. Outside the solid its distance from a point is that from
/// one of three circles around `center_`, the origin and `top_`, in the plane of the distance from
/// the axis and the height; the lines from `center_` through the others part their sectors.
class PreparedOvus final : public ConvexShape<PreparedOvus> {
 public:
  explicit PreparedOvus(const Ovus& ovus)
      : scale_(std::max(ovus.bottom_radius, ovus.top_radius)),
        bottom_radius_(ovus.bottom_radius / scale_),
        top_radius_(ovus.top_radius / scale_),
        top_{0, bottom_radius_} {
    const double r = bottom_radius_, to_origin = kArc - bottom_radius_, to_top = kArc - top_radius_;
    alone_ = top_radius_ >= 2 * r;
    if (alone_) return;
    const double height = (r * r + to_origin * to_origin - to_top * to_top) / (2 * r);
    center_ = {-std::sqrt(std::max(0.0, to_origin * to_origin - height * height)), height};
  }

  Bounds bounds() const override {
    const double low = alone_ ? top_.y - top_radius_ : -bottom_radius_;
    const double high = std::max(top_.y + top_radius_, bottom_radius_);
    double reach = std::max(alone_ ? 0.0 : bottom_radius_, top_radius_);
    if (!alone_) reach = std::max(reach, center_.x + kArc);
    return {scale_ * Vec3{-reach, low, -reach}, scale_ * Vec3{reach, high, reach}};
  }

  double cost() const override { return 15; }

  bool contains(Vec3 p) const override {
    Vec3 outwards;
    return distance(p / scale_, outwards) <= 0;
  }

  bool span(const Ray& ray, ConvexSpan& out) const {
    const Interval in_box = clip(bounds(), ray, Interval::all());
    if (!(in_box.min < in_box.max)) return false;
    const double step = in_box.max - in_box.min;
    const Vec3 a = ray.at(in_box.min) / scale_, b = (step / scale_) * ray.direction;
    if (!std::isfinite(step) || !is_finite(a) || !is_finite(b)) return false;
    const auto excess = [&](double s, double& value, double& slope) {
      Vec3 outwards;
      value = distance(a + s * b, outwards);
      slope = dot(outwards, b);
    };
    double first = 0, last = 1;
    double slope_first = 0, slope_last = 0;
    if (!approach_convex(excess, first, last, slope_first)) return false;
    if (!approach_convex(excess, last, first, slope_last)) last = first;
    const double misplaced = shift_error(ray, in_box.min) * length(ray.direction) / scale_;
    const auto error_of = [&](double slope) {
      const double residual = 16 * kRounding + 4 * misplaced;
      const double steep = std::fabs(slope);
      const double t_rounding = 4 * kRounding * (std::fabs(in_box.min) + std::fabs(in_box.max));
      return (steep > 0 ? std::min(1.0, residual / steep) : 1.0) * step + t_rounding;
    };
    out.clip_enter(in_box.min + first * step, error_of(slope_first), 0);
    out.clip_exit(in_box.min + last * step, error_of(slope_last), 0);
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    Vec3 normal;
    distance(p / scale_, normal);
    const double size = length(normal);
    normal = size > 0 ? normal / size : Vec3{0, 1, 0};
    return {p, normal, normal};
  }

 private:
  static constexpr double kArc = 2;  ///< the radius of the lemon's side

  /// The signed distance of a point outside or near the surface, and the direction in which it
  /// grows.
  double distance(Vec3 p, Vec3& outwards) const {
    const Vec2 q{std::hypot(p.x, p.z), p.y};
    Vec2 center = top_;
    double radius = top_radius_;
    if (!alone_) {
      const Vec2 seen = q - center_;
      if (cross(Vec2{} - center_, seen) < 0) {
        center = {}, radius = bottom_radius_;
      } else if (cross(top_ - center_, seen) < 0) {
        center = center_, radius = kArc;
      }
    }
    const Vec2 from = q - center;
    const double far = length(from), grow = far > 0 ? 1 / far : 0;
    const double across = q.x > 0 ? from.x * grow / q.x : 0;
    outwards = {p.x * across, from.y * grow, p.z * across};
    return far - radius;
  }

  double scale_, bottom_radius_, top_radius_;
  Vec2 top_, center_;
  bool alone_ = false;
};

}  // namespace

Result<ShapePtr> prepare(const Ovus& ovus) {
  const Ovus positive{std::fabs(ovus.bottom_radius), std::fabs(ovus.top_radius)};
  if (!std::isfinite(positive.bottom_radius) || !std::isfinite(positive.top_radius)) {
    return fail("ovus: a radius is not finite");
  }
  if (!(std::max(positive.bottom_radius, positive.top_radius) > 1e-300)) {
    return fail("ovus: both radii are 0");
  }
  return std::make_unique<PreparedOvus>(positive);
}

}  // namespace dioptre
