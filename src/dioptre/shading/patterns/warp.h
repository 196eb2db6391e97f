// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/scene/pattern.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre {

/// A list of warps made ready: neighbouring transforms are one inverse matrix.
class WarpList {
 public:
  /// `skip_first` leaves out the first warp (a turbulence that the pattern uses itself). Singular
  /// transforms count as none.
  WarpList(const std::vector<Warp>& warps, bool skip_first);

  bool empty() const { return steps_.empty(); }

  /// A point of the outside to the pattern's own space: the last warp first.
  Vec3 apply(Vec3 p) const;

  /// The product of the transforms alone, pattern space to outside.
  const Affine& transform() const { return transform_; }

 private:
  using Step = std::variant<Affine, Turbulence, RepeatWarp, BlackHoleWarp, MappingWarp>;
  std::vector<Step> steps_;  ///< in the order of application
  Affine transform_;
};

}  // namespace dioptre
