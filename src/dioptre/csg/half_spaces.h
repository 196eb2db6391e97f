// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"
#include "dioptre/geometry/shape.h"

namespace dioptre::csg {

/// The half-spaces among the leaves that a tree needs: a polyhedron, tested as one. A ray that
/// misses it is refused without asking a leaf, and of the others only those faces are asked that
/// the ray may cross.
class HalfSpaces {
 public:
  /// Adds a leaf; `half` is in world space.
  void add(const HalfSpace& half, std::uint32_t leaf);

  std::size_t size() const { return leaves_.size(); }
  std::uint32_t leaf(std::size_t i) const { return leaves_[i]; }

  /// Cuts `range` to a stretch that holds all of the polyhedron, a little more than it (by `margin`
  /// and as much relative to t); false if nothing is left. times[i] becomes where face i is
  /// crossed; not a number where that is not certain.
  bool clip(const Ray& ray, double margin, Interval& range, std::vector<double>& times) const;

 private:
  std::vector<double> x_, y_, z_, distance_;
  std::vector<std::uint32_t> leaves_;
};

}  // namespace dioptre::csg
