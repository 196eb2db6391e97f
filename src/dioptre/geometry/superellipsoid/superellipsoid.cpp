// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/superellipsoid/superellipsoid.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/convex_newton.h"
#include "dioptre/geometry/quadratic.h"
#include "dioptre/geometry/superellipsoid/pinched_search.h"

namespace dioptre {
namespace {

/// Where the gauge is a norm the solid is convex, and Newton's iteration on the gauge goes from
/// outside to the surface without passing it.
class PreparedSuperellipsoid final : public Shape {
 public:
  explicit PreparedSuperellipsoid(const Superellipsoid& s)
      : gauge_(power_of(s.east_west), power_of(s.north_south)) {}

  Bounds bounds() const override { return {{-1, -1, -1}, {1, 1, 1}}; }
  double cost() const override { return 20; }
  bool contains(Vec3 p) const override { return gauge_.value(p) <= 1; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    BoxStretch stretch;
    if (!stretch_of(ray, stretch)) return false;
    StretchRoots roots;
    find(stretch, roots);
    bool inside = false, state = roots.starts_inside;
    if (stretch.begin <= range.min) inside = state;
    for (std::size_t i = 0; i < roots.count; ++i) {
      state = !state;
      const Crossing crossing = crossing_at(ray, stretch, roots.s[i], roots.slope[i], state);
      if (crossing.t <= range.min) inside = state;
      if (range.surrounds(crossing.t)) out.push_back(crossing);
    }
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    BoxStretch stretch;
    if (!stretch_of(ray, stretch)) return false;
    StretchRoots roots;
    find(stretch, roots, range.min);
    bool state = roots.starts_inside;
    for (std::size_t i = 0; i < roots.count; ++i) {
      state = !state;
      out = crossing_at(ray, stretch, roots.s[i], roots.slope[i], state);
      if (range.surrounds(out.t)) return true;
    }
    return false;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    double value = 0;
    Vec3 normal = gauge_.gradient(p, value);
    double size = max_component(abs(normal));
    if (!(size > 0) || !std::isfinite(size)) normal = p, size = max_component(abs(p));
    normal = size > 0 ? normalize(normal / size) : Vec3{0, 0, 1};
    return {p, normal, normal};
  }

 private:
  static double power_of(double exponent) { return std::clamp(2 / exponent, 0.01, 1e6); }

  bool stretch_of(const Ray& ray, BoxStretch& stretch) const {
    const Interval in_box = clip(bounds(), ray, Interval::all());
    if (!(in_box.min < in_box.max)) return false;
    stretch.begin = in_box.min;
    stretch.length = in_box.max - in_box.min;
    stretch.origin = ray.at(in_box.min);
    stretch.step = stretch.length * ray.direction;
    return std::isfinite(stretch.length) && is_finite(stretch.origin) && is_finite(stretch.step);
  }

  /// All roots, at least those from t = `after` on.
  void find(const BoxStretch& stretch, StretchRoots& roots, double after = -kInfinity) const {
    if (gauge_.convex()) return find_convex(stretch, roots, after);
    PinchedSearch(gauge_, stretch, roots).run();
  }

  /// The two ends of the part inside. Those that are of no use to a ray from t = `after` are left
  /// out.
  void find_convex(const BoxStretch& stretch, StretchRoots& roots, double after) const {
    double first = 0, last = 1, slope = 0;
    if (!approach(stretch, first, last, slope)) return;
    roots.starts_inside = stretch.t(first) <= after;
    if (!roots.starts_inside) roots.add(first, slope);
    if (!roots.starts_inside && after > -kInfinity) return;
    if (!approach(stretch, last, first, slope)) last = first;
    roots.add(last, slope);
  }

  /// In float as long as the surface is far, which is several steps of the iteration.
  bool approach(const BoxStretch& stretch, double& s, double end, double& slope) const {
    const auto rough = [&](double at, double& value, double& slope) {
      gauge_.rough_slope(stretch.at(at), stretch.step, value, slope);
      value -= 1;
    };
    if (!come_near_convex(rough, s, end)) return false;
    const auto excess = [&](double at, double& value, double& by_s) {
      by_s = dot(gauge_.gradient(stretch.at(at), value), stretch.step);
      value -= 1;
    };
    return approach_convex(excess, s, end, slope);
  }

  Crossing crossing_at(const Ray& ray, const BoxStretch& stretch, double s, double slope_by_s,
                       bool entering) const {
    const double t = stretch.t(s);
    const double slope = std::fabs(slope_by_s) / stretch.length;
    const double misplaced = shift_error(ray, stretch.begin) * length(ray.direction);
    const double residual = 16 * kRounding + 4 * misplaced;
    double error = stretch.length;
    if (slope > 0) error = std::min(error, residual / slope);
    return {.t = t, .error = error + 4 * kRounding * std::fabs(t), .entering = entering};
  }

  SuperellipsoidGauge gauge_;
};

}  // namespace

Result<ShapePtr> prepare(const Superellipsoid& s) {
  if (!(s.east_west > 0) || !(s.north_south > 0)) {
    return fail("superellipsoid: an exponent is not positive");
  }
  return std::make_unique<PreparedSuperellipsoid>(s);
}

}  // namespace dioptre
