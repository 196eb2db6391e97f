// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "dioptre/core/interval.h"

namespace dioptre {

/// The largest degree that polynomial_roots takes.
inline constexpr std::size_t kMaxDegree = 35;

/// Where a polynomial changes its sign, in order.
struct PolynomialRoots {
  std::size_t count = 0;
  std::array<double, kMaxDegree> t{};
  std::array<double, kMaxDegree> error{};  ///< a bound on the distance to the true root
};

/// The sign changes of c[0] + c[1] t + ... + c[n] t^n inside a finite interval, n <= kMaxDegree.
/// Between two neighbouring extrema a polynomial is monotone: the extrema are the roots of the
/// derivative, found the same way, and a bracketed Newton iteration finds the root between them.
/// Touching roots without a change of sign are left out. Nothing for coefficients that are not
/// finite.
PolynomialRoots polynomial_roots(std::span<const double> coefficients, Interval interval);

/// A bound on the size of all real roots: 2 max |c[n-k] / c[n]|^(1/k) (M. Fujiwara, "Ueber die
/// obere Schranke des absoluten Betrages der Wurzeln einer algebraischen Gleichung", 1916). It
/// scales with the roots; infinite for the zero polynomial.
double root_bound(std::span<const double> coefficients);

}  // namespace dioptre
