// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/prism/prism.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dioptre/geometry/outline/sweep.h"
#include "dioptre/geometry/prism/prism_outline.h"

namespace dioptre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

Bounds swept_bounds(const PlaneBounds& plane, Slab slab, bool conic) {
  const auto at_height = [&](double y, double scale) {
    const Vec2 a = scale * plane.min, b = scale * plane.max;
    return Bounds{{std::min(a.x, b.x), y, std::min(a.y, b.y)},
                  {std::max(a.x, b.x), y, std::max(a.y, b.y)}};
  };
  return unite(at_height(slab.low, conic ? slab.low : 1),
               at_height(slab.high, conic ? slab.high : 1));
}

class PreparedPrism final : public Shape {
 public:
  PreparedPrism(Outline outline, const Prism& prism)
      : outline_(std::move(outline)),
        slab_{std::min(prism.height1, prism.height2), std::max(prism.height1, prism.height2)},
        conic_(prism.conic),
        open_(prism.open),
        bounds_(swept_bounds(outline_.bounds(), slab_, conic_)) {}

  Bounds bounds() const override { return bounds_; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    // The whole line is intersected, so that the state at range.min is sure.
    const Interval near = clip(bounds_, ray, Interval::all());
    if (near.empty() || !std::isfinite(near.min) || !std::isfinite(near.max)) return false;
    const std::size_t first = out.size();
    if (conic_) {
      // The origin is best where the ray is farthest from the apex.
      const double a = ray.origin.y + near.min * ray.direction.y;
      const double b = ray.origin.y + near.max * ray.direction.y;
      const double shift = std::fabs(a) >= std::fabs(b) ? near.min : near.max;
      cross_conic_sweep(outline_, slab_, sweep_ray(ray, shift), out);
    } else {
      cross_linear_sweep(outline_, FillRule::kEvenOdd, slab_, sweep_ray(ray, near.min), out);
    }
    for (std::size_t i = first; i < out.size(); ++i) {
      out[i].visible = !open_ || out[i].face >= kFirstSide;
    }
    return keep_range(out, first, range);
  }

  bool contains(Vec3 p) const override {
    if (!(slab_.low <= p.y && p.y <= slab_.high)) return false;
    if (!conic_) return bounds_.contains(p) && outline_.contains_even_odd({p.x, p.z});
    return p.y != 0 && outline_.contains_even_odd({p.x / p.y, p.z / p.y});
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    Surface s;
    s.position = ray.at(crossing.t);
    if (crossing.face < kFirstSide) {
      s.position.y = crossing.face == kLowCap ? slab_.low : slab_.high;
      s.normal = {0, crossing.face == kLowCap ? -1.0 : 1.0, 0};
    } else {
      const Curve& curve = outline_.curves()[crossing.face - kFirstSide];
      const Vec2 p = curve.at(crossing.u), tangent = curve.tangent(crossing.u);
      const double scale = conic_ ? s.position.y : 1;
      s.position.x = scale * p.x;
      s.position.z = scale * p.y;
      const Vec3 upwards = conic_ ? Vec3{p.x, 1, p.y} : Vec3{0, 1, 0};
      const Vec3 normal = cross(upwards, {tangent.x, 0, tangent.y});
      const double size = length(normal);
      s.normal = size > 0 ? normal / size : Vec3{0, 1, 0};
      if ((dot(s.normal, ray.direction) > 0) == crossing.entering) s.normal = -s.normal;
    }
    s.shading_normal = s.normal;
    return s;
  }

 private:
  static SweepRay sweep_ray(const Ray& ray, double shift) {
    const Vec3 o = ray.at(shift), d = ray.direction;
    const Vec3 size = abs(ray.origin) + std::fabs(shift) * abs(d);
    return {{o.x, o.z}, {d.x, d.z}, o.y, d.y, shift, 4 * kEpsilon * max_component(size)};
  }

  Outline outline_;
  Slab slab_;
  bool conic_, open_;
  Bounds bounds_;
};

}  // namespace

Result<ShapePtr> prepare(const Prism& prism) {
  if (!std::isfinite(prism.height1) || !std::isfinite(prism.height2)) {
    return fail("prism height is not finite");
  }
  Result<Outline> outline = prism_outline(prism);
  if (!outline) return tl::unexpected<Error>(outline.error());
  return std::make_unique<PreparedPrism>(std::move(*outline), prism);
}

}  // namespace dioptre
