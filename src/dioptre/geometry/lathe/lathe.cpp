// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/lathe/lathe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dioptre/geometry/lathe/lathe_curves.h"
#include "dioptre/geometry/lathe/meridian.h"
#include "dioptre/geometry/outline/sweep.h"
#include "dioptre/geometry/quadratic.h"

namespace dioptre {
namespace {

/// Faces are numbered as the curves.
class PreparedLathe final : public Shape {
 public:
  explicit PreparedLathe(LatheCurves lathe)
      : curves_(std::move(lathe.curves)), scale_(lathe.scale) {
    Interval height;
    double reach = 0;
    for (const LatheCurve& piece : curves_) {
      height = unite(height, piece.height);
      reach = std::max(reach, piece.radius.max);
    }
    constexpr double kLoose = 1 + 1e-12;  // what rounding may do to the curves
    reach *= kLoose;
    bounds_ = {scale_ * Vec3{-reach, height.min - 1e-12, -reach},
               scale_ * Vec3{reach, height.max + 1e-12, reach}};
  }

  Bounds bounds() const override { return bounds_; }
  double cost() const override { return 10 + 4 * static_cast<double>(curves_.size()); }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const Interval near = clip(bounds_, ray, Interval::all());
    if (!(near.min < near.max)) return false;
    const double speed = length(ray.direction) / scale_;
    const double shift = near.min + 0.5 * (near.max - near.min);
    if (!std::isfinite(shift) || !(speed > 0) || !std::isfinite(speed)) return false;
    const double misplaced =
        shift_error(ray, shift) * length(ray.direction) / scale_ + 8 * kRounding;
    const Meridian meridian(ray.at(shift) / scale_, ray.direction / (speed * scale_), misplaced);
    const std::size_t first = out.size();
    for (std::uint32_t i = 0; i < curves_.size(); ++i) {
      if (!meridian.may_meet(curves_[i])) continue;
      meridian.cross(curves_[i], [&](const MeridianCrossing& at) {
        const double t = shift + at.distance / speed;
        out.push_back(
            {.t = t,
             .error = at.error / speed + 4 * kRounding * (std::fabs(t) + std::fabs(shift)),
             .face = i,
             .u = at.s,
             .visible = curves_[i].visible});
      });
    }
    return alternate(out, first, range);
  }

  bool contains(Vec3 p) const override {
    if (!bounds_.contains(p)) return false;
    const Vec2 at{std::hypot(p.x, p.z) / scale_, p.y / scale_};
    bool inside = false;
    for (const LatheCurve& piece : curves_) {
      if (piece.radius.max >= at.x) inside ^= odd_number_outwards(piece.curve, at);
    }
    return inside;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const LatheCurve& piece = curves_[crossing.face];
    Surface s;
    s.position = ray.at(crossing.t);
    const double across = std::hypot(s.position.x, s.position.z);
    const Vec2 outwards = across > 0 ? Vec2{s.position.x / across, s.position.z / across} : Vec2{};
    Vec2 tangent = piece.curve.tangent(crossing.u);
    if (piece.curve.at(crossing.u).x < 0) tangent.x = -tangent.x;
    s.normal = {tangent.y * outwards.x, -tangent.x, tangent.y * outwards.y};
    const double size = length(s.normal);
    s.normal = size > 0 ? s.normal / size : Vec3{0, 1, 0};
    if ((dot(s.normal, ray.direction) > 0) == crossing.entering) s.normal = -s.normal;
    s.shading_normal = s.normal;
    return s;
  }

  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    const LatheCurve& piece = curves_[crossing.face];
    const Vec3 p = ray.at(crossing.t);
    const double turn = std::atan2(p.z, p.x) / (2 * std::numbers::pi);
    return {turn < 0 ? turn + 1 : turn, piece.v_begin + crossing.u * (piece.v_end - piece.v_begin)};
  }

 private:
  /// Puts the crossings out[first..] in order and keeps those in the range. Each one changes
  /// between inside and outside.
  static bool alternate(Crossings& out, std::size_t first, Interval range) {
    const auto begin = out.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, out.end(), [](const Crossing& a, const Crossing& b) {
      return a.t != b.t ? a.t < b.t : a.face < b.face;
    });
    if ((out.size() - first) % 2 != 0) out.pop_back();  // only rounding may leave one alone
    for (std::size_t i = first; i < out.size(); ++i) out[i].entering = (i - first) % 2 == 0;
    return keep_range(out, first, range);
  }

  std::vector<LatheCurve> curves_;
  double scale_;
  Bounds bounds_;
};

}  // namespace

Result<ShapePtr> prepare(const Lathe& lathe) {
  Result<LatheCurves> curves = lathe_curves(lathe);
  if (!curves) return tl::unexpected<Error>(curves.error());
  return std::make_unique<PreparedLathe>(std::move(*curves));
}

}  // namespace dioptre
