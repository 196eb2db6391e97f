// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "dioptre/core/ray.h"

namespace dioptre {

/// A polynomial in x, y and z of total degree N along a ray, as a polynomial in t: Horner's scheme
/// over polynomials, with all loops unrolled. The coefficients come as Poly has them, from the
/// highest powers of x, then of y, then of z down.
template <std::size_t N>
class AlongRay {
 public:
  /// The coefficients of 1, t, ... t^N.
  static std::array<double, N + 1> restrict(const double* c, const Ray& ray) {
    return sum_over_x<N>(c, ray.origin, ray.direction);
  }

 private:
  template <std::size_t M>
  using Univariate = std::array<double, M + 1>;

  /// p * (a + b t) + rest.
  template <std::size_t M>
  static Univariate<M> step(const Univariate<M - 1>& p, double a, double b,
                            const Univariate<M>& rest) {
    Univariate<M> q;
    q[0] = p[0] * a + rest[0];
    for (std::size_t k = 1; k < M; ++k) q[k] = p[k] * a + (p[k - 1] * b + rest[k]);
    q[M] = p[M - 1] * b + rest[M];
    return q;
  }

  template <std::size_t M>
  static Univariate<M> sum_over_x(const double* c, Vec3 o, Vec3 d) {
    const Univariate<M> rest = sum_over_y<M>(c + M * (M + 1) * (M + 2) / 6, o, d);
    if constexpr (M == 0) {
      return rest;
    } else {
      return step<M>(sum_over_x<M - 1>(c, o, d), o.x, d.x, rest);
    }
  }

  template <std::size_t M>
  static Univariate<M> sum_over_y(const double* c, Vec3 o, Vec3 d) {
    const Univariate<M> rest = sum_over_z<M>(c + M * (M + 1) / 2, o, d);
    if constexpr (M == 0) {
      return rest;
    } else {
      return step<M>(sum_over_y<M - 1>(c, o, d), o.y, d.y, rest);
    }
  }

  template <std::size_t M>
  static Univariate<M> sum_over_z(const double* c, Vec3 o, Vec3 d) {
    Univariate<M> rest{};
    rest[0] = c[M];
    if constexpr (M == 0) {
      return rest;
    } else {
      return step<M>(sum_over_z<M - 1>(c, o, d), o.z, d.z, rest);
    }
  }
};

}  // namespace dioptre
