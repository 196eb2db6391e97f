// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/outline/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

Vec2 mix(Vec2 a, Vec2 b, double s) { return (1 - s) * a + s * b; }

double largest(Vec2 p) { return std::max(std::fabs(p.x), std::fabs(p.y)); }

}  // namespace

Curve line(Vec2 a, Vec2 b) { return {{a, b, {}, {}}, 1}; }
Curve quadratic(Vec2 a, Vec2 b, Vec2 c) { return {{a, b, c, {}}, 2}; }
Curve cubic(Vec2 a, Vec2 b, Vec2 c, Vec2 d) { return {{a, b, c, d}, 3}; }

Vec2 Curve::at(double s) const {
  std::array<Vec2, 4> p = points;  // de Casteljau
  for (int n = degree; n > 0; --n) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) p[i] = mix(p[i], p[i + 1], s);
  }
  return p[0];
}

Vec2 Curve::tangent(double s) const {
  std::array<Vec2, 4> p = points;
  for (int n = degree; n > 1; --n) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) p[i] = mix(p[i], p[i + 1], s);
  }
  const Vec2 derivative = static_cast<double>(degree) * (p[1] - p[0]);
  if (derivative != Vec2{}) return derivative;
  // At a cusp or a doubled control point: along the chord to whichever end is farther away.
  const Vec2 here = at(s), back = here - begin(), forth = end() - here;
  return length(forth) >= length(back) ? forth : back;
}

void PlaneBounds::add(Vec2 p) {
  min = {std::min(min.x, p.x), std::min(min.y, p.y)};
  max = {std::max(max.x, p.x), std::max(max.y, p.y)};
}

void Outline::move_to(Vec2 p) {
  close();
  start_ = p;
}

void Outline::add(const Curve& curve) {
  curves_.push_back(curve);
  for (int i = 0; i <= curve.degree; ++i) bounds_.add(curve.points[static_cast<std::size_t>(i)]);
  open_ = true;
}

void Outline::close() {
  if (open_ && !(curves_.back().end() == start_)) add(line(curves_.back().end(), start_));
  open_ = false;
}

Outline::Around Outline::winding_and_parity(Vec2 p) const {
  Around around;
  const auto count = [&](int winding) {
    around.winding += winding;
    around.odd = !around.odd;
  };
  // Along +x from p: the curves that the line crosses right of p.
  for (std::uint32_t i = 0; i < curves_.size(); ++i) {
    const Curve& curve = curves_[i];
    if (curve.degree == 1) {
      // By the side of the edge, the same from both its ends: outlines that share it also share
      // out the points beside it.
      const Vec2 a = curve.points[0] - p, b = curve.points[1] - p;
      const bool rises = a.y < 0;
      if (rises != (b.y < 0) && (rises ? dioptre::cross(a, b) : dioptre::cross(b, a)) > 0) {
        count(rises ? 1 : -1);
      }
      continue;
    }
    cross_curve({p, {0, 1}, 0}, i, [&](const OutlineCrossing& crossing) {
      if (curve.at(crossing.s).x > p.x) count(crossing.winding);
    });
  }
  return around;
}

int Outline::winding(Vec2 p) const { return winding_and_parity(p).winding; }

double Outline::parameter_error(const PlaneLine& line, const Curve& curve, double s) {
  double size = largest(line.anchor);
  for (int i = 0; i <= curve.degree; ++i) {
    size = std::max(size, largest(curve.points[static_cast<std::size_t>(i)]));
  }
  const double position = line.anchor_error + 16 * kEpsilon * size;
  const double slope = std::fabs(dot(line.normal, curve.tangent(s)));
  const double error = (std::fabs(line.normal.x) + std::fabs(line.normal.y)) * position / slope;
  return error < 1 ? error : 1;
}

}  // namespace dioptre
