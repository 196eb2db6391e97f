// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "dioptre/core/isolate.h"
#include "dioptre/core/newton.h"

namespace dioptre {

/// A sign change of a polynomial on [0,1]: where, and whether it goes up (from negative to not).
struct SignChange {
  double s = 0;
  bool rises = false;
};

/// The coefficients of a polynomial of degree N on [0,1] in the Bernstein basis: the first and the
/// last are its values at 0 and 1, and it stays between the smallest and the largest.
template <std::size_t N>
using Bernstein = std::array<double, N + 1>;

/// The sign changes on [0,1], at most N, in order. Zero counts as positive, so that the signs of
/// the first and the last coefficient alone say whether their number is odd: pieces that share an
/// end value can neither lose nor double a crossing there.
template <std::size_t N>
struct SignChanges {
  std::array<SignChange, N> at{};
  std::size_t count = 0;
};

/// True if all coefficients have one sign: the polynomial then has no sign change.
template <std::size_t N>
bool keeps_sign(const Bernstein<N>& b) {
  std::size_t negative = 0;
  for (const double c : b) negative += c < 0;
  return negative == 0 || negative == N + 1;
}

/// Value and derivatives of a polynomial in powers of s.
template <std::size_t N>
struct PowerBasis {
  std::array<double, N + 1> c{};

  explicit PowerBasis(const Bernstein<N>& b) {
    std::array<double, N + 1> difference = b;  // forward differences, row by row
    double binomial = 1;
    for (std::size_t k = 0; k <= N; ++k) {
      c[k] = binomial * difference[0];
      for (std::size_t i = 0; i + k < N; ++i) difference[i] = difference[i + 1] - difference[i];
      binomial = binomial * static_cast<double>(N - k) / static_cast<double>(k + 1);
    }
  }
  double value(double s) const {
    double v = c[N];
    for (std::size_t k = N; k-- > 0;) v = v * s + c[k];
    return v;
  }
  double slope(double s) const {
    double v, slope;
    evaluate(s, v, slope);
    return slope;
  }
  /// Value, slope and half the second derivative.
  void evaluate(double s, double& value, double& slope, double& bend) const {
    value = c[N];
    slope = bend = 0;
    for (std::size_t k = N; k-- > 0;) {
      bend = bend * s + slope;
      slope = slope * s + value;
      value = value * s + c[k];
    }
  }
  void evaluate(double s, double& value, double& slope) const {
    value = c[N];
    slope = 0;
    for (std::size_t k = N; k-- > 0;) {
      slope = slope * s + value;
      value = value * s + c[k];
    }
  }
};

/// Finds all sign changes.
template <std::size_t N>
SignChanges<N> sign_changes(const Bernstein<N>& b) {
  SignChanges<N> found;
  if (keeps_sign<N>(b)) return found;
  if constexpr (N == 1) {
    found.at[0] = {b[0] / (b[0] - b[1]), b[0] < 0};
    found.count = 1;
    return found;
  }
  const PowerBasis<N> p(b);
  isolate_sign_changes(
      b, N, [](double, double) { return false; },
      [&](double low, double high, double at_low, double at_high) {
        const bool rises = at_low < 0;
        const double root =
            bracketed_halley([&p](double s, double& value, double& slope,
                                  double& bend) { p.evaluate(s, value, slope, bend); },
                             low, high, low + at_low / (at_low - at_high) * (high - low), rises);
        found.at[found.count++] = {root, rises};
        return found.count < N;
      });
  return found;
}

}  // namespace dioptre
