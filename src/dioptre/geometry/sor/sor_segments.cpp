// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/sor/sor_segments.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dioptre {
namespace {

/// The polar form (blossom) of the polynomial: its value with another argument for each factor.
double blossom(const Bernstein<3>& b, double u, double v, double w) {
  const auto mix = [](double x, double y, double s) { return (1 - s) * x + s * y; };
  const double b01 = mix(b[0], b[1], u), b12 = mix(b[1], b[2], u), b23 = mix(b[2], b[3], u);
  return mix(mix(b01, b12, v), mix(b12, b23, v), w);
}

Result<void> check(const Sor& sor) {
  if (sor.points.size() < 4) {
    return fail("sor needs at least 4 points, found " + std::to_string(sor.points.size()));
  }
  for (std::size_t i = 0; i < sor.points.size(); ++i) {
    const Vec2 p = sor.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return fail("sor point is not finite");
    if (p.x < 0) return fail("sor point has a negative radius");
    const bool on_curve = i >= 2 && i + 1 < sor.points.size();
    if (on_curve && !(sor.points[i - 1].y < p.y)) {
      return fail("sor points must rise: the height of point " + std::to_string(i + 1) +
                  " is not above that of the point before it");
    }
  }
  return {};
}

/// The largest value of the polynomial on [0, 1].
double largest(const SorSegment& segment) {
  const Bernstein<3>& b = segment.squared_radius;
  double most = std::max(b[0], b[3]);
  const SignChanges<2> turns = sign_changes<2>({b[1] - b[0], b[2] - b[1], b[3] - b[2]});
  for (std::size_t i = 0; i < turns.count; ++i) most = std::max(most, segment.at(turns.at[i].s));
  return most;
}

}  // namespace

double SorSegment::place_of(double height) const {
  return std::clamp((height - low) / (high - low), 0.0, 1.0);
}

double SorSegment::at(double s) const { return blossom(squared_radius, s, s, s); }

double SorSegment::slope(double s) const {
  const Bernstein<3>& b = squared_radius;
  const double r = 1 - s;
  const double by_s =
      3 * (r * r * (b[1] - b[0]) + 2 * r * s * (b[2] - b[1]) + s * s * (b[3] - b[2]));
  return by_s / (high - low);
}

Bernstein<3> SorSegment::part(double a, double b) const {
  return {blossom(squared_radius, a, a, a), blossom(squared_radius, a, a, b),
          blossom(squared_radius, a, b, b), blossom(squared_radius, b, b, b)};
}

Result<SorSegments> sor_segments(const Sor& sor) {
  if (auto checked = check(sor); !checked) return tl::unexpected<Error>(checked.error());
  SorSegments out;
  out.scale = 0;
  for (const Vec2 p : sor.points) out.scale = std::max({out.scale, p.x, std::fabs(p.y)});
  if (!(out.scale > 1e-300)) return fail("sor points are all at the origin");
  std::vector<Vec2> points = sor.points;
  for (Vec2& p : points) p = {p.x / out.scale, p.y / out.scale};

  double most = 0;
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    const Vec2 p = points[i], q = points[i + 1], before = points[i - 1], after = points[i + 2];
    const double rise = q.y - p.y;
    const double at_p = 2 * p.x * (q.x - before.x) / (q.y - before.y);
    const double at_q = 2 * q.x * (after.x - p.x) / (after.y - p.y);
    if (!(rise > 0) || !std::isfinite(at_p * rise) || !std::isfinite(at_q * rise)) {
      return fail("sor points give no slope: two that are next but one have the same height");
    }
    SorSegment segment{p.y, q.y, {}, 0};
    segment.squared_radius = {p.x * p.x, p.x * p.x + rise * at_p / 3, q.x * q.x - rise * at_q / 3,
                              q.x * q.x};
    segment.most = largest(segment);
    most = std::max(most, segment.most);
    out.segments.push_back(segment);
  }
  out.reach = std::sqrt(most);
  return out;
}

}  // namespace dioptre
