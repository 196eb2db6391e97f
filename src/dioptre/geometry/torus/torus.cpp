// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/torus/torus.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dioptre/geometry/outline/bernstein.h"
#include "dioptre/geometry/quadratic.h"

namespace dioptre {
namespace {

/// Works in units of the major radius (or of the minor one if that is larger), and on the stretch
/// of the ray in the bounding box: the quartic then has coefficients near 1 wherever the ray
/// begins.
class PreparedTorus final : public Shape {
 public:
  explicit PreparedTorus(const Torus& torus)
      : scale_(std::max({torus.major_radius, torus.minor_radius, 1e-300})),
        major_(torus.major_radius / scale_),
        minor_(torus.minor_radius / scale_) {
    const double reach = scale_ * (major_ + minor_), height = scale_ * minor_;
    bounds_ = {{-reach, -height, -reach}, {reach, height, reach}};
  }

  Bounds bounds() const override { return bounds_; }

  double cost() const override { return 5; }

  bool contains(Vec3 p) const override { return field(p / scale_) <= 0; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Roots roots;
    const bool inside = find(ray, range, 4, roots);
    out.insert(out.end(), roots.at, roots.at + roots.count);
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    Roots roots;
    find(ray, range, 1, roots);
    if (roots.count == 0) return false;
    out = roots.at[0];
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    const double across = std::hypot(p.x, p.z);
    const double off = across - scale_ * major_, outwards = across > 0 ? off / across : 0;
    Vec3 normal{p.x * outwards, p.y, p.z * outwards};
    const double size = length(normal);
    normal = size > 0 ? normal / size : Vec3{0, 1, 0};
    return {p, normal, normal};
  }

  /// u goes around the axis from -x by +z, v around the tube from the inner equator by below.
  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    const double off = std::hypot(p.x, p.z) - scale_ * major_;
    return {0.5 - std::atan2(p.z, p.x) / (2 * std::numbers::pi),
            0.5 + std::atan2(p.y, off) / (2 * std::numbers::pi)};
  }

 private:
  struct Roots {
    std::size_t count = 0;
    Crossing at[4];
  };

  /// Negative inside: the squared distance to the circle, less that of the tube.
  double field(Vec3 p) const {
    const double flat = p.x * p.x + p.z * p.z, across = std::sqrt(flat);
    const double off = (flat - major_ * major_) / (across + major_);
    return (across + major_ > 0 ? off * off : 0) + p.y * p.y - minor_ * minor_;
  }

  /// The change of field() per step of the point along d.
  double slope(Vec3 p, Vec3 d) const {
    const double across = std::sqrt(p.x * p.x + p.z * p.z);
    const double outwards = across > 0 ? (p.x * d.x + p.z * d.z) / across : 0;
    return 2 * ((across - major_) * outwards + p.y * d.y);
  }

  /// Finds the first `most` crossings in the range, and returns whether the ray is inside before
  /// them. Where they are looked for does not depend on the range, and so neither do their bits.
  bool find(const Ray& ray, Interval range, std::size_t most, Roots& roots) const {
    const Interval stretch = clip(bounds_, ray, Interval::all());
    if (!(stretch.min < stretch.max)) return false;
    if (stretch.max < range.min || stretch.min > range.max) return false;
    // The stretch, a little widened so that its ends are outside, as s in [0, 1].
    const double margin = 0x1p-20 * (stretch.max - stretch.min);
    const double t0 = stretch.min - margin, step = stretch.max - stretch.min + 2 * margin;
    const Vec3 a = ray.at(t0) / scale_, b = (step / scale_) * ray.direction;
    if (!std::isfinite(step) || !is_finite(a) || !is_finite(b)) return false;
    const Bernstein<4> quartic = along(a, b);
    const auto add = [&](double low, double high, double start, bool entering) {
      const double s = zero_between(a, b, low, high, start, entering);
      const double t = t0 + s * step;
      if (!range.surrounds(t)) return t <= range.min;
      const double misplaced = shift_error(ray, t0) * length(ray.direction) / scale_;
      const double error = zero_error(a + s * b, b, misplaced) * step +
                           4 * kRounding * (std::fabs(t) + std::fabs(t0));
      roots.at[roots.count++] = {.t = t, .error = error, .entering = entering};
      return roots.count < most;
    };
    if (minor_ > major_) {
      find_in_spindle(a, b, quartic, add);
    } else {
      find_in_ring(
          quartic,
          [&](double low, double high) {
            return t0 + high * step <= range.min || t0 + low * step >= range.max;
          },
          add);
    }
    if (roots.count > 0) return !roots.at[0].entering;
    return contains(ray.at(std::clamp(range.min, stretch.min, stretch.max)));
  }

