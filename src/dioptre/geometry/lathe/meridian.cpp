// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/lathe/meridian.h"

namespace dioptre {
namespace {

template <std::size_t N>
bool odd_number_outwards(const Curve& curve, Vec2 from) {
  Bernstein<N> above;
  for (std::size_t i = 0; i <= N; ++i) above[i] = curve.points[i].y - from.y;
  const SignChanges<N> changes = sign_changes<N>(above);
  bool odd = false;
  for (std::size_t i = 0; i < changes.count; ++i) {
    odd ^= std::fabs(curve.at(changes.at[i].s).x) > from.x;
  }
  return odd;
}

}  // namespace

bool odd_number_outwards(const Curve& curve, Vec2 from) {
  switch (curve.degree) {
    case 1:
      return odd_number_outwards<1>(curve, from);
    case 2:
      return odd_number_outwards<2>(curve, from);
    default:
      return odd_number_outwards<3>(curve, from);
  }
}

Meridian::Meridian(Vec3 origin, Vec3 direction, double misplaced)
    : height_(origin.y),
      climb_(direction.y),
      level_(std::hypot(direction.x, direction.z)),
      misplaced_(misplaced) {
  if (level_ > 0) {
    at_origin_ = (origin.x * direction.x + origin.z * direction.z) / level_;
    miss_ = std::fabs(origin.x * direction.z - origin.z * direction.x) / level_;
  } else {
    at_origin_ = 0;
    miss_ = std::hypot(origin.x, origin.z);
  }
}

bool Meridian::may_meet(const LatheCurve& piece) const {
  constexpr double kSlack = 1e-9;  // of the lathe's size, far above rounding
  const double reach = piece.radius.max + kSlack;
  if (miss_ > reach) return false;
  const double half = std::sqrt(reach * reach - miss_ * miss_);
  double low = -half, high = half;  // of `along` within the cylinder
  const double below = piece.height.min - kSlack - height_;
  const double above = piece.height.max + kSlack - height_;
  if (std::fabs(climb_) < kLevel) {
    if (below > 2 * kLevel || above < -2 * kLevel) return false;
  } else {
    const double slope = level_ / climb_;
    const double a = at_origin_ + below * slope, b = at_origin_ + above * slope;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
    if (low > high) return false;
  }
  const double farthest = std::max(low * low, high * high) + miss_ * miss_;
  const double hole = piece.radius.min - kSlack;
  return hole <= 0 || farthest >= hole * hole;
}

MeridianCrossing Meridian::polished(const Curve& curve, double s, double distance) const {
  MeridianCrossing at{s, distance, 0};
  const int steps = std::fabs(climb_) > 0.1 ? 1 : 3;
  double steep = 0;
  for (int i = 0; i <= steps; ++i) {
    const Vec2 p = curve.at(at.s), tangent = curve.tangent(at.s);
    const double along = at_origin_ + level_ * at.distance;
    // Of y(s) = height + climb d and x(s)^2 = miss^2 + along^2.
    const double f = p.y - height_ - climb_ * at.distance;
    const double g = 0.5 * (p.x * p.x - miss_ * miss_ - along * along);
    const double det = p.x * tangent.x * climb_ - along * level_ * tangent.y;
    const double size = length(tangent) * std::max(std::fabs(p.x), 1e-3);
    steep = std::fabs(det) / size;
    if (i == steps || !(steep > 1e-7)) break;
    const double ds = (along * level_ * f - climb_ * g) / det;
    const double dd = (tangent.y * g * -1 + p.x * tangent.x * f) / det;
    if (!(std::fabs(ds) < 1e-3) || !(std::fabs(dd) < 1e-2)) break;
    at.s = std::clamp(at.s + ds, 0.0, 1.0);
    at.distance += dd;
  }
  const double grazing = std::sqrt(4 * misplaced_);
  at.error = steep > 0 ? std::min(4 * misplaced_ / steep, grazing) : grazing;
  return at;
}

}  // namespace dioptre
