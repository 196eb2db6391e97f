// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
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

/// An operator tree as data. Every leaf and node hangs in one place only; what is referred to a
/// second time, or does not exist, is left out.
struct Description {
  std::vector<Leaf> leaves;
  std::vector<Node> nodes;
  std::int32_t root = 0;
};

/// Turns the subtree at `entry` into its complement, in place, by De Morgan's laws. The complement
/// of a clip is a merge: its clips' surfaces then show.
void complement(Description& description, std::int32_t entry);

/// A compiled CSG object, itself a Shape in world space; Crossing::leaf is the index of the
/// primitive in Description::leaves whose surface it is. The shapes must outlive it.
///
/// Along a ray every leaf contributes events; an operator lets an event pass to its parent where
/// its truth changes (Goldstein and Nagel 1971; Roth 1982), except that a union lets the events of
/// its children through. Events of different leaves whose error intervals overlap are one event: so
/// A - A is empty and shared faces vanish; of those that pass an operator together, the one of the
/// lowest leaf stays. An event that cannot be told from the start of the ray lies before it. A
/// sheet's event, or an inner surface of a union, passes where its siblings allow it and changes no
/// truth. A clip's own surface bounds the solid but is not drawn: its crossings are not `visible`.
///
/// `crossings` reports all events that pass, inner surfaces of unions and sheets too: only without
/// those do they alternate between entering and leaving. Subtrees are skipped where the ray misses
/// their bounds or can no longer change the answer. `surface` takes normals to world space and
/// flips them for complemented leaves.
/// Many leaves stand in the named structure.
ShapePtr build(Description description, std::string_view accelerator = "bvh");

}  // namespace dioptre::csg
