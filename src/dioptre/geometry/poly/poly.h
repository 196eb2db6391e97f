// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The points where a polynomial in x, y, z of the given order is <= 0.
/// Coefficients come in decreasing order of powers of x, then y, then z (x^n, x^(n-1) y, ...,
/// x^(n-1) z, ..., 1): (order+1)(order+2)(order+3)/6 of them.
struct Poly {
  static constexpr const char* kName = "poly";
  std::uint32_t order = 2;  ///< 2 to 35
  std::vector<double> coefficients;
  bool sturm = false;  ///< asks for the slower, surer root finder

  bool operator==(const Poly&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("order", self.order);
    visit("coefficients", self.coefficients);
    visit("sturm", self.sturm);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Poly& poly);

}  // namespace dioptre
