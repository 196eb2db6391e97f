// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/geometry/julia_fractal/complex_disc.h"
#include "dioptre/geometry/julia_fractal/julia_orbit.h"

namespace dioptre {

/// The iteration of any function of hypercomplex numbers, which works on the two complex numbers of
/// HypercomplexSquare each on its own. As PowerOrbit, but every iterate counts, and no slopes are
/// known of stretches.
class FunctionOrbit {
 public:
  FunctionOrbit(const JuliaFractal& julia, double bound, std::uint32_t steps);

  bool inside(const Quad& start) const;
  JuliaVerdict classify(const Quad& middle, const Quad& direction, double half) const;
  /// As PowerOrbit, of the iterate that decides.
  void evaluate(const Quad& start, const Quad& direction, double& value, double& slope,
                std::uint32_t more = 0) const;
  double noise(const Quad& start, double radius) const;

 private:
  using Complex = std::complex<double>;
  struct Pair {
    Complex a, b;
  };

  static Pair pair(const Quad& h);
  static double squared(const Pair& h) { return 0.5 * (std::norm(h.a) + std::norm(h.b)); }
  Pair next(const Pair& h) const;
  Pair next_slope(const Pair& h, const Pair& slope) const;

  JuliaFunction function_;
  Complex exponent_;
  Pair parameter_;
  double limit_;
  std::uint32_t steps_;
};

}  // namespace dioptre
