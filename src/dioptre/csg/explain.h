// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/csg/tree.h"

namespace dioptre::csg {

/// A primitive or an operator of a tree along a ray, as Goldstein and Nagel (1971) see it: the
/// stretches in which the ray is inside. Operators of one kind within each other are one.
struct NodeStretches {
  std::int32_t parent = -1;  ///< always an earlier one of the list; -1: the root
  bool is_leaf = false;
  Operation operation = Operation::kUnion;  ///< of an operator
  std::uint32_t leaf = 0;                   ///< of a primitive, as Crossing::leaf
  bool complement = false;                  ///< of a primitive: inside and outside exchanged
  std::vector<Interval> inside;             ///< in order of t, cut to the range
};

/// What became of one end of a primitive's stretch on its way to the root.
struct EventFate {
  double t = 0;
  std::uint32_t leaf = 0;
  bool entering = false;  ///< into the primitive or, if it is complemented, out of it
  bool seen = false;      ///< is a surface of the whole
  /// If not seen: the operator that kept it back, and that operator's child that hid it (inside it
  /// for a merge, outside it for an intersection); places in the list of stretches.
  std::uint32_t stopped_at = 0, because_of = 0;
};

/// A tree along one ray.
struct RayStretches {
  std::vector<NodeStretches> nodes;  ///< the root first; empty for what is no tree
  std::vector<EventFate> events;     ///< in order of t
};

/// Walks every primitive of a shape that `build` made, whether it matters or not: slow and simple.
/// Surfaces that coincide are each told of on its own. Nothing for other shapes.
RayStretches explain(const Shape& shape, const Ray& ray, Interval range);

}  // namespace dioptre::csg
