// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "dioptre/core/ray.h"
#include "dioptre/integrators/atmosphere.h"
#include "dioptre/scene/scene.h"
#include "dioptre/shading/maps/position_map.h"

namespace dioptre {

/// The rainbows of a scene made ready. Immutable.
class Rainbows {
 public:
  explicit Rainbows(const Scene& scene);

  bool empty() const { return bows_.empty(); }

  /// The effect of all rainbows on a ray from its origin over `distance` (infinite towards the
  /// sky). Where several stand in one direction, it is the mean of the effects of each (measured).
  FogEffect effect(const Ray& ray, double distance) const;

 private:
  struct Bow {
    Rainbow rainbow;
    PositionMap map;
    Vec3 forward, up, side;  ///< unit, at right angles
  };

  std::vector<Bow> bows_;
};

}  // namespace dioptre
