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

Complex magnet_step(Complex z, Complex c, std::uint32_t type) {
  const Complex one{1, 0}, two{2, 0};
  if (type == 1) {
    const Complex q = quotient(product(z, z) + c - one, 2.0 * z + c - two);
    return product(q, q);
  }
  // z^3 + 3 (c-1) z + (c-1)(c-2)  over  3 z^2 + 3 (c-2) z + (c-1)(c-2) + 1
  const Complex c1 = c - one, c2 = c - two, z2 = product(z, z), cc = product(c1, c2);
  const Complex q = quotient(product(z2, z) + 3.0 * product(c1, z) + cc,
                             3.0 * z2 + 3.0 * product(c2, z) + cc + one);
  return product(q, q);
}

/// Where an iteration led to.
struct Orbit {
  Complex last;
  double smallest;  ///< squared distance from 0
  std::uint32_t steps = 0;
  bool ended = false;  ///< before the most steps allowed
};

/// Repeats z = step(z) until ends(z, |z|^2).
template <class Step, class Ends>
Orbit iterate(Complex z, std::uint32_t most, Step step, Ends ends) {
  Orbit orbit{z, z == Complex{} ? 1e300 : std::norm(z)};
  std::uint32_t marked_at = 0;
  Complex mark{NAN, NAN};
  for (std::uint32_t& i = orbit.steps; i < most; ++i) {
    z = step(z);
    const double size = std::norm(z);
    orbit.smallest = std::min(orbit.smallest, size);
    if (ends(z, size)) {
      orbit.ended = true;
      break;
    }
    if (z == mark) {
      // The orbit repeats itself (found as in R. Brent, "An improved Monte Carlo factorization
      // algorithm", BIT 20, 1980): whole rounds make no difference.
      i = most - 1 - (most - 1 - i) % (i - marked_at);
      mark = {NAN, NAN};
    } else if ((i & (i + 1)) == 0) {
      mark = z;
      marked_at = i;
    }
  }
  orbit.last = z;
  return orbit;
}

Orbit orbit_of(Complex z, Complex c, std::uint32_t most, const Fractal& fractal) {
  if (fractal.magnet) {
    // An orbit that comes to 1 stays there: that ends it like an escape.
    return iterate(
        z, most, [&](Complex w) { return magnet_step(w, c, fractal.magnet_type); },
        [](Complex w, double size) {
          return !(size <= 100 * 100) || std::norm(w - Complex{1, 0}) < 1e-4;
        });
  }
  const auto escapes = [](Complex, double size) { return !(size <= 4); };
  if (fractal.exponent <= 2) {
    return iterate(
        z, most, [c](Complex w) { return product(w, w) + c; }, escapes);
  }
  return iterate(
      z, most, [&](Complex w) { return power(w, fractal.exponent) + c; }, escapes);
}

/// Whether c lies well inside one of the two largest parts of the Mandelbrot set, whose orbits come
/// to rest or swing between two places and never escape.
bool in_main_cardioid_or_disc(Complex c) {
  constexpr double kInside = 1 - 1e-9;
  const double x = c.real() - 0.25, y2 = c.imag() * c.imag(), q = x * x + y2;
  return q * (q + x) < 0.25 * y2 * kInside || std::norm(c + 1.0) < 0.0625 * kInside;
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
  const bool square = !fractal.magnet && !fractal.julia && fractal.exponent <= 2;
  if (square && fractal.interior_type == 0 && in_main_cardioid_or_disc(c)) {
    return fractal.interior_factor;
  }
  const Orbit orbit =
      orbit_of(fractal.magnet && !fractal.julia ? Complex{} : point, c, most, fractal);
  const Complex z = orbit.last;
  const std::uint32_t i = orbit.steps;
  if (!orbit.ended) {
    const double factor = fractal.interior_factor;
    if (fractal.interior_type == 6) {  // not the modulus that the manual promises (measured)
      return z.real() * z.real() + z.imag() * z.imag() * factor;
    }
    return by_type(fractal.interior_type, factor, std::sqrt(orbit.smallest) * factor, z);
  }
  const double factor = fractal.exterior_factor;
  if (fractal.exterior_type == 7) return std::fmod(i, factor) / factor;
  if (fractal.exterior_type == 8) return std::fmod(i, factor + 1) / factor;
  return by_type(fractal.exterior_type, factor, static_cast<double>(i) / most, z);
}

}  // namespace dioptre
