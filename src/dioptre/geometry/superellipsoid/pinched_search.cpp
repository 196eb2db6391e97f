// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/superellipsoid/pinched_search.h"

#include <algorithm>
#include <limits>

#include "dioptre/core/newton.h"

namespace dioptre {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kDeepest = 20;

}  // namespace

PinchedSearch::PinchedSearch(const SuperellipsoidGauge& gauge, const BoxStretch& stretch,
                             StretchRoots& roots)
    : gauge_(gauge), stretch_(stretch), roots_(roots) {}

void PinchedSearch::run() {
  std::array<double, 5> cuts{0, 1, 1, 1, 1};
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double s = -stretch_.origin[axis] / stretch_.step[axis];
    if (s > 0 && s < 1) cuts[count++] = s;
  }
  std::sort(cuts.begin(), cuts.end());
  roots_.starts_inside = sample(0, {1, 1, 1}).inside();
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i] < cuts[i + 1]) search_octant(cuts[i], cuts[i + 1]);
  }
}

void PinchedSearch::search_octant(double low, double high) {
  const Vec3 middle = stretch_.at(0.5 * (low + high));
  const Vec3 signs{std::copysign(1.0, middle.x), std::copysign(1.0, middle.y),
                   std::copysign(1.0, middle.z)};
  search(sample(low, signs), sample(high, signs), signs, 0);
}

PinchedSearch::Sample PinchedSearch::sample(double s, Vec3 signs) const {
  const Vec3 p = abs(stretch_.at(s)), d = signs * stretch_.step;
  const PowerNorm::Jet g = gauge_.flat.jet(p.x, p.y);
  const double g_slope =
      !gauge_.flat.convex() && (p.x == 0 || p.y == 0) ? kUnknown : g.by_a * d.x + g.by_b * d.y;
  const PowerNorm::Jet h = gauge_.upright.rest(p.z);
  const double h_slope = d.z == 0 ? 0 : h.by_a * d.z;
  if (!gauge_.upright.convex()) {
    if (gauge_.flat.convex()) return {s, g.value, g_slope, h.value, h_slope};
    return {s, 0, 0, h.value - g.value, h_slope - g_slope};
  }
  return {s, -h.value, -h_slope, -g.value, -g_slope};
}

void PinchedSearch::search(const Sample& a, const Sample& b, Vec3 signs, int depth) {
  const double width = b.s - a.s;
  const auto both_positive = [](double at_a, double at_b) { return at_a > 0 && at_b > 0; };
  if (a.inside() == b.inside()) {
    // Tangents from below, chords from above.
    const bool misses = a.inside() ? both_positive(a.v - a.u, a.v + a.v_slope * width - b.u) ||
                                         both_positive(b.v - b.v_slope * width - a.u, b.v - b.u)
                                   : both_positive(a.u - a.v, a.u + a.u_slope * width - b.v) ||
                                         both_positive(b.u - b.u_slope * width - a.v, b.u - b.v);
    if (misses || depth == kDeepest || left_ == 0) return;
  } else {
    const bool rises = a.u_slope - b.v_slope >= 0, falls = b.u_slope - a.v_slope <= 0;
    if (rises || falls || depth == kDeepest || left_ == 0) return add_root(a.s, b.s, a.inside());
  }
  --left_;
  const Sample middle = sample(0.5 * (a.s + b.s), signs);
  search(a, middle, signs, depth + 1);
  search(middle, b, signs, depth + 1);
}

void PinchedSearch::add_root(double low, double high, bool inside_low) {
  double steepness = 0;
  const auto excess = [&](double s, double& value, double& slope) {
    slope = dot(gauge_.gradient(stretch_.at(s), value), stretch_.step);
    value -= 1;
    steepness = slope;
  };
  const double root = bracketed_newton(excess, low, high, 0.5 * (low + high), inside_low);
  roots_.add(root, steepness);
}

}  // namespace dioptre
