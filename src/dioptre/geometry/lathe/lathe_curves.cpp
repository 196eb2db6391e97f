// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/lathe/lathe_curves.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/outline/spline_curves.h"

namespace dioptre {
namespace {

Result<void> check(const Lathe& lathe) {
  Result<void> checked = check_points("lathe", lathe.spline, lathe.points, false);
  if (!checked) return checked;
  for (const Vec2 p : lathe.points) {
    if (p.x < 0) return fail("lathe point has a negative distance from the axis");
  }
  return {};
}

/// Adds to the box where a coordinate of the curve turns.
template <std::size_t N>
void add_turns(const Curve& curve, PlaneBounds& box) {
  Bernstein<N - 1> x, y;
  for (std::size_t i = 0; i < N; ++i) {
    const Vec2 step = curve.points[i + 1] - curve.points[i];
    x[i] = step.x, y[i] = step.y;
  }
  for (const Bernstein<N - 1>& derivative : {x, y}) {
    const SignChanges<N - 1> turns = sign_changes<N - 1>(derivative);
    for (std::size_t i = 0; i < turns.count; ++i) box.add(curve.at(turns.at[i].s));
  }
}

LatheCurve lathe_curve(const Curve& curve, bool visible) {
  PlaneBounds box;
  box.add(curve.begin());
  box.add(curve.end());
  if (curve.degree == 2) add_turns<2>(curve, box);
  if (curve.degree == 3) add_turns<3>(curve, box);
  LatheCurve out;
  out.curve = curve;
  out.visible = visible;
  out.height = {box.min.y, box.max.y};
  out.radius = {std::max({0.0, box.min.x, -box.max.x}), std::max(box.max.x, -box.min.x)};
  return out;
}

/// Closes each chain of curves by lines from its ends to the radius `inner`, and along that.
void add_closed(const std::vector<LatheCurve>& open, double inner, std::vector<LatheCurve>& all) {
  const auto close_with = [&](Vec2 a, Vec2 b) {
    if (a != b && (a.x != 0 || b.x != 0)) all.push_back(lathe_curve(line(a, b), false));
  };
  std::size_t begin = 0;
  for (std::size_t i = 0; i < open.size(); ++i) {
    all.push_back(open[i]);
    const Vec2 end = open[i].curve.end(), first = open[begin].curve.begin();
    if (i + 1 < open.size() && open[i + 1].curve.begin() == end) continue;
    begin = i + 1;
    if (end == first) continue;
    close_with(end, {inner, end.y});
    close_with({inner, end.y}, {inner, first.y});
    close_with({inner, first.y}, first);
  }
}

bool is_point(const Curve& curve) {
  for (int i = 1; i <= curve.degree; ++i) {
    if (curve.points[static_cast<std::size_t>(i)] != curve.points[0]) return false;
  }
  return true;
}

}  // namespace

Result<LatheCurves> lathe_curves(const Lathe& lathe) {
  if (auto checked = check(lathe); !checked) return tl::unexpected<Error>(checked.error());
  LatheCurves out;
  out.scale = 0;
  for (const Vec2 p : lathe.points) out.scale = std::max({out.scale, p.x, std::fabs(p.y)});
  if (!(out.scale > 1e-300)) return fail("lathe points are all at the origin");
  std::vector<Vec2> points = lathe.points;
  for (Vec2& p : points) p = {p.x / out.scale, p.y / out.scale};

  const std::vector<Curve> curves = spline_curves(lathe.spline, points);
  std::vector<LatheCurve> pieces;
  double inner = kInfinity;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (is_point(curves[i])) continue;
    pieces.push_back(lathe_curve(curves[i], true));
    pieces.back().v_begin = static_cast<double>(i) / static_cast<double>(curves.size());
    pieces.back().v_end = static_cast<double>(i + 1) / static_cast<double>(curves.size());
    inner = std::min(inner, pieces.back().radius.min);
  }
  if (pieces.empty()) return fail("lathe points are all the same");
  add_closed(pieces, inner, out.curves);
  return out;
}

}  // namespace dioptre
