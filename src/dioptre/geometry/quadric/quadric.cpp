// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/quadric/quadric.h"

#include "dioptre/geometry/quadratic.h"
#include "dioptre/geometry/quadric/quadric_bounds.h"

namespace dioptre {
namespace {

class PreparedQuadric final : public Shape {
 public:
  explicit PreparedQuadric(const Quadric& q)
      : q_(q),
        squares_(max_component(abs(q.squares)) + max_component(abs(q.products))),
        linear_(max_component(abs(q.linear))) {}

  Bounds bounds() const override { return quadric_bounds(q_); }
  Bounds bounds_within(const Bounds& region) const override {
    return quadric_bounds_within(q_, region);
  }

  double cost() const override { return 2; }

  bool contains(Vec3 p) const override { return value(p) <= 0; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Crossing found[2];
    bool inside = false;
    const int count = solve(ray, range, found, inside);
    out.insert(out.end(), found, found + count);
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    Crossing found[2];
    bool inside = false;
    if (solve(ray, range, found, inside) == 0) return false;
    out = found[0];
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 position = ray.at(crossing.t);
    Vec3 normal = gradient(position);
    const double size = length(normal);
    normal = size > 0 ? normal / size : Vec3{0, 1, 0};
    return {position, normal, normal};
  }

 private:
  double value(Vec3 p) const {
    return dot(q_.squares, p * p) + q_.products.x * p.x * p.y + q_.products.y * p.x * p.z +
           q_.products.z * p.y * p.z + dot(q_.linear, p) + q_.constant;
  }
  double magnitude(Vec3 p) const {
    const Vec3 a = abs(p), c = abs(q_.products);
    return dot(abs(q_.squares), a * a) + c.x * a.x * a.y + c.y * a.x * a.z + c.z * a.y * a.z +
           dot(abs(q_.linear), a) + std::fabs(q_.constant);
  }
  Vec3 gradient(Vec3 p) const {
    const Vec3 c = q_.products;
    return 2.0 * (q_.squares * p) +
           Vec3{c.x * p.y + c.y * p.z, c.x * p.x + c.z * p.z, c.y * p.x + c.z * p.y} + q_.linear;
  }
  double curvature(Vec3 d) const {
    return dot(q_.squares, d * d) + q_.products.x * d.x * d.y + q_.products.y * d.x * d.z +
           q_.products.z * d.y * d.z;
  }

  /// What an error of b adds to that of a root of a t^2 + 2 b t + c.
  static double slope_error(double a, double b, double t, double error_b) {
    const double steep = std::fabs(a * t + b), moved = error_b * std::fabs(t);
    const double grazing = a != 0 ? std::sqrt(2 * moved / std::fabs(a)) : kInfinity;
    return moved > 0 ? std::min(steep > 0 ? moved / steep : kInfinity, grazing) : 0;
  }

  int solve(const Ray& ray, Interval range, Crossing* out, bool& inside) const {
    const double shift = closest_approach(ray, {});
    const Vec3 origin = ray.at(shift), d = ray.direction;
    const double a = curvature(d), b = 0.5 * dot(gradient(origin), d), c = value(origin);
    QuadraticRoots roots = quadratic_roots(a, b, c, 0);
    // Far out the sign of the leading term decides; a lone root is that of the linear term.
    bool state = roots.count == 1 ? b > 0 : a != 0 ? a < 0 : c <= 0;
    int count = 0;
    inside = state;
    for (int i = 0; i < roots.count; ++i) {
      const double t = roots.t[i] + shift;
      state = !state;
      if (t <= range.min) inside = state;
      if (range.surrounds(t)) {
        out[count++] = {.t = t, .error = error(ray, origin, shift, roots, i), .entering = state};
      }
    }
    return count;
  }

  /// A bound on the error of a root of the equation with the coefficients at `origin`, to which the
  /// ray was moved by `shift`.
  double error(const Ray& ray, Vec3 origin, double shift, QuadraticRoots roots, int i) const {
    const double loss = shift_error(ray, shift);
    const double off = loss * length(ray.direction), size = max_component(abs(origin));
    const double steep = 6 * squares_ * (size + off) + 3 * linear_;
    const double error_b =
        (6 * squares_ * off + 8 * kRounding * steep) * max_component(abs(ray.direction));
    roots.c_error += 8 * kRounding * magnitude(origin) + steep * off;
    return roots.error(i) + loss + slope_error(roots.a, roots.b, roots.t[i], error_b);
  }

  Quadric q_;
  double squares_, linear_;  ///< bounds on the coefficients of one variable
};

}  // namespace

Result<ShapePtr> prepare(const Quadric& quadric) {
  if (!is_finite(quadric.squares) || !is_finite(quadric.products) || !is_finite(quadric.linear) ||
      !std::isfinite(quadric.constant)) {
    return fail("quadric: a coefficient is not finite");
  }
  return std::make_unique<PreparedQuadric>(quadric);
}

}  // namespace dioptre
