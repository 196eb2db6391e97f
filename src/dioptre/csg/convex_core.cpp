// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/convex_core.h"

#include <algorithm>

namespace dioptre::csg {
namespace {

/// Cuts the window to the side of an end where its leaf is.
bool cut(const Crossing& end, Interval& window) {
  if (!std::isfinite(end.t)) return true;
  if (end.entering) {
    window.min = std::max(window.min, before(end.t - end.error));
  } else {
    window.max = std::min(window.max, after(end.t + end.error));
  }
  return !window.empty();
}

}  // namespace

void ConvexCore::add(const PlacedLeaf& leaf, std::uint32_t id) {
  if (leaf.half_space()) {
    half_spaces_.push_back({*leaf.half_space(), id});
  } else {
    others_.push_back(id);
  }
}

bool ConvexCore::meet(const std::vector<PlacedLeaf>& placed, const Ray& ray, Interval& window,
                      Crossings& ends) const {
  const Vec3 origin = abs(ray.origin), direction = abs(ray.direction);
  const double away = half_spaces_.empty() ? 0 : max_component(origin) / max_component(direction);
  for (const auto& [half, id] : half_spaces_) {
    const double slope = dot(ray.direction, half.normal);
    const double height = dot(ray.origin, half.normal) - half.distance;
    const double inverse = 1 / slope;
    double t = -height * inverse;
    if (!std::isfinite(t)) {  // along the face
      if (!(height <= 0)) return false;
      t = slope < 0 ? -kInfinity : kInfinity;
    }
    const double terms = dot(origin, half.normal_terms) + half.distance_terms +
                         std::fabs(t) * dot(direction, half.normal_terms);
    const double error =
        6 * kRounding * terms * std::fabs(inverse) + kPlacementError * (std::fabs(t) + away);
    ends.push_back({.t = t, .error = error, .leaf = id, .entering = slope < 0});
    if (!cut(ends.back(), window)) return false;
  }
  for (const std::uint32_t id : others_) {
    std::array<Crossing, 2> both;
    if (!placed[id].stretch(ray, id, both)) return false;
    for (const Crossing& end : both) {
      ends.push_back(end);
      if (!cut(end, window)) return false;
    }
  }
  return true;
}

bool stands_alone(const Crossings& ends, const Crossing& end) {
  for (const Crossing& other : ends) {
    if ((other.leaf == end.leaf && other.t == end.t) || !std::isfinite(other.t)) continue;
    if (!(std::fabs(other.t - end.t) > other.error + end.error)) return false;
  }
  return true;
}

NearestEnd nearest_end(const Crossings& ends, Interval range, Crossing& out) {
  const Crossing *enter = nullptr, *exit = nullptr;
  for (const Crossing& end : ends) {
    if (!std::isfinite(end.t)) continue;
    if (end.entering) {
      if (enter == nullptr || end.t > enter->t) enter = &end;
    } else {
      if (exit == nullptr || end.t < exit->t) exit = &end;
    }
  }
  for (const Crossing* end : {enter, exit}) {
    if (end == nullptr) continue;
    if (!stands_alone(ends, *end)) return NearestEnd::kUnclear;
    if (enter != nullptr && exit != nullptr && !(enter->t < exit->t)) return NearestEnd::kNone;
    if (!end->visible || end->t - end->error <= range.min) continue;
    if (!range.surrounds(end->t)) return NearestEnd::kNone;
    out = *end;
    return NearestEnd::kFound;
  }
  return NearestEnd::kNone;
}

}  // namespace dioptre::csg
