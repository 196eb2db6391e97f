// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/functions/spline_function.h"

#include <algorithm>
#include <cmath>

namespace dioptre {

SplineEvaluator::SplineEvaluator(const SplineFunction& spline)
    : kind_(static_cast<Kind>(std::min(spline.kind, 3u))) {
  for (const SplineKnot& knot : spline.knots) {
    const bool has = spline.component < knot.value.size();
    if (!std::isnan(knot.at)) knots_.push_back({knot.at, has ? knot.value[spline.component] : 0});
  }
  const auto before = [](const Knot& a, const Knot& b) { return a.at < b.at; };
  std::stable_sort(knots_.begin(), knots_.end(), before);
  // Of knots at the same place the last one written counts.
  std::vector<Knot> kept;
  for (const Knot& knot : knots_) {
    if (!kept.empty() && kept.back().at == knot.at) kept.pop_back();
    kept.push_back(knot);
  }
  knots_ = std::move(kept);
  if (kind_ == Kind::kNatural) find_curvatures();
}

/// Solves the tridiagonal system of a spline with continuous second derivatives, zero at the ends.
void SplineEvaluator::find_curvatures() {
  const std::size_t n = knots_.size();
  if (n < 3) return;
  std::vector<double> upper(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double h0 = knots_[i].at - knots_[i - 1].at, h1 = knots_[i + 1].at - knots_[i].at;
    const double pivot = 2 * (h0 + h1) - h0 * upper[i - 1];
    upper[i] = h1 / pivot;
    const double bend =
        (knots_[i + 1].value - knots_[i].value) / h1 - (knots_[i].value - knots_[i - 1].value) / h0;
    knots_[i].curvature = (6 * bend - h0 * knots_[i - 1].curvature) / pivot;
  }
  for (std::size_t i = n - 2; i > 0; --i) {
    knots_[i].curvature -= upper[i] * knots_[i + 1].curvature;
  }
}

double SplineEvaluator::at(double t) const {
  const std::size_t n = knots_.size();
  if (n == 0) return 0;
  if (n == 1) return knots_[0].value;
  if (kind_ == Kind::kCubic) return cubic(t);
  if (!(t > knots_.front().at)) return knots_.front().value;
  if (t >= knots_.back().at) return knots_.back().value;
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), t,
                                      [](double v, const Knot& knot) { return v < knot.at; });
  const auto i = static_cast<std::size_t>(after - knots_.begin()) - 1;
  if (kind_ == Kind::kNatural) return natural(i, t);
  if (kind_ == Kind::kQuadratic && n > 2) return quadratic(i == 0 ? 0 : i - 1, t);
  return linear(i, t);
}

double SplineEvaluator::linear(std::size_t i, double t) const {
  const Knot &a = knots_[i], &b = knots_[i + 1];
  const double u = (t - a.at) / (b.at - a.at);
  return (1 - u) * a.value + u * b.value;
}

/// The parabola through three knots.
double SplineEvaluator::quadratic(std::size_t i, double t) const {
  const Knot &a = knots_[i], &b = knots_[i + 1], &c = knots_[i + 2];
  return a.value * (t - b.at) * (t - c.at) / ((a.at - b.at) * (a.at - c.at)) +
         b.value * (t - a.at) * (t - c.at) / ((b.at - a.at) * (b.at - c.at)) +
         c.value * (t - a.at) * (t - b.at) / ((c.at - a.at) * (c.at - b.at));
}

/// The mean of the slopes beside an inner knot.
double SplineEvaluator::slope(std::size_t i) const {
  const Knot &a = knots_[i - 1], &b = knots_[i], &c = knots_[i + 1];
  return 0.5 * ((b.value - a.value) / (b.at - a.at) + (c.value - b.value) / (c.at - b.at));
}

double SplineEvaluator::cubic(double t) const {
  const std::size_t n = knots_.size();
  if (n == 2) return 0.5 * (knots_[0].value + knots_[1].value);
  if (!(t > knots_[1].at)) return knots_[1].value;
  if (t >= knots_[n - 2].at) return knots_[n - 2].value;
  std::size_t i = 1;
  while (t > knots_[i + 1].at) ++i;
  const double h = knots_[i + 1].at - knots_[i].at;
  const double u = (t - knots_[i].at) / h, u2 = u * u, u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * knots_[i].value + (3 * u2 - 2 * u3) * knots_[i + 1].value +
         h * ((u3 - 2 * u2 + u) * slope(i) + (u3 - u2) * slope(i + 1));
}

double SplineEvaluator::natural(std::size_t i, double t) const {
  const Knot &left = knots_[i], &right = knots_[i + 1];
  const double h = right.at - left.at, a = (right.at - t) / h, b = 1 - a;
  return a * left.value + b * right.value +
         h * h / 6 * ((a * a * a - a) * left.curvature + (b * b * b - b) * right.curvature);
}

}  // namespace dioptre
