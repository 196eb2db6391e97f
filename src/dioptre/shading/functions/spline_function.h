// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/scene/function.h"

namespace dioptre {

/// One component of a spline made ready. Immutable.
class SplineEvaluator {
 public:
  explicit SplineEvaluator(const SplineFunction& spline);

  /// The value at a place: linear, quadratic and natural splines keep their end values outside the
  /// knots; a cubic one (Catmull-Rom) is known from its second knot to the last but one, and keeps
  /// the values there. 0 without knots.
  double at(double t) const;

 private:
  enum class Kind { kLinear, kQuadratic, kCubic, kNatural };
  struct Knot {
    double at, value;
    double curvature = 0;  ///< the second derivative, of natural splines
  };
  void find_curvatures();
  double slope(std::size_t i) const;
  double linear(std::size_t i, double t) const;
  double quadratic(std::size_t i, double t) const;
  double cubic(double t) const;
  double natural(std::size_t i, double t) const;

  Kind kind_;
  std::vector<Knot> knots_;  ///< by rising place
};

}  // namespace dioptre
