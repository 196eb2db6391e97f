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
      : scale_(std::max(torus.major_radius, torus.minor_radius)),
        major_(torus.major_radius / scale_),
        minor_(torus.minor_radius / scale_) {}

  Bounds bounds() const override {
    const double reach = scale_ * (major_ + minor_), height = scale_ * minor_;
    return {{-reach, -height, -reach}, {reach, height, reach}};
  }

  bool contains(Vec3 p) const override { return field(p / scale_) <= 0; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Roots roots;
    find(ray, roots);
    bool inside = false;
    for (std::size_t i = 0; i < roots.count; ++i) {
      if (roots.at[i].t <= range.min) inside = roots.at[i].entering;
      if (range.surrounds(roots.at[i].t)) out.push_back(roots.at[i]);
    }
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    Roots roots;
    find(ray, roots);
    for (std::size_t i = 0; i < roots.count; ++i) {
      if (!range.surrounds(roots.at[i].t)) continue;
      out = roots.at[i];
      return true;
    }
    return false;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    const double across = std::hypot(p.x, p.z);
    const double stretch = across > 0 ? 1 - scale_ * major_ / across : 0;
    Vec3 normal{p.x * stretch, p.y, p.z * stretch};
    // Inside the hole of a spindle the far side of the tube is the surface.
    const double size = length(normal);
    normal = size > 0 ? normal / size : Vec3{0, 1, 0};
    const double around = std::atan2(p.z, p.x) / (2 * std::numbers::pi);
    const double along = std::atan2(p.y, across - scale_ * major_) / (2 * std::numbers::pi);
    return {p, normal, normal, {around < 0 ? around + 1 : around, along < 0 ? along + 1 : along}};
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
    return off * off + p.y * p.y - minor_ * minor_;
  }

  /// The change of field() per step of the point along d.
  double slope(Vec3 p, Vec3 d) const {
    const double across = std::sqrt(p.x * p.x + p.z * p.z);
    const double outwards = across > 0 ? (p.x * d.x + p.z * d.z) / across : 0;
    return 2 * ((across - major_) * outwards + p.y * d.y);
  }

  void find(const Ray& ray, Roots& roots) const {
    const Interval stretch = clip(bounds(), ray, Interval::all());
    if (!(stretch.min < stretch.max)) return;
    // The stretch, a little widened so that its ends are outside, as s in [0, 1].
    const double margin = 0x1p-20 * (stretch.max - stretch.min);
    const double t0 = stretch.min - margin, step = stretch.max - stretch.min + 2 * margin;
    const Vec3 a = ray.at(t0) / scale_, b = (step / scale_) * ray.direction;
    const Bernstein<4> quartic = along(a, b);
    const auto changes = sign_changes<4>(quartic);
    const double moved = shift_error(ray, t0) / step;
    for (std::size_t i = 0; i < changes.count; ++i) {
      double s = changes.at[i].s;
      const double low = i > 0 ? changes.at[i - 1].s : 0;
      const double high = i + 1 < changes.count ? changes.at[i + 1].s : 1;
      for (int pass = 0; pass < 3; ++pass) {
        const double next = s - field(a + s * b) / slope(a + s * b, b);
        if (!(next > low && next < high)) break;
        s = next;
      }
      const Vec3 p = a + s * b;
      const double steep = std::fabs(slope(p, b));
      const double residual = 8 * kRounding * (minor_ * minor_ + dot(abs(p), abs(p)) * minor_);
      const double error = steep > 0 ? residual / steep : std::sqrt(residual);
      roots.at[roots.count++] = {.t = t0 + s * step,
                                 .error = (std::min(error, 1e-4) + moved) * step +
                                          4 * kRounding * std::fabs(t0 + s * step),
                                 .entering = !changes.at[i].rises};
    }
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
};

}  // namespace

Result<ShapePtr> prepare(const Torus& torus) {
  if (!std::isfinite(torus.major_radius) || !std::isfinite(torus.minor_radius)) {
    return fail("torus: a radius is not finite");
  }
  const Torus positive{std::fabs(torus.major_radius), std::fabs(torus.minor_radius)};
  if (!(positive.major_radius + positive.minor_radius > 0)) {
    return fail("torus: both radii are zero");
  }
  return std::make_unique<PreparedTorus>(positive);
}

}  // namespace dioptre
