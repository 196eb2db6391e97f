// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The points with a x^2 + b y^2 + c z^2 + d xy + e xz + f yz + g x + h y + i z + j <= 0.
struct Quadric {
  static constexpr const char* kName = "quadric";
  Vec3 squares{1, 1, 1};  ///< a, b, c
  Vec3 products;          ///< d, e, f
  Vec3 linear;            ///< g, h, i
  double constant = -1;   ///< j

  bool operator==(const Quadric&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("squares", self.squares);
    visit("products", self.products);
    visit("linear", self.linear);
    visit("constant", self.constant);
  }
};

/// Checks the parameters and does all work that does not depend on a ray.
Result<ShapePtr> prepare(const Quadric& quadric);

}  // namespace dioptre
