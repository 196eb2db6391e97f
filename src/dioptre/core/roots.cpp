// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/roots.h"

#include <algorithm>
#include <cmath>

#include "dioptre/core/isolate.h"
#include "dioptre/core/newton.h"

namespace dioptre {
namespace {

/// 1 / C(n,k) for all degrees.
class InverseBinomials {
 public:
  constexpr InverseBinomials() : of_{} {
    for (std::size_t n = 0; n <= kMaxDegree; ++n) {
      double binomial = 1;
      for (std::size_t k = 0; k <= n; ++k) {
        of_[n][k] = 1 / binomial;
        binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
      }
    }
  }
  const std::array<double, kMaxDegree + 1>& of(std::size_t n) const { return of_[n]; }

 private:
  std::array<double, kMaxDegree + 1> of_[kMaxDegree + 1];
};
constexpr InverseBinomials kInverseBinomials;

/// One search. kDegree is the degree where the compiler may know it, else 0.
template <std::size_t kDegree>
class Search {
 public:
  Search(std::span<const double> c, Interval wanted, std::size_t most, PolynomialRoots& roots)
      : c_(c), wanted_(wanted), most_(most), roots_(roots) {}

  /// Looks at t from `start` to start + 1: -1 to 0 or 0 to 1.
  void half(double start) {
    Row b;
    to_bernstein(start < 0 ? -1 : 1, b);
    if (start < 0) std::reverse(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(degree()) + 1);
    isolate_sign_changes(
        b, degree(),
        [&](double low, double high) {
          return start + high <= wanted_.min || start + low >= wanted_.max;
        },
        [&](double low, double high, double at_low, double at_high) {
          add(start + low, start + high, at_low, at_high);
          return roots_.count < most_;
        });
  }

 private:
  using Row = std::array<double, (kDegree != 0 ? kDegree : kMaxDegree) + 1>;

  std::size_t degree() const { return kDegree != 0 ? kDegree : c_.size() - 1; }

  /// The polynomial in t = sign s on [0, 1]: b[i] = sum of C(i,k) / C(n,k) c[k] over k, the
  /// binomials by repeated sums.
  void to_bernstein(double sign, Row& b) const {
    const std::size_t n = degree();
    const auto& inverse = kInverseBinomials.of(n);
    double power = 1;
    for (std::size_t k = 0; k <= n; ++k, power *= sign) b[k] = power * c_[k] * inverse[k];
    for (std::size_t round = 1; round <= n; ++round) {
      for (std::size_t i = n; i >= round; --i) b[i] += b[i - 1];
    }
  }

  /// Value, slope and half the second derivative at t (Horner's scheme).
  void evaluate(double t, double& value, double& slope, double& bend) const {
    value = c_[degree()];
    slope = bend = 0;
    for (std::size_t k = degree(); k-- > 0;) {
      bend = bend * t + slope;
      slope = slope * t + value;
      value = value * t + c_[k];
    }
  }

  void add(double low, double high, double at_low, double at_high) {
    const bool rises = at_low < 0;
    const double t =
        bracketed_halley([this](double at, double& value, double& slope,
                                double& bend) { evaluate(at, value, slope, bend); },
                         low, high, low + at_low / (at_low - at_high) * (high - low), rises);
    if (!wanted_.surrounds(t)) return;
    if (roots_.count == 0) roots_.starts_negative = rises;
    roots_.t[roots_.count] = t;
    roots_.error[roots_.count++] = error_at(t);
  }

  /// A bound on the error of a root: of the first order where the slope is steep, of the second
  /// where it is flat.
  double error_at(double t) const {
    const std::size_t n = degree();
    double value = c_[n], slope = 0, bend = 0, size = std::fabs(value);
    for (std::size_t k = n; k-- > 0;) {
      bend = bend * t + slope;
      slope = slope * t + value;
      value = value * t + c_[k];
      size = size * std::fabs(t) + std::fabs(c_[k]);
    }
    const double residual = 0x1p-52 * static_cast<double>(2 * n) * size;
    double error = 2;
    if (slope != 0) error = std::min(error, 2 * residual / std::fabs(slope));
    if (bend != 0) error = std::min(error, 2 * std::sqrt(residual / (2 * std::fabs(bend))));
    return error + 0x1p-52 * std::fabs(t);
  }

  std::span<const double> c_;
  Interval wanted_;
  std::size_t most_;
  PolynomialRoots& roots_;
};

template <std::size_t kDegree>
void search(std::span<const double> c, Interval wanted, std::size_t most, PolynomialRoots& roots) {
  Search<kDegree> search(c, wanted, most, roots);
  if (wanted.min < 0) search.half(-1);
  if (wanted.max > 0 && roots.count < most) search.half(0);
}

bool negative_at(std::span<const double> c, double t) {
  double v = 0;
  for (std::size_t k = c.size(); k-- > 0;) v = v * t + c[k];
  return v < 0;
}

}  // namespace

int root_bound_exponent(std::span<const double> c) {
  const std::size_t n = c.size() - 1;
  const int top = std::ilogb(c[n]);
  int bound = -1100;
  for (std::size_t k = 0; k < n; ++k) {
    if (c[k] == 0) continue;
    const int ratio = exponent_of(c[k]) - top + 1, order = static_cast<int>(n - k);
    // Rounded up.
    bound = std::max(bound, ratio >= 0 ? (ratio + order - 1) / order : -(-ratio / order));
  }
  return bound + 1;
}

PolynomialRoots polynomial_roots(std::span<const double> coefficients, Interval wanted,
                                 std::size_t most) {
  PolynomialRoots roots;
  std::size_t size = std::min(coefficients.size(), kMaxDegree + 1);
  while (size > 0 && coefficients[size - 1] == 0) --size;
  const std::span<const double> c = coefficients.first(size);
  if (size == 0 || !std::all_of(c.begin(), c.end(), [](double v) { return std::isfinite(v); })) {
    return roots;
  }
  if (size > 1 && !wanted.empty()) {
    switch (size - 1) {
      case 3:
        search<3>(c, wanted, most, roots);
        break;
      case 4:
        search<4>(c, wanted, most, roots);
        break;
      case 6:
        search<6>(c, wanted, most, roots);
        break;
      default:
        search<0>(c, wanted, most, roots);
    }
  }
  if (roots.count == 0) {
    const double middle =
        0.5 * (std::clamp(wanted.min, -1.0, 1.0) + std::clamp(wanted.max, -1.0, 1.0));
    roots.starts_negative = negative_at(c, middle);
  }
  return roots;
}

}  // namespace dioptre
