// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "dioptre/core/scalar_field.h"
#include "dioptre/core/vec.h"

namespace dioptre {

/// A field along a stretch of a ray, as a function of s from 0 to 1, less a threshold.
class FieldLine {
 public:
  FieldLine(const ScalarField& field, double threshold, Vec3 origin, Vec3 step)
      : field_(field), threshold_(threshold), origin_(origin), step_(step) {}

  Vec3 at(double s) const { return origin_ + s * step_; }

  double value(double s) const {
    const Vec3 p = at(s);
    const double arguments[] = {p.x, p.y, p.z};
    return field_.value(arguments) - threshold_;
  }

  /// Bounds of the value and of the slope by s, for s from `low` to `high`.
  IntervalJet range(double low, double high) const {
    const IntervalJet arguments[] = {coordinate(origin_.x, step_.x, low, high),
                                     coordinate(origin_.y, step_.y, low, high),
                                     coordinate(origin_.z, step_.z, low, high)};
    IntervalJet jet = field_.range(arguments);
    jet.value = jet.value - interval_of(threshold_);
    return jet;
  }

 private:
  /// Rounding is monotone, so that the ends as computed hold what is computed between them.
  static IntervalJet coordinate(double origin, double step, double low, double high) {
    const double p = origin + low * step, q = origin + high * step;
    return {{std::min(p, q), std::max(p, q)}, {step, step}};
  }

  const ScalarField& field_;
  double threshold_;
  Vec3 origin_, step_;
};

}  // namespace dioptre
