// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/sor/sor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dioptre/geometry/quadratic.h"
#include "dioptre/geometry/sor/sor_segments.h"

namespace dioptre {
namespace {

constexpr double kSlack = 1e-9;  // of the solid's size, far above rounding
constexpr std::uint32_t kLowDisc = 0, kHighDisc = 1, kFirstSegment = 2;

/// A ray in units of the solid's scale, with a direction of length 1, from a point near the solid.
struct SorRay {
  Vec3 origin, direction;
  Interval within;   ///< where it is in the cylinder around the solid
  double miss2 = 0;  ///< its least squared distance from the axis, or a little less
  double shift = 0, speed = 1, misplaced = 0;

  double height(double d) const { return origin.y + d * direction.y; }
  double squared_radius(double d) const {
    const double x = origin.x + d * direction.x, z = origin.z + d * direction.z;
    return x * x + z * z;
  }
  /// squared_radius on [a, b] as a polynomial of degree 3.
  Bernstein<3> squared_radius(double a, double b) const {
    const double xa = origin.x + a * direction.x, za = origin.z + a * direction.z;
    const double xb = origin.x + b * direction.x, zb = origin.z + b * direction.z;
    const double first = xa * xa + za * za, last = xb * xb + zb * zb;
    const double middle = 2 * (xa * xb + za * zb);
    return {first, (first + middle) / 3, (middle + last) / 3, last};
  }
};

/// The part of a ray within one segment, and where in the segment it begins and ends.
struct Stretch {
  Interval d;
  double begin = 0, end = 1;
};

class PreparedSor final : public Shape {
 public:
  PreparedSor(SorSegments sor, bool open)
      : segments_(std::move(sor.segments)), scale_(sor.scale), open_(open) {
    reach_ = sor.reach * (1 + 1e-9) + 1e-12;
    bounds_ = {scale_ * Vec3{-reach_, segments_.front().low, -reach_},
               scale_ * Vec3{reach_, segments_.back().high, reach_}};
  }

  Bounds bounds() const override { return bounds_; }
  double cost() const override { return 10 + 2 * static_cast<double>(segments_.size()); }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    bool inside = false;
    walk(ray, Interval::all(), [&](const Crossing& crossing) {
      if (crossing.t <= range.min) inside = crossing.entering;
      if (range.surrounds(crossing.t)) out.push_back(crossing);
      return crossing.t < range.max;
    });
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    bool found = false;
    walk(ray, range, [&](const Crossing& crossing) {
      found = crossing.visible && range.surrounds(crossing.t);
      if (found) out = crossing;
      return !found && crossing.t < range.max;
    });
    return found;
  }

  bool contains(Vec3 p) const override {
    if (!bounds_.contains(p)) return false;
    p = p / scale_;
    const SorSegment& segment = segments_[segment_at(p.y)];
    return p.x * p.x + p.z * p.z <= segment.at(segment.place_of(p.y));
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    Surface s;
    s.position = ray.at(crossing.t);
    if (crossing.face < kFirstSegment) {
      const bool high = crossing.face == kHighDisc;
      s.position.y = scale_ * (high ? segments_.back().high : segments_.front().low);
      s.normal = {0, high ? 1.0 : -1.0, 0};
    } else {
      const SorSegment& segment = segments_[crossing.face - kFirstSegment];
      s.normal = {2 * s.position.x / scale_, -segment.slope(crossing.u), 2 * s.position.z / scale_};
      const double size = length(s.normal);
      s.normal = size > 0 ? s.normal / size : Vec3{0, 1, 0};
      if ((dot(s.normal, ray.direction) > 0) == crossing.entering) s.normal = -s.normal;
    }
    s.shading_normal = s.normal;
    return s;
  }

  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    const double turn = std::atan2(p.z, p.x) / (2 * std::numbers::pi);
    const double u = turn < 0 ? turn + 1 : turn;
    if (crossing.face >= kFirstSegment) {
      const double before = crossing.face - kFirstSegment;
      return {u, (before + crossing.u) / static_cast<double>(segments_.size())};
    }
    const bool high = crossing.face == kHighDisc;
    const double share = std::min(std::hypot(p.x, p.z) / scale_ / disc_radius(high), 1.0);
    return {u, high ? 1 - share : share};
  }

 private:
  double disc_radius(bool high) const {
    const double squared =
        high ? segments_.back().squared_radius[3] : segments_.front().squared_radius[0];
    return std::max(std::sqrt(squared), 1e-300);
  }

  std::size_t segment_at(double height) const {
    const auto above =
        std::upper_bound(segments_.begin(), segments_.end() - 1, height,
                         [](double h, const SorSegment& segment) { return h < segment.high; });
    return static_cast<std::size_t>(above - segments_.begin());
  }

  bool prepare_ray(const Ray& ray, SorRay& out) const {
    const Interval near = clip(bounds_, ray, Interval::all());
    if (!(near.min <= near.max)) return false;
    out.shift = near.min + 0.5 * (near.max - near.min);
    out.speed = length(ray.direction) / scale_;
    if (!std::isfinite(out.shift) || !(out.speed > 0) || !std::isfinite(out.speed)) return false;
    out.origin = ray.at(out.shift) / scale_;
    out.direction = ray.direction / (out.speed * scale_);
    out.misplaced = shift_error(ray, out.shift) * length(ray.direction) / scale_;
    const Vec3 o = out.origin, d = out.direction;
    const double level2 = d.x * d.x + d.z * d.z, along = o.x * d.x + o.z * d.z;
    const double across = o.x * d.z - o.z * d.x;
    out.miss2 = (level2 > 0 ? across * across / level2 : o.x * o.x + o.z * o.z) - kSlack;
    if (level2 == 0) {
      out.within = Interval::all();
      return out.miss2 <= reach_ * reach_;
    }
    const double rest = reach_ * reach_ * level2 - across * across;
    if (!(rest > 0)) return false;
    out.within = {(-along - std::sqrt(rest)) / level2, (-along + std::sqrt(rest)) / level2};
    return true;
  }

