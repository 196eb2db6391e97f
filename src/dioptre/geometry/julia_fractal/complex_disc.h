// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>

#include "dioptre/geometry/julia_fractal/julia_fractal.h"

namespace dioptre {

/// The complex numbers that are no further than a radius from a centre; all for a radius that is
/// not finite.
struct ComplexDisc {
  std::complex<double> center;
  double radius = 0;
};

/// The function's value.
std::complex<double> julia_value(JuliaFunction f, std::complex<double> exponent,
                                 std::complex<double> z);
/// The function's derivative.
std::complex<double> julia_derivative(JuliaFunction f, std::complex<double> exponent,
                                      std::complex<double> z);
/// A disc that holds the function's values in a disc, about the value at its centre: everything
/// where the disc may hold a pole or meet a branch cut.
ComplexDisc julia_disc(JuliaFunction f, std::complex<double> exponent, const ComplexDisc& z);

}  // namespace dioptre
