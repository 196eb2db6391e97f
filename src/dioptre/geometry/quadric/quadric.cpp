// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/quadric/quadric.h"

#include "dioptre/geometry/quadratic.h"

namespace dioptre {
namespace {

class PreparedQuadric final : public Shape {
 public:
  explicit PreparedQuadric(const Quadric& q) : q_(q) {}

  /// Finite where the quadric is an ellipsoid with its axes along x, y, z, or a cylinder along one
  /// of them; infinite otherwise.
  Bounds bounds() const override {
    Bounds box = Bounds::all();
    if (q_.products != Vec3{}) return box;
    // Sum over the axes of s (x + l/2s)^2 <= level; an axis with s > 0 is bounded if no other
    // axis can lower the sum without end.
    double level = -q_.constant;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double s = q_.squares[axis], l = q_.linear[axis];
      if (s < 0 || (s == 0 && l != 0)) return box;
      if (s > 0) level += l * l / (4 * s);
    }
    if (level < 0) return {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double s = q_.squares[axis];
      if (s == 0) continue;
      const double middle = -q_.linear[axis] / (2 * s), reach = std::sqrt(level / s);
      box.min[axis] = middle - reach * (1 + 8 * kRounding);
      box.max[axis] = middle + reach * (1 + 8 * kRounding);
    }
    return box;
  }

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
    return {position, normal, normal, {}};
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

  int solve(const Ray& ray, Interval range, Crossing* out, bool& inside) const {
    const double shift = closest_approach(ray, {});
    const double loss = shift_error(ray, shift);
    const Vec3 origin = ray.at(shift), d = ray.direction;
    const double a = curvature(d), b = 0.5 * dot(gradient(origin), d), c = value(origin);
    const QuadraticRoots roots = quadratic_roots(a, b, c, magnitude(origin));
    // Far out the sign of the leading term decides.
    bool state = a != 0 ? a < 0 : b != 0 ? b > 0 : c <= 0;
    if (a == 0 && roots.count == 0 && b != 0) state = c <= 0;
    int count = 0;
    inside = state;
    for (int i = 0; i < roots.count; ++i) {
      const double t = roots.t[i] + shift;
      state = !state;
      if (t <= range.min) inside = state;
      if (range.surrounds(t)) {
        out[count++] = {.t = t, .error = roots.error[i] + loss, .entering = state};
      }
    }
    return count;
  }

  Quadric q_;
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