  /// Calls sink(crossing) in order until it returns false, at least for those with t in `wanted`.
  /// The solid is passed segment by segment: neighbours share the value at the height between them.
  template <class Sink>
  void walk(const Ray& ray, Interval wanted, Sink&& sink) const {
    SorRay r;
    if (!prepare_ray(ray, r)) return;
    wanted = {(wanted.min - r.shift) * r.speed - kSlack, (wanted.max - r.shift) * r.speed + kSlack};
    const double climb = r.direction.y;
    if (climb == 0) {
      const std::size_t level = segment_at(r.origin.y);
      const double s = segments_[level].place_of(r.origin.y);
      const Stretch stretch{r.within, s, s};
      pass(r, level, stretch, depth_along(r, level, stretch), sink);
      return;
    }
    const std::size_t count = segments_.size();
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t index = climb > 0 ? k : count - 1 - k;
      const SorSegment& segment = segments_[index];
      const double low = (segment.low - r.origin.y) / climb;
      const double high = (segment.high - r.origin.y) / climb;
      Stretch on = climb > 0 ? Stretch{{low, high}, 0, 1} : Stretch{{high, low}, 1, 0};
      if (on.d.min >= std::min(r.within.max, wanted.max)) return;
      if (on.d.max <= std::max(r.within.min, wanted.min)) continue;
      const bool at_begin = on.d.min >= r.within.min, at_end = on.d.max <= r.within.max;
      if (!at_begin) on.d.min = r.within.min, on.begin = segment.place_of(r.height(on.d.min));
      if (!at_end) on.d.max = r.within.max, on.end = segment.place_of(r.height(on.d.max));
      if (r.miss2 > segment.most) continue;
      const Bernstein<3> depth = depth_along(r, index, on);
      if (k == 0 && at_begin && depth[0] >= 0 && !sink(disc(r, on.d.min, true))) return;
      if (!pass(r, index, on, depth, sink)) return;
      if (k + 1 == count && at_end && depth[3] >= 0) sink(disc(r, on.d.max, false));
    }
  }

  /// The squared radius of the solid less that of the ray: not negative inside.
  Bernstein<3> depth_along(const SorRay& r, std::size_t index, const Stretch& on) const {
    Bernstein<3> depth = segments_[index].part(on.begin, on.end);
    const Bernstein<3> ray = r.squared_radius(on.d.min, on.d.max);
    for (std::size_t i = 0; i < 4; ++i) depth[i] -= ray[i];
    return depth;
  }

  template <class Sink>
  bool pass(const SorRay& r, std::size_t index, const Stretch& on, const Bernstein<3>& depth,
            Sink&& sink) const {
    const SignChanges<3> changes = sign_changes<3>(depth);
    for (std::size_t i = 0; i < changes.count; ++i) {
      const double share = changes.at[i].s;
      const double d = on.d.min + share * (on.d.max - on.d.min);
      const double s = on.begin + share * (on.end - on.begin);
      if (!sink(side(r, index, d, s, changes.at[i].rises))) return false;
    }
    return true;
  }

  Crossing side(const SorRay& r, std::size_t index, double d, double s, bool entering) const {
    const double outwards = (r.origin.x + d * r.direction.x) * r.direction.x +
                            (r.origin.z + d * r.direction.z) * r.direction.z;
    const double steep = std::fabs(segments_[index].slope(s) * r.direction.y - 2 * outwards);
    const double residual = 32 * kRounding + 4 * (reach_ + steep) * r.misplaced;
    const double grazing = std::sqrt(residual);
    const double error = steep > 0 ? std::min(residual / steep, grazing) : grazing;
    Crossing out = crossing(r, d, error, kFirstSegment + static_cast<std::uint32_t>(index));
    out.u = s;
    out.entering = entering;
    return out;
  }

  /// Where the ray comes in through an end disc, or leaves.
  Crossing disc(const SorRay& r, double d, bool entering) const {
    const double climb = r.direction.y;
    const double error = (2 * r.misplaced + 4 * kRounding) / std::fabs(climb);
    Crossing out = crossing(r, d, error, (climb > 0) == entering ? kLowDisc : kHighDisc);
    out.entering = entering;
    out.visible = !open_;
    return out;
  }

  static Crossing crossing(const SorRay& r, double d, double error, std::uint32_t face) {
    const double t = r.shift + d / r.speed;
    const double rounding = 4 * kRounding * (std::fabs(t) + std::fabs(r.shift));
    return {.t = t, .error = error / r.speed + rounding, .face = face};
  }

  std::vector<SorSegment> segments_;
  double scale_, reach_ = 1;
  bool open_;
  Bounds bounds_;
};

}  // namespace

Result<ShapePtr> prepare(const Sor& sor) {
  Result<SorSegments> segments = sor_segments(sor);
  if (!segments) return tl::unexpected<Error>(segments.error());
  return std::make_unique<PreparedSor>(std::move(*segments), sor.open);
}

}  // namespace dioptre
