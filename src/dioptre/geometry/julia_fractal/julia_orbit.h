// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace dioptre {

/// Four numbers, as h in julia_fractal.h or in coordinates that suit an algebra.
using Quad = std::array<double, 4>;

inline Quad operator+(const Quad& a, const Quad& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}
inline double dot(const Quad& a, const Quad& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// What is known of a stretch of a line.
enum class JuliaVerdict {
  kOutside,
  kInside,
  kUnknown,
};

/// h * h and h * h * h for quaternions.
template <bool kCube>
struct QuaternionPower {
  static Quad coordinates(const Quad& h) { return h; }
  static double dot(const Quad& a, const Quad& b) { return dioptre::dot(a, b); }
  static double size(const Quad& h) { return std::sqrt(dot(h, h)); }

  static Quad power(const Quad& h) {
    const double n = dot(h, h), twice = 2 * h[0];
    if constexpr (!kCube) return {twice * h[0] - n, twice * h[1], twice * h[2], twice * h[3]};
    const double f = twice * twice - n;
    return {f * h[0] - twice * n, f * h[1], f * h[2], f * h[3]};
  }
  static Quad slope(const Quad& h, const Quad& d) {
    const double n = dot(h, h), dn = 2 * dot(h, d);
    const double twice = 2 * h[0], dtwice = 2 * d[0];
    Quad out;
    if constexpr (!kCube) {
      for (std::size_t i = 0; i < 4; ++i) out[i] = twice * d[i] + dtwice * h[i];
      out[0] -= dn;
    } else {
      const double f = twice * twice - n, df = 2 * twice * dtwice - dn;
      for (std::size_t i = 0; i < 4; ++i) out[i] = f * d[i] + df * h[i];
      out[0] -= dtwice * n + twice * dn;
    }
    return out;
  }
  /// The size of the derivative.
  static double growth(double squared) { return kCube ? 3 * squared : 2 * std::sqrt(squared); }
  /// Of a ball that holds the images of one of radius r; |a b| = |a| |b|.
  static double radius(double size, double r) {
    if constexpr (!kCube) return r * (2 * size + r);
    return r * (3 * size * (size + r) + r * r);
  }
};

/// h * h for hypercomplex numbers, which are pairs of complex numbers a = x - w + (y + z) i and
/// b = x + w + (y - z) i that are squared each on its own. Balls are those of the larger one.
struct HypercomplexSquare {
  static Quad coordinates(const Quad& h) {
    return {h[0] - h[3], h[1] + h[2], h[0] + h[3], h[1] - h[2]};
  }
  static double dot(const Quad& a, const Quad& b) { return 0.5 * dioptre::dot(a, b); }
  static double size(const Quad& h) {
    return std::sqrt(std::max(h[0] * h[0] + h[1] * h[1], h[2] * h[2] + h[3] * h[3]));
  }
  static Quad power(const Quad& h) {
    return {h[0] * h[0] - h[1] * h[1], 2 * h[0] * h[1], h[2] * h[2] - h[3] * h[3], 2 * h[2] * h[3]};
  }
  static Quad slope(const Quad& h, const Quad& d) {
    return {2 * (h[0] * d[0] - h[1] * d[1]), 2 * (h[0] * d[1] + h[1] * d[0]),
            2 * (h[2] * d[2] - h[3] * d[3]), 2 * (h[2] * d[3] + h[3] * d[2])};
  }
  static double radius(double size, double r) { return r * (2 * size + r); }
};

/// The iteration of a power. What has left the ball never comes back to it, so that the last
/// iterate alone tells.
template <class Power>
class PowerOrbit {
 public:
  PowerOrbit(const Quad& parameter, double bound, std::uint32_t steps)
      : parameter_(Power::coordinates(parameter)), limit_(bound * bound), steps_(steps) {}

  bool inside(const Quad& start) const {
    Quad h = Power::coordinates(start);
    for (std::uint32_t k = 0;; ++k) {
      if (!(Power::dot(h, h) <= limit_)) return false;
      if (k == steps_) return true;
      h = Power::power(h) + parameter_;
    }
  }

  /// About how far the solid is from a point outside it; nothing inside. Half of |h| log |h| / |h'|
  /// for the first h that has left the ball (Hart, Sandin and Kauffman 1989, equation 8).
  std::optional<double> distance(const Quad& start) const {
    Quad h = Power::coordinates(start);
    double growth = 1;
    for (std::uint32_t k = 0;; ++k) {
      const double squared = Power::dot(h, h);
      if (!(squared <= limit_)) return 0.25 * std::sqrt(squared) * std::log(squared) / growth;
      if (k == steps_) return std::nullopt;
      growth *= Power::growth(squared);
      h = Power::power(h) + parameter_;
    }
  }

  /// Where the points middle + t direction, |t| <= half, are: their images lie in balls.
  JuliaVerdict classify(const Quad& middle, const Quad& direction, double half) const {
    constexpr double kRounding = 1 + 0x1p-40;
    Quad h = Power::coordinates(middle);
    double radius = half * Power::size(Power::coordinates(direction));
    const double bound = std::sqrt(limit_);
    for (std::uint32_t k = 0;; ++k) {
      const double norm = std::sqrt(Power::dot(h, h));
      if (norm - radius > bound) return JuliaVerdict::kOutside;
      if (!(radius < 1e100)) return JuliaVerdict::kUnknown;
      if (k == steps_) {
        return norm + radius < bound ? JuliaVerdict::kInside : JuliaVerdict::kUnknown;
      }
      radius = Power::radius(Power::size(h), radius) * kRounding;
      h = Power::power(h) + parameter_;
    }
  }

  /// |h|^2 less its limit after `steps` more steps than tell inside from outside, and its slope
  /// along the direction.
  void evaluate(const Quad& start, const Quad& direction, double& value, double& slope,
                std::uint32_t more = 0) const {
    Quad h = Power::coordinates(start), d = Power::coordinates(direction);
    for (std::uint32_t k = 0; k < steps_ + more; ++k) {
      // Further on it is outside by far, and what counts is the direction of the slope.
      if (!(Power::dot(h, h) < 1e100)) break;
      d = Power::slope(h, d);
      h = Power::power(h) + parameter_;
    }
    value = Power::dot(h, h) - limit_;
    slope = 2 * Power::dot(h, d);
  }

  /// A bound on the error of evaluate's value where the start is known up to `radius`.
  double noise(const Quad& start, double radius) const {
    constexpr double kEpsilon = 0x1p-52;
    Quad h = Power::coordinates(start);
    double r = 2 * radius;
    for (std::uint32_t k = 0; k < steps_; ++k) {
      const double size = Power::size(h);
      r = Power::radius(size, r);
      h = Power::power(h) + parameter_;
      r += 8 * kEpsilon * (size * size * std::max(size, 1.0) + Power::size(parameter_));
    }
    const double size = Power::size(h);
    return r * (2 * size + r) + 4 * kEpsilon * (size * size + limit_);
  }

 private:
  Quad parameter_;
  double limit_;
  std::uint32_t steps_;
};

}  // namespace dioptre
