// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/sphere/sphere.h"

#include <cmath>
#include <numbers>

#include "dioptre/geometry/convex.h"

namespace dioptre {
namespace {

class PreparedSphere final : public ConvexShape<PreparedSphere> {
 public:
  explicit PreparedSphere(const Sphere& sphere)
      : center_(sphere.center), radius_(sphere.radius), squared_(radius_ * radius_) {}

  Bounds bounds() const override {
    const Vec3 r{radius_, radius_, radius_};
    return {center_ - r, center_ + r};
  }
  bool contains(Vec3 p) const override { return length_squared(p - center_) <= squared_; }

  /// From the closest approach to the centre (Haines et al., "Precision Improvements for Ray/Sphere
  /// Intersection", Ray Tracing Gems 2019): the discriminant does not lose the radius far away.
  bool span(const Ray& ray, ConvexSpan& out) const {
    const Vec3 to_center = center_ - ray.origin;
    const double a = dot(ray.direction, ray.direction);
    const double middle = dot(to_center, ray.direction) / a;
    const Vec3 miss = to_center - middle * ray.direction;
    const double apart = dot(miss, miss);
    const double discriminant = squared_ - apart;
    if (!(discriminant > 0)) return false;
    const double half_squared = discriminant / a, half = std::sqrt(half_squared);
    // The root near the origin is a difference of near numbers: the product of the roots gives it.
    const double far = middle >= 0 ? middle + half : middle - half;
    const double near = (dot(to_center, to_center) - squared_) / (a * far);
    const bool cancels = std::fabs(near) < 0.5 * std::fabs(far);
    double t0 = middle - half, t1 = middle + half;
    if (cancels) (middle >= 0 ? t0 : t1) = near;
    if (t1 <= out.wanted.min || t0 >= out.wanted.max) return false;
    // The ray is no farther off than the radius.
    const double size = max_component(abs(to_center));
    const double discriminant_error = 8 * kRounding * (squared_ + apart + size * radius_);
    const double half_squared_error = discriminant_error / a;
    const double half_error = half_squared_error < 4 * half_squared
                                  ? half_squared_error / (2 * half)
                                  : std::sqrt(half_squared_error);
    const double error =
        half_error + 4 * kRounding * (std::fabs(middle) + half) +
        2 * kRounding * max_component(abs(center_)) / max_component(abs(ray.direction));
    out.clip_enter(t0, error, 0);
    out.clip_exit(t1, error, 0);
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    Vec3 normal = ray.at(crossing.t) - center_;
    const double size = length(normal);
    normal = size > 0 ? normal / size : Vec3{0, 1, 0};
    return {center_ + radius_ * normal, normal, normal};
  }

  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    return longitude_latitude(surface(ray, crossing).normal);
  }

 private:
  /// u once around the y axis, v from the south pole to the north pole.
  static Vec2 longitude_latitude(Vec3 n) {
    const double u = std::atan2(n.z, n.x) / (2 * std::numbers::pi);
    return {u < 0 ? u + 1 : u,
            0.5 + std::asin(std::fmax(-1, std::fmin(1, n.y))) / std::numbers::pi};
  }

  Vec3 center_;
  double radius_, squared_;
};

}  // namespace

Result<ShapePtr> prepare(const Sphere& sphere) {
  if (!is_finite(sphere.center)) return fail("sphere: the centre is not finite");
  if (!std::isfinite(sphere.radius)) return fail("sphere: the radius is not finite");
  Sphere positive = sphere;
  positive.radius = std::fabs(sphere.radius);
  return std::make_unique<PreparedSphere>(positive);
}

}  // namespace dioptre
