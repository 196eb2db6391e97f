// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "dioptre/accel/part_structure.h"
#include "dioptre/csg/convex_core.h"
#include "dioptre/csg/placed_leaf.h"
#include "dioptre/csg/tree.h"

namespace dioptre::csg {

/// The parent of the root.
inline constexpr std::int32_t kNone = -1;

/// An operator as a counter: it is true when at least `threshold` of its children are.
struct CompiledNode {
  Operation operation = Operation::kUnion;
  bool clips = false;           ///< a child of a clip, not the first
  std::int32_t parent = kNone;  ///< always an earlier node
  std::uint32_t children = 0;
  std::uint32_t threshold = 1;
  std::uint32_t count = 0;  ///< of the true children, far from everything
};

/// What an evaluation needs of a leaf beside its shape.
struct CompiledLeaf {
  std::int32_t parent = kNone;
  bool used = false;
  bool clips = false;    ///< a child of a clip, not the first
  bool drawn = true;     ///< not in a clip's clipping part
  bool outside = false;  ///< its truth where it is not asked
  bool sheet = false;
  /// The part of its bounds where it can change the answer (Cameron 1991, "Efficient bounds in
  /// constructive solid geometry"); a ray or point that misses it need not ask the leaf.
  SlabBox interest;
};

/// A tree made ready for evaluation: associative operators flattened, bounds carried through it.
struct Compiled {
  std::vector<PlacedLeaf> placed;       ///< by index in the description
  std::vector<CompiledLeaf> leaves;     ///< the same
  std::vector<CompiledNode> nodes;      ///< the root first
  std::vector<std::uint32_t> required;  ///< without which nothing is inside; the cheap ones first
  ConvexCore core;                      ///< of `required`: half-spaces, and if `convex` all
  std::vector<std::uint32_t> beside;    ///< the others of `required`, in the same order
  bool convex = false;                  ///< there is nothing but the core
  bool carved = false;                  ///< nothing but the core, bites, and the general leaf
  std::int32_t general = kNone;         ///< of a carved tree: a leaf that is neither, if it has one
  std::vector<std::uint32_t> optional;  ///< the other leaves that can change the answer
  PartStructure structure;              ///< over `optional`, if they are many
  std::int32_t only_leaf = kNone;       ///< set if the tree is just this leaf
  bool solid = false;
  Bounds bounds;   ///< of what is inside or visible
  SlabBox extent;  ///< the same
};

/// More optional leaves than these get a structure.
inline constexpr std::size_t kManyLeaves = 16;

/// Compiles with the named structure over more than `many` optional leaves.
Compiled compile(const Description& description, std::size_t many = kManyLeaves,
                 std::string_view accelerator = "bvh");

}  // namespace dioptre::csg
