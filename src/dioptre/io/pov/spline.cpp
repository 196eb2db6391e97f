// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/spline.h"

#include <algorithm>
#include <cmath>

namespace dioptre::pov {
namespace {

using Vector = std::array<double, 5>;
using Knots = std::vector<Spline::Knot>;

Vector blend(const Vector& a, double wa, const Vector& b, double wb) {
  Vector sum;
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = wa * a[k] + wb * b[k];
  return sum;
}

/// The parabola through three knots.
Vector parabola(const Spline::Knot& a, const Spline::Knot& b, const Spline::Knot& c, double at) {
  const double wa = (at - b.at) * (at - c.at) / ((a.at - b.at) * (a.at - c.at));
  const double wb = (at - a.at) * (at - c.at) / ((b.at - a.at) * (b.at - c.at));
  const double wc = (at - a.at) * (at - b.at) / ((c.at - a.at) * (c.at - b.at));
  return blend(blend(a.value, wa, b.value, wb), 1, c.value, wc);
}

/// The slope at the middle one of three knots: the mean of the slopes beside it.
Vector slope(const Spline::Knot* middle) {
  const double before = 0.5 / (middle[0].at - middle[-1].at);
  const double after = 0.5 / (middle[1].at - middle[0].at);
  return blend(blend(middle[0].value, before - after, middle[-1].value, -before), 1,
               middle[1].value, after);
}

/// The cubic with given values and slopes at both ends.
Vector hermite(const Spline::Knot* left, double at) {
  const double h = left[1].at - left[0].at;
  const double u = (at - left[0].at) / h, u2 = u * u, u3 = u2 * u;
  const Vector values = blend(left[0].value, 2 * u3 - 3 * u2 + 1, left[1].value, 3 * u2 - 2 * u3);
  const Vector slopes = blend(slope(left), h * (u3 - 2 * u2 + u), slope(left + 1), h * (u3 - u2));
  return blend(values, 1, slopes, 1);
}

/// The cubic with given values and second derivatives at both ends.
Vector natural(const Spline& spline, std::size_t i, double at) {
  const Spline::Knot &left = spline.knots[i], &right = spline.knots[i + 1];
  const double h = right.at - left.at;
  const double a = (right.at - at) / h, b = 1 - a;
  const Vector line = blend(left.value, a, right.value, b);
  const Vector bend = blend(spline.curvatures[i], (a * a * a - a) * h * h / 6,
                            spline.curvatures[i + 1], (b * b * b - b) * h * h / 6);
  return blend(line, 1, bend, 1);
}

Vector cubic(const Knots& knots, double at) {
  const std::size_t n = knots.size();
  if (n == 2) return blend(knots[0].value, 0.5, knots[1].value, 0.5);
  if (at <= knots[1].at) return knots[1].value;
  if (at >= knots[n - 2].at) return knots[n - 2].value;
  std::size_t i = 1;
  while (at > knots[i + 1].at) ++i;
  return hermite(&knots[i], at);
}

}  // namespace

void Spline::insert(const Knot& knot) {
  const auto place = std::lower_bound(knots.begin(), knots.end(), knot.at,
                                      [](const Knot& k, double at) { return k.at < at; });
  if (place != knots.end() && place->at == knot.at) {
    *place = knot;
  } else {
    knots.insert(place, knot);
  }
}

void Spline::finish() {
  const std::size_t n = knots.size();
  curvatures.assign(n, {});
  if (n < 3) return;
  // The tridiagonal system of a spline with continuous second derivatives, zero at the ends.
  std::vector<double> upper(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double h0 = knots[i].at - knots[i - 1].at, h1 = knots[i + 1].at - knots[i].at;
    const double pivot = 2 * (h0 + h1) - h0 * upper[i - 1];
    upper[i] = h1 / pivot;
    for (std::size_t k = 0; k < 5; ++k) {
      const double bend = (knots[i + 1].value[k] - knots[i].value[k]) / h1 -
                          (knots[i].value[k] - knots[i - 1].value[k]) / h0;
      curvatures[i][k] = (6 * bend - h0 * curvatures[i - 1][k]) / pivot;
    }
  }
  for (std::size_t i = n - 2; i > 0; --i) {
    for (std::size_t k = 0; k < 5; ++k) curvatures[i][k] -= upper[i] * curvatures[i + 1][k];
  }
}

std::array<double, 5> evaluate(const Spline& spline, Spline::Kind kind, double at) {
  const Knots& knots = spline.knots;
  if (knots.empty()) return {};
  const std::size_t n = knots.size();
  if (n == 1) return knots[0].value;
  if (kind == Spline::Kind::kCubic) return cubic(knots, at);
  if (!(at > knots.front().at)) return knots.front().value;
  if (at >= knots.back().at) return knots.back().value;
  const auto after = std::upper_bound(knots.begin(), knots.end(), at,
                                      [](double t, const Spline::Knot& k) { return t < k.at; });
  const std::size_t i = static_cast<std::size_t>(after - knots.begin()) - 1;
  if (kind == Spline::Kind::kNatural) return natural(spline, i, at);
  if (kind == Spline::Kind::kQuadratic && n > 2) {
    const std::size_t first = i == 0 ? 0 : i - 1;
    return parabola(knots[first], knots[first + 1], knots[first + 2], at);
  }
  const double u = (at - knots[i].at) / (knots[i + 1].at - knots[i].at);
  return blend(knots[i].value, 1 - u, knots[i + 1].value, u);
}

}  // namespace dioptre::pov
