// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "dioptre/core/interval.h"

namespace dioptre {

/// The largest degree that polynomial_roots takes.
inline constexpr std::size_t kMaxDegree = 35;

/// Where a polynomial changes its sign, in order. Only the first `count` entries are set.
struct PolynomialRoots {
  std::size_t count = 0;
  std::array<double, kMaxDegree> t;
  std::array<double, kMaxDegree> error;  ///< a bound on the distance to the true root
  bool starts_negative = false;          ///< the sign before the first of them; 0 is positive
};

/// The sign changes of c[0] + c[1] t + ... + c[n] t^n, n <= kMaxDegree, with
/// wanted.min < t < wanted.max and within [-1, 1]; at most the first `most` of them.
/// Touching roots without a change of sign are left out. Nothing for coefficients that are not
/// finite.
///
/// The roots are isolated in the Bernstein basis; a bracketed Newton iteration follows.
PolynomialRoots polynomial_roots(std::span<const double> coefficients, Interval wanted,
                                 std::size_t most = kMaxDegree);

/// The exponent of a finite number that is not 0, as std::ilogb gives it; where that is below
/// -1022, -1023.
inline int exponent_of(double v) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(v) >> 52 & 0x7ff) - 1023;
}

/// 2^e for -1022 <= e <= 1023.
inline double power_of_two(int e) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}

/// The exponent e of a power of two that is above the size of all real roots, after
/// 2 max |c[n-k] / c[n]|^(1/k) (M. Fujiwara, "Ueber die obere Schranke des absoluten Betrages der
/// Wurzeln einer algebraischen Gleichung", 1916); at most 2 too large. The last coefficient is not
/// 0.
int root_bound_exponent(std::span<const double> coefficients);

}  // namespace dioptre
