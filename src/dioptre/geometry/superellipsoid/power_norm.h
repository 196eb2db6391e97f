// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

namespace dioptre {

/// (a^p + b^p)^(1/p) for a, b >= 0 with its partial derivatives. With the larger one taken out no
/// power overflows, and the relative error is a few roundings whatever p is.
class PowerNorm {
 public:
  template <class Real>
  struct JetOf {
    Real value = 0, by_a = 0, by_b = 0;
  };
  using Jet = JetOf<double>;

  /// 0 < p.
  explicit PowerNorm(double p) : p_(p), inverse_(1 / p) {
    const bool whole = p == std::floor(p) && p <= kLargestWhole;
    whole_ = whole ? static_cast<unsigned>(p) : 0;
  }

  double value(double a, double b) const {
    const double high = a > b ? a : b, low = a > b ? b : a;
    return high > 0 ? high * root(1 + power(low / high)) : 0;
  }

  /// In float it takes about half the time.
  template <class Real>
  JetOf<Real> jet(Real a, Real b) const {
    const bool swapped = b > a;
    const Real high = swapped ? b : a, low = swapped ? a : b;
    if (!(high > 0)) return {};
    const Real ratio = low / high, r = power(ratio), k = root(1 + r);
    const Real by_high = k / (1 + r);
    // r / ratio = ratio^(p - 1); for p < 1 it has a pole at 0, where there is no normal.
    const Real by_low = ratio > 0 ? by_high * (r / ratio) : p_ == 1 ? by_high : 0;
    if (swapped) return {high * k, by_low, by_high};
    return {high * k, by_high, by_low};
  }

  /// The b >= 0 that makes the norm of (a, b) 1, for a in [0, 1], and its slope by a, which may be
  /// infinite; 0 for larger a.
  Jet rest(double a) const {
    if (a >= 1) return {0, p_ < 1 ? 0 : -std::numeric_limits<double>::infinity(), 0};
    const double r = power(a), b = std::pow(1 - r, inverse_);
    // -(a / b)^(p - 1), with the powers that are there.
    return {b,
            a > 0     ? -(r / a) * (b / (1 - r))
            : p_ > 1  ? 0
            : p_ == 1 ? -1
                      : -std::numeric_limits<double>::infinity(),
            0};
  }

  /// Whether all a, b with a norm of at most 1 form a convex set.
  bool convex() const { return p_ >= 1; }

 private:
  static constexpr double kLargestWhole = 64;

  /// x^p for x in [0, 1].
  template <class Real>
  Real power(Real x) const {
    if (whole_ == 0) return std::pow(x, static_cast<Real>(p_));
    Real result = whole_ & 1 ? x : 1;
    for (unsigned n = whole_ >> 1; n != 0; n >>= 1) {
      x *= x;
      if (n & 1) result *= x;
    }
    return result;
  }
  /// x^(1/p) for x in [1, 2].
  template <class Real>
  Real root(Real x) const {
    if (whole_ == 2) return std::sqrt(x);
    if (whole_ == 4) return std::sqrt(std::sqrt(x));
    return x == 1 ? 1 : std::pow(x, static_cast<Real>(inverse_));
  }

  double p_, inverse_;
  unsigned whole_;  ///< p if it is a small whole number, else 0
};

}  // namespace dioptre
