// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/cone/cone.h"

#include <algorithm>

#include "dioptre/geometry/quadratic.h"

namespace dioptre {
namespace {

/// Face 0 is the side, 1 the base disc, 2 the cap disc.
class PreparedCone final : public ConvexShape<PreparedCone> {
 public:
  explicit PreparedCone(const Cone& cone)
      : base_(cone.base),
        cap_(cone.cap),
        middle_(0.5 * (cone.base + cone.cap)),
        axis_(normalize(cone.cap - cone.base)),
        height_(length(cone.cap - cone.base)),
        base_radius_(cone.base_radius),
        cap_radius_(cone.cap_radius),
        growth_((cone.cap_radius - cone.base_radius) / height_),
        open_(cone.open) {}

  Bounds bounds() const override {
    const Vec3 across{extent(axis_.x), extent(axis_.y), extent(axis_.z)};
    return unite(Bounds{base_ - base_radius_ * across, base_ + base_radius_ * across},
                 Bounds{cap_ - cap_radius_ * across, cap_ + cap_radius_ * across});
  }

  bool contains(Vec3 p) const override {
    const Vec3 from_base = p - base_;
    const double h = dot(from_base, axis_);
    const double radius = base_radius_ + growth_ * h;
    return h >= 0 && h <= height_ && length_squared(from_base - h * axis_) <= radius * radius;
  }

  /// First where, then how certain: most rays that are asked miss.
  bool span(const Ray& ray, ConvexSpan& out) const {
    const double shift = closest_approach(ray, middle_);
    const Vec3 from_base = ray.at(shift) - base_;
    const double h = dot(from_base, axis_), climb = dot(ray.direction, axis_);
    const Vec3 across = from_base - h * axis_, drift = ray.direction - climb * axis_;
    const double radius = base_radius_ + growth_ * h, widening = growth_ * climb;
    const double a = dot(drift, drift) - widening * widening;
    const double b = dot(across, drift) - radius * widening;
    const double c = dot(across, across) - radius * radius;
    QuadraticRoots roots = quadratic_roots(a, b, c, 0);
    if (roots.count == 0 && !(a < 0 || (a == 0 && c <= 0))) return false;
    if (!clip_to_slab(h, climb, shift, out)) return false;
    clip_to_side(roots, widening, shift, out);
    if (out.empty() || out.exit.t <= out.wanted.min || out.enter.t >= out.wanted.max) return false;

    const double shift_loss = shift_error(ray, shift);
    const double misplaced =
        shift_loss * length(ray.direction) + 4 * kRounding * max_component(abs(base_));
    // The moved origin's error enters `across`, `radius` and both slopes; within the slab a hit is
    // no farther across than the radii.
    const double off = (1 + std::fabs(growth_)) * misplaced;
    const double widest = std::max(base_radius_, cap_radius_);
    roots.c_error += 8 * kRounding * (dot(from_base, from_base) + radius * radius) +
                     4 * off * (length(across) + std::fabs(radius) + widest + off);
    const double slab_error =
        (2 * misplaced + 8 * kRounding * (std::fabs(h) + height_)) / std::fabs(climb) +
        2 * kRounding * std::fabs(shift);
    for (ConvexSpan::End* end : {&out.enter, &out.exit}) {
      const int root = end->t == roots.t[0] + shift ? 0 : 1;
      end->error = end->face == 0 ? roots.error(root) + shift_loss : slab_error;
    }
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 position = ray.at(crossing.t);
    if (crossing.face == 1) return flat(position, base_, -axis_);
    if (crossing.face == 2) return flat(position, cap_, axis_);
    const Vec3 from_base = position - base_;
    const Vec3 across = from_base - dot(from_base, axis_) * axis_;
    const double size = length(across);
    const Vec3 out = size > 0 ? across / size : -growth_ * axis_;
    const Vec3 slanted = out - growth_ * axis_;
    const double slanted_size = length(slanted);
    const Vec3 normal = slanted_size > 0 ? slanted / slanted_size : axis_;
    return {position, normal, normal};
  }

 private:
  static double extent(double component) {
    return std::sqrt(std::max(0.0, 1 - component * component));
  }

  static Surface flat(Vec3 position, Vec3 center, Vec3 normal) {
    position -= dot(position - center, normal) * normal;
    return {position, normal, normal};
  }

  bool clip_to_slab(double h, double climb, double shift, ConvexSpan& out) const {
    if (climb == 0) return h >= 0 && h <= height_;
    const double t_base = -h / climb, t_cap = (height_ - h) / climb;
    const bool visible = !open_;
    if (climb > 0) {
      out.clip_enter(t_base + shift, 0, 1, visible);
      out.clip_exit(t_cap + shift, 0, 2, visible);
    } else {
      out.clip_enter(t_cap + shift, 0, 2, visible);
      out.clip_exit(t_base + shift, 0, 1, visible);
    }
    return true;
  }

  static void clip_to_side(const QuadraticRoots& roots, double widening, double shift,
                           ConvexSpan& out) {
    const auto enter = [&](int i) { out.clip_enter(roots.t[i] + shift, 0, 0); };
    const auto exit = [&](int i) { out.clip_exit(roots.t[i] + shift, 0, 0); };
    if (roots.count == 1) {
      roots.b < 0 ? enter(0) : exit(0);
    } else if (roots.count == 2 && roots.a > 0) {
      enter(0);
      exit(1);
    } else if (roots.count == 2) {
      // The ray is steeper than the side: it leaves through the apex, whole on one side of it.
      widening > 0 ? enter(1) : exit(0);
    }
  }

  Vec3 base_, cap_, middle_, axis_;
  double height_, base_radius_, cap_radius_;
  double growth_;  ///< of the radius, per height
  bool open_;
};

}  // namespace

Result<ShapePtr> prepare(const Cone& cone) {
  if (!is_finite(cone.base) || !is_finite(cone.cap) || !std::isfinite(cone.base_radius) ||
      !std::isfinite(cone.cap_radius)) {
    return fail("cone: a parameter is not finite");
  }
  if (!(length(cone.cap - cone.base) > 0)) return fail("cone: both ends are at the same point");
  Cone positive = cone;
  positive.base_radius = std::fabs(cone.base_radius);
  positive.cap_radius = std::fabs(cone.cap_radius);
  return std::make_unique<PreparedCone>(positive);
}

}  // namespace dioptre
