// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/geometry/shape.h"

namespace dioptre::csg {

/// How a node joins its children.
enum class Operation : std::uint8_t {
  kUnion,         ///< inside any; all surfaces of the children stay, inner ones too
  kMerge,         ///< inside any; surfaces inside another child vanish
  kIntersection,  ///< inside all
  kClip,          ///< the first child, where it is inside all the others; they add no surface
};

/// One primitive of a tree. `id` is the caller's name for it and comes back as Crossing::leaf.
struct Leaf {
  const Shape* shape = nullptr;
  Placement placement;
  bool complement = false;  ///< inside and outside exchanged
};

/// A tree of operators over leaves, children given as indices: an entry >= 0 is a node, a negative
/// entry e is the leaf ~e. A difference is an intersection with complemented children; the
/// complement of an inner node is pushed to the leaves by `complement` before building.
struct Node {
  Operation operation = Operation::kUnion;
  std::vector<std::int32_t> children;
};

struct Description {
  std::vector<Leaf> leaves;
  std::vector<Node> nodes;
  std::int32_t root = 0;
};

/// A compiled CSG object, itself a Shape in world space; Crossing::leaf is the index of the
/// primitive in Description::leaves whose surface it is.
///
/// Along a ray every leaf contributes events; an operator lets an event pass to its parent where
/// its truth changes (Goldstein and Nagel 1971; Roth 1982), except that a union lets the events of
/// its children through. Events whose error intervals overlap are one event: so A - A is empty and
/// shared faces vanish. A sheet's event passes where its siblings allow it and changes no truth.
/// Subtrees are skipped where the ray misses their bounds or can no longer change the answer.
/// `surface` takes normals to world space and flips them for complemented leaves.
ShapePtr build(Description description);

}  // namespace dioptre::csg
