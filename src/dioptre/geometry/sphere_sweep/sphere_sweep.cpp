// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/sphere_sweep/sphere_sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dioptre/accel/bounding_volume_hierarchy.h"
#include "dioptre/geometry/quadratic.h"
#include "dioptre/geometry/sphere_sweep/sweep_spans.h"

namespace dioptre {
namespace {

/// One end of a stretch inside the solid, on the surface of a piece.
struct SolidEnd {
  double distance = 0, s = 0;
  std::uint32_t piece = 0;
};

/// A stretch of a ray inside the solid.
struct SolidSpan {
  SolidEnd enter, exit;
};

/// Reused from ray to ray by each thread, so that no ray allocates.
std::vector<SolidSpan>& workspace() {
  thread_local std::vector<SolidSpan> spans;
  return spans;
}

/// A ray from a point near the solid, with a direction of length 1 and two axes across it.
struct LineFrame {
  Vec3 origin;
  std::array<Vec3, 3> axes;
  double shift = 0, speed = 1, misplaced = 0;
};

/// Faces are numbered as the pieces.
class PreparedSphereSweep final : public Shape {
 public:
  explicit PreparedSphereSweep(std::vector<SweepPiece> pieces) : pieces_(std::move(pieces)) {
    std::vector<Bounds> boxes;
    boxes.reserve(pieces_.size());
    for (const SweepPiece& piece : pieces_) boxes.push_back(piece.bounds());
    tree_ = BoundingVolumeHierarchy(boxes);
    for (const Bounds& box : boxes) bounds_ = unite(bounds_, box);
    size_ = max_component(bounds_.extent());
  }

  Bounds bounds() const override { return bounds_; }
  double cost() const override { return pieces_.front().degree == 1 ? 20 : 60; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    LineFrame r;
    if (!prepare_ray(ray, r)) return false;
    bool inside = false;
    for (const SolidSpan& span : spans_along(ray, r)) {
      for (const bool entering : {true, false}) {
        const Crossing crossing = crossing_at(r, entering ? span.enter : span.exit, entering);
        if (crossing.t <= range.min) inside = entering;
        if (range.surrounds(crossing.t)) out.push_back(crossing);
      }
    }
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    LineFrame r;
    if (!prepare_ray(ray, r)) return false;
    for (const SolidSpan& span : spans_along(ray, r)) {
      for (const bool entering : {true, false}) {
        out = crossing_at(r, entering ? span.enter : span.exit, entering);
        if (range.surrounds(out.t)) return true;
      }
    }
    return false;
  }

  bool contains(Vec3 p) const override {
    if (!bounds_.contains(p)) return false;
    bool inside = false;
    tree_.visit_at(p, [&](std::uint32_t i) { inside = inside || inside_piece(pieces_[i], p); });
    return inside;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    Vec3 normal = p - pieces_[crossing.face].center_at(crossing.u);
    double size = length(normal);
    if (!(size > 0) || (dot(normal, ray.direction) < 0) != crossing.entering) {
      normal = crossing.entering ? -ray.direction : ray.direction;
      size = length(normal);
    }
    normal = normal / size;
    return {p, normal, normal};
  }

 private:
  bool prepare_ray(const Ray& ray, LineFrame& out) const {
    const Interval near = clip(bounds_, ray, Interval::all());
    if (!(near.min < near.max)) return false;
    out.shift = near.min + 0.5 * (near.max - near.min);
    out.speed = length(ray.direction);
    if (!std::isfinite(out.shift) || !(out.speed > 0) || !std::isfinite(out.speed)) return false;
    out.origin = ray.at(out.shift);
    out.misplaced = shift_error(ray, out.shift) * out.speed;
    const Vec3 d = ray.direction / out.speed;
    const Vec3 other = std::fabs(d.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 across = normalize(cross(d, other));
    out.axes = {d, across, cross(d, across)};
    return true;
  }

  /// The stretches inside the solid, in order and apart.
  const std::vector<SolidSpan>& spans_along(const Ray& ray, const LineFrame& r) const {
    std::vector<SolidSpan>& spans = workspace();
    spans.clear();
    const auto look_at = [&](std::uint32_t i) {
      const Vec3 to_ball = pieces_[i].ball_center - r.origin;
      const double x = dot(to_ball, r.axes[1]), y = dot(to_ball, r.axes[2]);
      const double reach = pieces_[i].ball_radius + 1e-9 * size_;
      if (x * x + y * y > reach * reach) return;
      const SweepSpans found = sweep_spans(pieces_[i], r.origin, r.axes);
      for (std::size_t k = 0; k < found.count; ++k) {
        const SpanEnd a = found.at[k].enter, b = found.at[k].exit;
        if (a.distance < b.distance) spans.push_back({{a.distance, a.s, i}, {b.distance, b.s, i}});
      }
    };
    constexpr std::size_t kFew = 8;
    if (pieces_.size() <= kFew) {
      for (std::uint32_t i = 0; i < pieces_.size(); ++i) look_at(i);
    } else {
      Interval all = Interval::all();
      tree_.traverse(ray, all, [&](std::uint32_t i, Interval&) {
        look_at(i);
        return true;
      });
    }
    unite_spans(spans);
    return spans;
  }

  static void unite_spans(std::vector<SolidSpan>& spans) {
    std::sort(spans.begin(), spans.end(), [](const SolidSpan& a, const SolidSpan& b) {
      return a.enter.distance != b.enter.distance ? a.enter.distance < b.enter.distance
                                                  : a.enter.piece < b.enter.piece;
    });
    std::size_t count = 0;
    for (const SolidSpan& span : spans) {
      if (count > 0 && span.enter.distance <= spans[count - 1].exit.distance) {
        SolidSpan& last = spans[count - 1];
        if (span.exit.distance > last.exit.distance) last.exit = span.exit;
      } else {
        spans[count++] = span;
      }
    }
    spans.resize(count);
  }

  Crossing crossing_at(const LineFrame& r, const SolidEnd& end, bool entering) const {
    const SweepPiece& piece = pieces_[end.piece];
    const double radius = std::fabs(piece.radius_at(end.s));
    const double half = std::fabs(end.distance - dot(piece.center_at(end.s) - r.origin, r.axes[0]));
    // Off by `misplaced` across the line, the half chord changes by radius / half as much.
    const double off = r.misplaced + 16 * kRounding * size_;
    const double grazing = std::sqrt(2 * off * (radius + off));
    const double error =
        half > 0 ? std::min(2 * off * (1 + radius / half), 2 * off + grazing) : 2 * off + grazing;
    const double t = r.shift + end.distance / r.speed;
    return {.t = t,
            .error = error / r.speed + 4 * kRounding * (std::fabs(t) + std::fabs(r.shift)),
            .face = end.piece,
            .u = end.s,
            .entering = entering};
  }

  std::vector<SweepPiece> pieces_;
  BoundingVolumeHierarchy tree_;
  Bounds bounds_;
  double size_ = 0;
};

}  // namespace

Result<ShapePtr> prepare(const SphereSweep& sweep) {
  Result<std::vector<SweepPiece>> pieces = sweep_pieces(sweep);
  if (!pieces) return tl::unexpected<Error>(pieces.error());
  return std::make_unique<PreparedSphereSweep>(std::move(*pieces));
}

}  // namespace dioptre