  template <class Skip, class Add>
  static void find_in_ring(const Bernstein<4>& quartic, Skip&& skip, Add&& add) {
    isolate_sign_changes(
        quartic, 4, skip, [&](double low, double high, double at_low, double at_high) {
          const PowerBasis<4> power(quartic);
          const double chord = low + at_low / (at_low - at_high) * (high - low);
          const double start =
              bracketed_halley([&](double s, double& value, double& change,
                                   double& bend) { power.evaluate(s, value, change, bend); },
                               low, high, chord, at_low < 0);
          return add(low, high, start, at_low >= 0);
        });
  }

  /// The quartic of a spindle is zero at its inner lens too, where field() is not. Between
  /// neighbouring extrema of the quartic field() has at most one zero.
  template <class Add>
  void find_in_spindle(Vec3 a, Vec3 b, const Bernstein<4>& quartic, Add&& add) const {
    const auto turns = sign_changes<3>({quartic[1] - quartic[0], quartic[2] - quartic[1],
                                        quartic[3] - quartic[2], quartic[4] - quartic[3]});
    bool outside = true;
    double low = 0;
    for (std::size_t i = 0; i <= turns.count; ++i) {
      const double high = i < turns.count ? turns.at[i].s : 1;
      const bool outside_there = i == turns.count || field(a + high * b) > 0;
      if (outside_there != outside && !add(low, high, 0.5 * (low + high), outside)) return;
      low = high;
      outside = outside_there;
    }
  }

  /// The zero of field() on a stretch where its sign changes once.
  double zero_between(Vec3 a, Vec3 b, double low, double high, double start, bool falls) const {
    return bracketed_newton(
        [&](double s, double& value, double& change) {
          const Vec3 p = a + s * b;
          value = field(p);
          change = slope(p, b);
        },
        low, high, start, !falls);
  }

  /// A bound on the error in s of a zero at p, whose place is off by `misplaced`: of the first
  /// order where the ray is steep, of the second where it grazes the tube.
  double zero_error(Vec3 p, Vec3 b, double misplaced) const {
    const double off = 4 * kRounding * max_component(abs(p)) + 2 * misplaced;
    const double residual = 8 * kRounding * minor_ * minor_ + 2 * (minor_ + off) * off +
                            8 * kRounding * minor_ * major_;
    const double steep = std::fabs(slope(p, b)), grazing = std::sqrt(residual / dot(b, b));
    return steep > 0 ? std::min(2 * residual / steep, grazing) : grazing;
  }

  /// (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) along p = a + s b, in the Bernstein basis.
  Bernstein<4> along(Vec3 a, Vec3 b) const {
    const double k = major_ * major_ - minor_ * minor_, m = 4 * major_ * major_;
    const double g0 = dot(a, a) + k, g1 = 2 * dot(a, b), g2 = dot(b, b);
    const double c0 = g0 * g0 - m * (a.x * a.x + a.z * a.z);
    const double c1 = 2 * g0 * g1 - m * 2 * (a.x * b.x + a.z * b.z);
    const double c2 = g1 * g1 + 2 * g0 * g2 - m * (b.x * b.x + b.z * b.z);
    const double c3 = 2 * g1 * g2, c4 = g2 * g2;
    return {c0, c0 + c1 / 4, c0 + c1 / 2 + c2 / 6, c0 + 3 * c1 / 4 + c2 / 2 + c3 / 4,
            c0 + c1 + c2 + c3 + c4};
  }

  double scale_, major_, minor_;
  Bounds bounds_;
};

}  // namespace

Result<ShapePtr> prepare(const Torus& torus) {
  if (!std::isfinite(torus.major_radius) || !std::isfinite(torus.minor_radius)) {
    return fail("torus: a radius is not finite");
  }
  return std::make_unique<PreparedTorus>(
      Torus{std::fabs(torus.major_radius), std::fabs(torus.minor_radius)});
}

}  // namespace dioptre
