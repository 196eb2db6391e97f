// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/roots.h"

#include <algorithm>
#include <cmath>

namespace dioptre {
namespace {

using Coefficients = std::array<double, kMaxDegree + 1>;

double value(const Coefficients& c, std::size_t degree, double t) {
  double v = c[degree];
  for (std::size_t k = degree; k-- > 0;) v = v * t + c[k];
  return v;
}

double slope(const Coefficients& c, std::size_t degree, double t) {
  double v = 0;
  for (std::size_t k = degree; k > 0; --k) v = v * t + static_cast<double>(k) * c[k];
  return v;
}

/// A bound on the rounding error of value().
double rounding(const Coefficients& c, std::size_t degree, double t) {
  double v = std::fabs(c[degree]);
  for (std::size_t k = degree; k-- > 0;) v = v * std::fabs(t) + std::fabs(c[k]);
  return 0x1p-52 * static_cast<double>(2 * degree) * v;
}

/// The zero between low and high, where the polynomial is monotone: Newton steps, halving where a
/// step leaves the bracket.
double zero_between(const Coefficients& c, std::size_t degree, double low, double high,
                    bool rises) {
  double t = 0.5 * (low + high);
  for (int i = 0; i < 100; ++i) {
    const double v = value(c, degree, t);
    ((v >= 0) == rises ? high : low) = t;
    double next = t - v / slope(c, degree, t);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == t || std::fabs(next - t) <= 0x1p-53 * std::fabs(t)) return next;
    t = next;
  }
  return t;
}

/// The sign changes of one polynomial, given the extrema inside the interval.
PolynomialRoots sign_changes(const Coefficients& c, std::size_t degree, Interval interval,
                             const PolynomialRoots& extrema) {
  PolynomialRoots roots;
  double low = interval.min;
  bool negative = value(c, degree, low) < 0;
  for (std::size_t i = 0; i <= extrema.count; ++i) {
    const double high = i < extrema.count ? extrema.t[i] : interval.max;
    const bool negative_there = value(c, degree, high) < 0;
    if (negative_there != negative && roots.count < kMaxDegree) {
      roots.t[roots.count++] = zero_between(c, degree, low, high, negative);
    }
    low = high;
    negative = negative_there;
  }
  return roots;
}

}  // namespace

double root_bound(std::span<const double> c) {
  std::size_t degree = c.size();
  while (degree > 0 && c[degree - 1] == 0) --degree;
  if (degree == 0) return kInfinity;
  const std::size_t top = degree - 1;
  double largest = 0;
  for (std::size_t k = 0; k < top; ++k) {
    const double ratio = std::fabs(c[k] / c[top]);
    largest = std::max(largest, std::pow(ratio, 1 / static_cast<double>(top - k)));
  }
  return 2 * largest;
}

PolynomialRoots polynomial_roots(std::span<const double> coefficients, Interval interval) {
  PolynomialRoots roots;
  std::size_t degree = std::min(coefficients.size(), kMaxDegree + 1);
  while (degree > 0 && coefficients[degree - 1] == 0) --degree;
  if (degree < 2 || interval.empty()) return roots;
  --degree;
  std::array<Coefficients, kMaxDegree + 1> derivative;
  for (std::size_t k = 0; k <= degree; ++k) {
    if (!std::isfinite(coefficients[k])) return roots;
    derivative[0][k] = coefficients[k];
  }
  for (std::size_t order = 1; order < degree; ++order) {
    for (std::size_t k = 0; k + order <= degree; ++k) {
      derivative[order][k] = derivative[order - 1][k + 1] * static_cast<double>(k + 1);
    }
  }
  for (std::size_t order = degree; order-- > 0;) {
    roots = sign_changes(derivative[order], degree - order, interval, roots);
  }
  for (std::size_t i = 0; i < roots.count; ++i) {
    const double t = roots.t[i];
    const double steep = std::fabs(slope(derivative[0], degree, t));
    const double bend = degree > 1 ? std::fabs(slope(derivative[1], degree - 1, t)) : 0;
    const double residual = rounding(derivative[0], degree, t);
    double error = interval.max - interval.min;
    if (steep > 0) error = std::min(error, 2 * residual / steep);
    if (bend > 0) error = std::min(error, 2 * std::sqrt(residual / bend));
    roots.error[i] = error + 0x1p-52 * std::fabs(t);
  }
  return roots;
}

}  // namespace dioptre
