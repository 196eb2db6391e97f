// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/julia_fractal/complex_disc.h"

#include <cmath>

#include "dioptre/core/interval.h"

namespace dioptre {
namespace {

using Complex = std::complex<double>;
constexpr Complex kI{0, 1};

// Numbers and discs have the same few functions, of which the others are made.

bool meets_cut(const ComplexDisc& z) {
  const double size = std::abs(z.center);
  return !(size > z.radius) || (z.center.real() < 0 && std::fabs(z.center.imag()) <= z.radius);
}

Complex exponential(Complex z) { return std::exp(z); }
ComplexDisc exponential(const ComplexDisc& z) {
  const Complex c = std::exp(z.center);
  return {c, std::abs(c) * std::expm1(z.radius)};
}

Complex logarithm(Complex z) { return std::log(z); }
ComplexDisc logarithm(const ComplexDisc& z) {
  if (meets_cut(z)) return {std::log(z.center), kInfinity};
  return {std::log(z.center), -std::log1p(-z.radius / std::abs(z.center))};
}

Complex root(Complex z) { return std::sqrt(z); }
ComplexDisc root(const ComplexDisc& z) {
  const Complex c = std::sqrt(z.center);
  if (meets_cut(z)) return {c, kInfinity};
  return {c, std::abs(c) * (1 - std::sqrt(1 - z.radius / std::abs(z.center)))};
}

Complex sine(Complex z) { return std::sin(z); }
ComplexDisc sine(const ComplexDisc& z) {
  const Complex s = std::sin(z.center), c = std::cos(z.center);
  return {s, std::abs(s) * (std::cosh(z.radius) - 1) + std::abs(c) * std::sinh(z.radius)};
}

Complex cosine(Complex z) { return std::cos(z); }
ComplexDisc cosine(const ComplexDisc& z) {
  const Complex s = std::sin(z.center), c = std::cos(z.center);
  return {c, std::abs(c) * (std::cosh(z.radius) - 1) + std::abs(s) * std::sinh(z.radius)};
}

Complex inverse(Complex z) { return 1.0 / z; }
ComplexDisc inverse(const ComplexDisc& z) {
  const double size = std::abs(z.center), rest = size - z.radius;
  return {1.0 / z.center, rest > 0 ? z.radius / (size * rest) : kInfinity};
}

Complex product(Complex a, Complex b) { return a * b; }
ComplexDisc product(const ComplexDisc& a, const ComplexDisc& b) {
  const double spread = std::abs(a.center) * b.radius + std::abs(b.center) * a.radius;
  return {a.center * b.center, spread + a.radius * b.radius};
}

ComplexDisc operator*(Complex f, const ComplexDisc& z) {
  return {f * z.center, std::abs(f) * z.radius};
}
ComplexDisc operator+(Complex a, const ComplexDisc& z) { return {a + z.center, z.radius}; }
ComplexDisc operator+(const ComplexDisc& a, const ComplexDisc& b) {
  return {a.center + b.center, a.radius + b.radius};
}

template <class Number>
Number tangent(const Number& z) {
  return product(sine(z), inverse(cosine(z)));
}
template <class Number>
Number arc_sine(const Number& z) {
  const Complex one = 1;
  return -kI * logarithm(kI * z + product(root(one + -one * z), root(one + z)));
}
/// log(z + sqrt(z^2 - 1)), whose branches are not those of the textbooks (measured).
template <class Number>
Number area_cosine(const Number& z) {
  return logarithm(z + root(Complex(-1) + product(z, z)));
}
template <class Number>
Number area_tangent(const Number& z) {
  const Complex one = 1;
  return Complex(0.5) * (logarithm(one + z) + -one * logarithm(one + -one * z));
}

template <class Number>
Number evaluate(JuliaFunction f, Complex exponent, const Number& z) {
  switch (f) {
    case JuliaFunction::kSqr:
      return product(z, z);
    case JuliaFunction::kCube:
      return product(z, product(z, z));
    case JuliaFunction::kExp:
      return exponential(z);
    case JuliaFunction::kReciprocal:
      return inverse(z);
    case JuliaFunction::kSin:
      return sine(z);
    case JuliaFunction::kAsin:
      return arc_sine(z);
    case JuliaFunction::kSinh:
      return -kI * sine(kI * z);
    case JuliaFunction::kAsinh:
      return -kI * arc_sine(kI * z);
    case JuliaFunction::kCos:
      return cosine(z);
    case JuliaFunction::kAcos:
      return -kI * area_cosine(z);
    case JuliaFunction::kCosh:
      return cosine(kI * z);
    case JuliaFunction::kAcosh:
      return area_cosine(z);
    case JuliaFunction::kTan:
      return tangent(z);
    case JuliaFunction::kAtan:
      return -kI * area_tangent(kI * z);
    case JuliaFunction::kTanh:
      return -kI * tangent(kI * z);
    case JuliaFunction::kAtanh:
      return area_tangent(z);
    case JuliaFunction::kLn:
      return logarithm(z);
    case JuliaFunction::kPwr:
      return exponential(exponent * logarithm(z));
  }
  return z;
}

}  // namespace

Complex julia_value(JuliaFunction f, Complex exponent, Complex z) {
  return evaluate(f, exponent, z);
}

ComplexDisc julia_disc(JuliaFunction f, Complex exponent, const ComplexDisc& z) {
  return evaluate(f, exponent, z);
}

Complex julia_derivative(JuliaFunction f, Complex exponent, Complex z) {
  const Complex one = 1;
  switch (f) {
    case JuliaFunction::kSqr:
      return 2.0 * z;
    case JuliaFunction::kCube:
      return 3.0 * z * z;
    case JuliaFunction::kExp:
      return std::exp(z);
    case JuliaFunction::kReciprocal:
      return -one / (z * z);
    case JuliaFunction::kSin:
      return std::cos(z);
    case JuliaFunction::kAsin:
      return one / (std::sqrt(one - z) * std::sqrt(one + z));
    case JuliaFunction::kSinh:
      return std::cosh(z);
    case JuliaFunction::kAsinh:
      return one / (std::sqrt(one - kI * z) * std::sqrt(one + kI * z));
    case JuliaFunction::kCos:
      return -std::sin(z);
    case JuliaFunction::kAcos:
      return -kI / std::sqrt(z * z - one);
    case JuliaFunction::kCosh:
      return std::sinh(z);
    case JuliaFunction::kAcosh:
      return one / std::sqrt(z * z - one);
    case JuliaFunction::kTan:
      return one / (std::cos(z) * std::cos(z));
    case JuliaFunction::kAtan:
      return one / (one + z * z);
    case JuliaFunction::kTanh:
      return one / (std::cosh(z) * std::cosh(z));
    case JuliaFunction::kAtanh:
      return one / (one - z * z);
    case JuliaFunction::kLn:
      return one / z;
    case JuliaFunction::kPwr:
      return exponent * std::exp((exponent - one) * std::log(z));
  }
  return one;
}

}  // namespace dioptre
