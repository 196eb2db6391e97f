// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/roots.h"

#include <algorithm>
#include <cmath>

#include "dioptre/core/newton.h"

namespace dioptre {
namespace {

constexpr int kDeepest = 50;  ///< halvings; a piece is then as short as rounding

using Row = std::array<double, kMaxDegree + 1>;

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
  const Row& of(std::size_t n) const { return of_[n]; }

 private:
  Row of_[kMaxDegree + 1];
};
constexpr InverseBinomials kInverseBinomials;

/// A part of the polynomial, s in [low, high], in the Bernstein basis.
struct Piece {
  double low, high;
  int depth;
  Row b;
};

/// One search. kDegree is the degree where the compiler may know it, else 0.
template <std::size_t kDegree>
class Search {
 public:
  Search(std::span<const double> c, Interval wanted, std::size_t most, PolynomialRoots& roots)
      : c_(c), wanted_(wanted), most_(most), roots_(roots) {}

  /// Looks at t = sign * s for s in [0, 1], where the halves meet at 0.
  void half(double sign) {
    Piece pieces[kDeepest + 2];
    pieces[0].low = 0, pieces[0].high = 1, pieces[0].depth = 0;
    to_bernstein(sign, pieces[0].b);
    int count = 1;
    while (count > 0 && roots_.count < most_) {
      Piece& piece = pieces[count - 1];
      // What is nearer to -1 comes first.
      if (sign < 0 ? -piece.low <= wanted_.min || -piece.high >= wanted_.max
                   : piece.high <= wanted_.min || piece.low >= wanted_.max) {
        --count;
        continue;
      }
      const std::size_t changes = sign_changes(piece.b);
      if (changes > 1 && piece.depth < kDeepest) {
        halve(piece, pieces[count], sign < 0);
        ++count;
        continue;
      }
      --count;
      const bool at_low = piece.b[0] < 0, at_high = piece.b[degree()] < 0;
      if (at_low != at_high) add(sign, piece, at_low);
    }
  }

 private:
  std::size_t degree() const { return kDegree != 0 ? kDegree : c_.size() - 1; }

  /// b[i] = sum of C(i,k) / C(n,k) c[k] over k, the binomials by repeated sums.
  void to_bernstein(double sign, Row& b) const {
    const std::size_t n = degree();
    const Row& inverse = kInverseBinomials.of(n);
    double power = 1;
    for (std::size_t k = 0; k <= n; ++k, power *= sign) b[k] = power * c_[k] * inverse[k];
    for (std::size_t round = 1; round <= n; ++round) {
      for (std::size_t i = n; i >= round; --i) b[i] += b[i - 1];
    }
  }

  std::size_t sign_changes(const Row& b) const {
    std::size_t changes = 0;
    for (std::size_t i = 0; i < degree(); ++i) changes += (b[i] < 0) != (b[i + 1] < 0);
    return changes;
  }

  /// De Casteljau's algorithm at the middle. `next`, to be looked at first, becomes the half on
  /// the side of low, or of high if `high_first`.
  void halve(Piece& piece, Piece& next, bool high_first) const {
    const std::size_t n = degree();
    const double middle = 0.5 * (piece.low + piece.high);
    ++piece.depth;
    next.depth = piece.depth;
    Row lower, upper = piece.b;
    for (std::size_t k = 0; k < n; ++k) {
      lower[k] = upper[0];
      for (std::size_t i = 0; i < n - k; ++i) upper[i] = 0.5 * (upper[i] + upper[i + 1]);
    }
    lower[n] = upper[0];
    // The last of each round stays where it was: upper is now in order from the middle to high.
    next.low = piece.low, next.high = piece.high;
    (high_first ? next.low : next.high) = middle;
    (high_first ? piece.high : piece.low) = middle;
    std::copy_n((high_first ? upper : lower).begin(), n + 1, next.b.begin());
    std::copy_n((high_first ? lower : upper).begin(), n + 1, piece.b.begin());
  }

  /// Value and slope at t (Horner's scheme).
  void evaluate(double t, double& value, double& slope) const {
    value = c_[degree()];
    slope = 0;
    for (std::size_t k = degree(); k-- > 0;) {
      slope = slope * t + value;
      value = value * t + c_[k];
    }
  }

  void add(double sign, const Piece& piece, bool negative_at_low) {
    const double low = sign < 0 ? -piece.high : piece.low;
    const double high = sign < 0 ? -piece.low : piece.high;
    const bool rises = negative_at_low == (sign > 0);
    const double share = piece.b[0] / (piece.b[0] - piece.b[degree()]);
    const double t = bracketed_newton(
        [this](double at, double& value, double& slope) { evaluate(at, value, slope); }, low, high,
        low + (sign < 0 ? 1 - share : share) * (high - low), rises);
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
  if (wanted.max > 0) search.half(1);
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
    const int ratio = std::ilogb(c[k]) - top + 1, order = static_cast<int>(n - k);
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
