// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/outline/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

/// Appends the two cap planes as events; false if the ray never is between them.
bool add_caps(Slab slab, const SweepRay& ray, Crossings& out) {
  if (ray.climb == 0) return slab.low <= ray.height && ray.height <= slab.high;
  for (const std::uint32_t cap : {kLowCap, kHighCap}) {
    const double height = cap == kLowCap ? slab.low : slab.high;
    Crossing event;
    event.t = (height - ray.height) / ray.climb;
    event.face = cap;
    event.error = (ray.position_error + 2 * kEpsilon * std::fabs(height)) / std::fabs(ray.climb);
    if (!std::isfinite(event.t)) return false;
    out.push_back(event);
  }
  return true;
}

/// Sorts the events out[first..] and keeps those where the ray enters or leaves both the outline
/// and the slab. The side events carry their winding in v.
void keep_changes(FillRule rule, int winding, bool between, double shift, Crossings& out,
                  std::size_t first) {
  for (std::size_t i = first; i < out.size(); ++i) {
    if (std::isnan(out[i].t)) out[i].t = kInfinity;  // an overflow; NaN has no place in an order
  }
  const auto begin = out.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, out.end(), [](const Crossing& a, const Crossing& b) {
    return a.t != b.t ? a.t < b.t : a.face < b.face;
  });
  bool inside = false;
  std::size_t kept = first;
  for (std::size_t i = first; i < out.size(); ++i) {
    Crossing event = out[i];
    if (event.face < kFirstSide) {
      between = !between;
    } else {
      winding += static_cast<int>(event.v);
    }
    const bool filled = rule == FillRule::kEvenOdd ? (winding & 1) != 0 : winding != 0;
    if ((filled && between) == inside) continue;
    inside = !inside;
    event.entering = inside;
    event.v = 0;
    event.error += 4 * kEpsilon * std::fabs(event.t);
    event.t += shift;
    event.error += kEpsilon * (std::fabs(event.t) + std::fabs(shift));
    out[kept++] = event;
  }
  if (inside && kept > first) --kept;  // never left: an infinite span is no part of a swept solid
  out.resize(kept);
}

bool filled_at(const Outline& outline, FillRule rule, Vec2 p) {
  return rule == FillRule::kEvenOdd ? outline.contains_even_odd(p) : outline.winding(p) != 0;
}

}  // namespace

void cross_linear_sweep(const Outline& outline, FillRule rule, Slab slab, const SweepRay& ray,
                        Crossings& out) {
  const std::size_t first = out.size();
  if (!add_caps(slab, ray, out)) {
    out.resize(first);
    return;
  }
  const bool between = ray.climb == 0;
  const double squared = dot(ray.direction, ray.direction);
  if (squared == 0) {
    if (!filled_at(outline, rule, ray.origin)) out.resize(first);
    return keep_changes(FillRule::kNonZero, 1, between, ray.shift, out, first);
  }
  const double speed = std::sqrt(squared);
  const PlaneLine line{ray.origin, {-ray.direction.y, ray.direction.x}, ray.position_error};
  outline.cross(line, [&](const OutlineCrossing& crossing) {
    const Curve& curve = outline.curves()[crossing.curve];
    Crossing event;
    event.t = dot(curve.at(crossing.s) - ray.origin, ray.direction) / squared;
    event.error =
        std::fabs(dot(curve.tangent(crossing.s), ray.direction)) / squared * crossing.s_error +
        ray.position_error / speed;
    event.face = kFirstSide + crossing.curve;
    event.u = crossing.s;
    event.v = crossing.winding;
    out.push_back(event);
  });
  keep_changes(rule, 0, between, ray.shift, out, first);
}

void cross_conic_sweep(const Outline& outline, Slab slab, const SweepRay& ray, Crossings& out) {
  const std::size_t first = out.size();
  if (ray.height == 0 || !add_caps(slab, ray, out)) {
    out.resize(first);
    return;
  }
  // The ray seen from the apex, in the plane at height 1: a line through `anchor`.
  const bool between = ray.climb == 0;
  const Vec2 anchor = ray.origin * (1 / ray.height);
  const Vec2 along = ray.direction - ray.climb * anchor;
  if (along == Vec2{}) {
    if (!outline.contains_even_odd(anchor)) out.resize(first);
    return keep_changes(FillRule::kNonZero, 1, between, ray.shift, out, first);
  }
  const double apex = ray.climb == 0 ? -kInfinity : -ray.height / ray.climb;
  const PlaneLine line{anchor, {-along.y, along.x}, ray.position_error / std::fabs(ray.height)};
  int before_apex = 0;
  outline.cross(line, [&](const OutlineCrossing& crossing) {
    const Curve& curve = outline.curves()[crossing.curve];
    const Vec2 p = curve.at(crossing.s);
    const Vec2 e = ray.direction - ray.climb * p, g = ray.height * p - ray.origin;
    const double squared = dot(e, e);
    Crossing event;
    event.t = dot(g, e) / squared;
    const double height = std::fabs(ray.height + event.t * ray.climb);
    event.error =
        (height * length(curve.tangent(crossing.s)) * crossing.s_error + ray.position_error) /
        std::sqrt(squared);
    event.face = kFirstSide + crossing.curve;
    event.u = crossing.s;
    event.v = crossing.winding;
    before_apex += event.t < apex;  // false for NaN, which counts as infinity
    out.push_back(event);
  });
  // At the apex plane the line goes through infinity, outside every outline; so the number of
  // crossings before it says where the ray begins.
  keep_changes(FillRule::kEvenOdd, before_apex & 1, between, ray.shift, out, first);
}

bool keep_range(Crossings& out, std::size_t first, Interval range) {
  bool inside = false;
  std::size_t kept = first;
  for (std::size_t i = first; i < out.size(); ++i) {
    if (out[i].t <= range.min) {
      inside = out[i].entering;
    } else if (out[i].t < range.max) {
      out[kept++] = out[i];
    }
  }
  out.resize(kept);
  return inside;
}

}  // namespace dioptre
