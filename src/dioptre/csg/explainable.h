// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/csg/explain.h"

namespace dioptre::csg {

/// A shape that can tell what its primitives and operators do along a ray.
class Explainable : public Shape {
 public:
  virtual RayStretches explain(const Ray& ray, Interval range) const = 0;
};

/// The stretches between crossings that alternate, for a ray that is `inside` at the start.
std::vector<Interval> stretches_of(const Crossings& crossings, bool inside, Interval range);

/// Fills in the stretches of all operators from those of the primitives.
void join_children(RayStretches& tree);

/// What becomes of a crossing of the primitive at a place of the list.
EventFate fate_of(const RayStretches& tree, std::size_t node, const Crossing& crossing);

}  // namespace dioptre::csg
