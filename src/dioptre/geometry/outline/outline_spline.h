// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace dioptre {

/// How control points make a curve in the plane (as in a scene file).
enum class OutlineSpline : std::uint8_t {
  kLinear,     ///< p1 ... pn: straight lines
  kQuadratic,  ///< c p1 ... pn: parabolas through p1 ... pn; c only bends the first
  kCubic,      ///< c p1 ... pn d: Catmull-Rom through p1 ... pn; c, d only bend the ends
  kBezier,     ///< groups of 4: begin, two controls, end
};

/// The least number of control points of a curve, or of one that closes around an area.
constexpr std::size_t least_points(OutlineSpline spline, bool closed) {
  switch (spline) {
    case OutlineSpline::kQuadratic:
      return closed ? 4 : 3;
    case OutlineSpline::kCubic:
      return closed ? 5 : 4;
    case OutlineSpline::kBezier:
      return 4;
    case OutlineSpline::kLinear:
      break;
  }
  return closed ? 3 : 2;
}

}  // namespace dioptre
