// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/julia_fractal/function_orbit.h"

namespace dioptre {

FunctionOrbit::FunctionOrbit(const JuliaFractal& julia, double bound, std::uint32_t steps)
    : function_(julia.function),
      exponent_(julia.exponent.x, julia.exponent.y),
      parameter_(pair(julia.parameter)),
      limit_(bound * bound),
      steps_(steps) {}

FunctionOrbit::Pair FunctionOrbit::pair(const Quad& h) {
  const Quad c = HypercomplexSquare::coordinates(h);
  return {{c[0], c[1]}, {c[2], c[3]}};
}

FunctionOrbit::Pair FunctionOrbit::next(const Pair& h) const {
  return {julia_value(function_, exponent_, h.a) + parameter_.a,
          julia_value(function_, exponent_, h.b) + parameter_.b};
}

FunctionOrbit::Pair FunctionOrbit::next_slope(const Pair& h, const Pair& slope) const {
  return {julia_derivative(function_, exponent_, h.a) * slope.a,
          julia_derivative(function_, exponent_, h.b) * slope.b};
}

bool FunctionOrbit::inside(const Quad& start) const {
  Pair h = pair(start);
  for (std::uint32_t k = 0;; ++k) {
    if (!(squared(h) <= limit_)) return false;
    if (k == steps_) return true;
    h = next(h);
  }
}

JuliaVerdict FunctionOrbit::classify(const Quad& middle, const Quad& direction, double half) const {
  constexpr double kRounding = 0x1p-46;
  const Pair start = pair(middle), along = pair(direction);
  ComplexDisc a{start.a, half * std::abs(along.a)}, b{start.b, half * std::abs(along.b)};
  bool inside = true;
  for (std::uint32_t k = 0;; ++k) {
    const double size_a = std::abs(a.center), size_b = std::abs(b.center);
    a.radius += kRounding * size_a;
    b.radius += kRounding * size_b;
    if (!(a.radius + b.radius < 1e100)) return JuliaVerdict::kUnknown;
    const double low_a = std::max(size_a - a.radius, 0.0), high_a = size_a + a.radius;
    const double low_b = std::max(size_b - b.radius, 0.0), high_b = size_b + b.radius;
    if (0.5 * (low_a * low_a + low_b * low_b) > limit_) return JuliaVerdict::kOutside;
    inside = inside && 0.5 * (high_a * high_a + high_b * high_b) < limit_;
    if (k == steps_) return inside ? JuliaVerdict::kInside : JuliaVerdict::kUnknown;
    a = julia_disc(function_, exponent_, a);
    b = julia_disc(function_, exponent_, b);
    a.center += parameter_.a;
    b.center += parameter_.b;
  }
}

void FunctionOrbit::evaluate(const Quad& start, const Quad& direction, double& value, double& slope,
                             std::uint32_t more) const {
  constexpr double kNear = 1 - 1e-6;
  Pair h = pair(start), d = pair(direction);
  for (std::uint32_t k = 0; k < steps_ + more; ++k) {
    if (more == 0 && squared(h) >= kNear * limit_) break;
    const Pair after = next(h), slopes = next_slope(h, d);
    if (!(squared(after) + squared(slopes) < 1e200)) break;
    h = after, d = slopes;
  }
  value = squared(h) - limit_;
  slope = std::real(std::conj(h.a) * d.a + std::conj(h.b) * d.b);
}

double FunctionOrbit::noise(const Quad& start, double radius) const {
  constexpr double kEpsilon = 0x1p-48;
  Pair h = pair(start);
  double grown = 4 * radius;
  for (std::uint32_t k = 0; k < steps_; ++k) {
    const Pair growth = next_slope(h, {1, 1});
    const Pair after = next(h);
    if (!(squared(after) < 4 * limit_)) break;
    grown *= std::max(std::abs(growth.a), std::abs(growth.b));
    grown += kEpsilon * std::sqrt(squared(after) + limit_);
    h = after;
  }
  return 4 * grown * std::sqrt(limit_) + kEpsilon * limit_;
}

}  // namespace dioptre
