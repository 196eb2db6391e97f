// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "dioptre/scene/pattern.h"
#include "dioptre/shading/patterns/field.h"
#include "dioptre/shading/patterns/warp.h"

namespace dioptre {

/// The noise that a pattern is made of: its own choice, or the scene's.
NoiseGenerator noise_generator_of(const Pattern& pattern, const Settings& settings);

/// A pattern of the scene made ready: warps, field, waves. Immutable.
class PatternEvaluator {
 public:
  PatternEvaluator(const Pattern& pattern, const PatternServices& services);

  /// The value in [0, 1] at a point outside the warps; for a block pattern the block's number.
  double value(Vec3 p, const Viewpoint& viewpoint) const {
    return value_inside(warps_.apply(p), viewpoint);
  }

  /// The same for a point that has gone through the warps already.
  double value_inside(Vec3 p, const Viewpoint& viewpoint) const;

  const WarpList& warps() const { return warps_; }
  bool block() const { return block_; }

 private:
  WarpList warps_;
  std::unique_ptr<const Field> field_;
  bool block_;
  Wave wave_;
  double exponent_, frequency_, phase_;
};

}  // namespace dioptre
