// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The superquadric ellipsoid (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) <= 1 (A. Barr,
/// "Superquadrics and angle-preserving transformations", 1981). It fills the box from -1 to 1 the
/// more, the smaller the exponents are; above 2 it is pinched towards the axes.
struct Superellipsoid {
  static constexpr const char* kName = "superellipsoid";
  double east_west = 1;    ///< e, positive
  double north_south = 1;  ///< n, positive

  bool operator==(const Superellipsoid&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("east_west", self.east_west);
    visit("north_south", self.north_south);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for an exponent
/// that is not a positive number.
Result<ShapePtr> prepare(const Superellipsoid& superellipsoid);

}  // namespace dioptre
