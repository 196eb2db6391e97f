// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/shading/patterns/field.h"

namespace dioptre {

/// Where a pigment or normal is looked up, in the space outside its warps.
struct Lookup {
  Vec3 position;
  Viewpoint viewpoint;
  Vec2 uv;

  Lookup at(Vec3 p) const { return {p, viewpoint, uv}; }
  /// In place of the point the surface's own coordinates.
  Lookup at_uv() const { return at({uv.x, uv.y, 0}); }
};

/// Counts how deep pigments, normals and functions of one thread stand in one another, so that a
/// chain of any length in a scene cannot exhaust the stack.
class Nesting {
 public:
  Nesting() { ++depth_; }
  ~Nesting() { --depth_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;
  bool too_deep() const { return depth_ > kDeepest; }

 private:
  static constexpr int kDeepest = 400;
  static inline thread_local int depth_ = 0;
};

}  // namespace dioptre
