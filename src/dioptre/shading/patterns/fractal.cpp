// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/fractal.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace dioptre {
namespace {

using Complex = std::complex<double>;

Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
Complex quotient(Complex a, Complex b) {
  const double size = std::norm(b);
  return size > 0 ? product(a, std::conj(b)) / size : Complex{1e15, 0};
}
Complex power(Complex z, std::uint32_t exponent) {
  Complex result = z;
  for (std::uint32_t i = 1; i < std::clamp(exponent, 2u, 33u); ++i) result = product(result, z);
  return result;
}

/// One step of the iteration.
Complex step(Complex z, Complex c, const Fractal& fractal) {
  if (!fractal.magnet) return power(z, fractal.exponent) + c;
  const Complex one{1, 0}, two{2, 0};
  if (fractal.magnet_type == 1) {
    const Complex q = quotient(product(z, z) + c - one, 2.0 * z + c - two);
    return product(q, q);
  }
  // z^3 + 3 (c-1) z + (c-1)(c-2)  over  3 z^2 + 3 (c-2) z + (c-1)(c-2) + 1
  const Complex c1 = c - one, c2 = c - two, z2 = product(z, z), cc = product(c1, c2);
  const Complex q = quotient(product(z2, z) + 3.0 * product(c1, z) + cc,
                             3.0 * z2 + 3.0 * product(c2, z) + cc + one);
  return product(q, q);
}

double by_type(std::uint32_t type, double factor, double first, Complex last) {
  switch (type) {
    case 0:
      return factor;
    case 1:
      return first;
    case 2:
      return last.real() * factor;
    case 3:
      return last.imag() * factor;
    case 4:
      return last.real() * last.real() * factor;
    case 5:
      return last.imag() * last.imag() * factor;
    default:
      return std::abs(last) * factor;
  }
}

}  // namespace

double fractal_value(Vec3 p, const Fractal& fractal) {
  constexpr std::uint32_t kMost = 1u << 20;
  const std::uint32_t most = std::clamp(fractal.iterations, 1u, kMost);
  const Complex point{p.x, p.y};
  const Complex c = fractal.julia ? Complex{fractal.constant.x, fractal.constant.y} : point;
  Complex z = fractal.magnet && !fractal.julia ? Complex{} : point;
  // A magnet orbit that comes to 1 stays there: that ends it like an escape.
  const double bailout = fractal.magnet ? 100 * 100 : 4;
  const auto ends = [&](Complex w, double size) {
    return !(size <= bailout) || (fractal.magnet && std::norm(w - Complex{1, 0}) < 1e-4);
  };
  double smallest = z == Complex{} ? 1e300 : std::norm(z);
  Complex before = z;
  std::uint32_t i = 0;
  bool escaped = false;
  for (; i < most; ++i) {
    before = z;
    z = step(z, c, fractal);
    const double size = std::norm(z);
    smallest = std::min(smallest, size);
    escaped = ends(z, size);
    if (escaped) break;
  }
  if (!escaped) {
    const double factor = fractal.interior_factor;
    if (fractal.interior_type == 6) {  // not the modulus that the manual promises (measured)
      return (2 * z.real() * z.real() + z.imag() * z.imag()) * factor;
    }
    return by_type(fractal.interior_type, factor, std::sqrt(smallest) * factor, z);
  }
  const double factor = fractal.exterior_factor;
  if (fractal.exterior_type == 7) return std::fmod(i, factor) / factor;
  if (fractal.exterior_type == 8) return std::fmod(i, factor + 1) / factor;
  return by_type(fractal.exterior_type, factor, static_cast<double>(i) / most, z);
}

}  // namespace dioptre
