// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace dioptre::pov {

/// A curve through values at places, as the `spline` of a scene file.
struct Spline {
  enum class Kind : std::uint8_t { kLinear, kQuadratic, kCubic, kNatural };
  struct Knot {
    double at = 0;
    std::array<double, 5> value{};
  };
  Kind kind = Kind::kLinear;
  std::uint8_t size = 2;    ///< components
  std::vector<Knot> knots;  ///< at rising places

  std::vector<std::array<double, 5>> curvatures;  ///< of the natural spline at each knot

  /// Puts a knot in its place; one at the same place is replaced.
  void insert(const Knot& knot);
  /// Call when all knots are there: solves for the curvatures.
  void finish();
};

/// The value of a spline, taken as of the given kind, at a place. Outside its range it has the
/// value of the end. No knots: zeros.
std::array<double, 5> evaluate(const Spline& spline, Spline::Kind kind, double at);

}  // namespace dioptre::pov
