// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "dioptre/csg/tree.h"
#include "dioptre/geometry/convex.h"

namespace dioptre::csg {

/// The points p of world space with dot(p, normal) <= distance.
struct PlacedHalfSpace {
  Vec3 normal;  ///< of any length
  double distance;
  Vec3 normal_terms;  ///< the sums of the sizes of the terms that `normal` was summed from
  double distance_terms;
};

/// A leaf in world space: takes rays into the space of its shape, which keeps their t, and results
/// back, with inside and outside exchanged for a complement.
class PlacedLeaf {
 public:
  explicit PlacedLeaf(const Leaf& leaf);

  /// A box around the surface, in world space.
  const Bounds& bounds() const { return bounds_; }
  /// Whether what lies outside `bounds` is inside the leaf.
  bool outside() const { return outside_; }
  bool solid() const { return leaf_.shape->solid(); }
  bool complement() const { return leaf_.complement; }
  /// Whether every ray meets the leaf in one stretch at most.
  bool convex() const { return convex_ != nullptr && !leaf_.complement; }
  /// Whether every ray leaves the leaf for one stretch at most: the complement of what is convex.
  bool bite() const { return convex_ != nullptr && leaf_.complement; }
  /// The leaf as a half-space, if it is one.
  const std::optional<PlacedHalfSpace>& half_space() const { return half_space_; }
  double cost() const { return leaf_.shape->cost(); }
  /// A box around the part of the inside that lies in a region of world space; for a leaf that is
  /// true outside its bounds, around the part of its surface.
  Bounds bounds_within(const Bounds& region) const;

  /// Appends the crossings in the range, marked with `id`, and returns whether the ray is inside
  /// just after range.min. Their errors take in the rounding of the ray and of the leaf's place.
  bool crossings(const Ray& ray, Interval range, std::uint32_t id, Crossings& out) const;
  /// The first visible crossing; its error is that of the shape alone, without the rounding of the
  /// ray and of the leaf's place.
  bool nearest(const Ray& ray, Interval range, Crossing& out) const;
  /// The stretch of a ray in a convex leaf, or in the hole that a bite is, as two crossings marked
  /// with `id`; false for a miss.
  bool stretch(const Ray& ray, std::uint32_t id, std::array<Crossing, 2>& ends) const;
  bool contains(Vec3 p) const;
  Surface surface(const Ray& ray, const Crossing& crossing) const;
  Vec2 uv(const Ray& ray, const Crossing& crossing) const;
  void texture_shares(const Ray& ray, const Crossing& crossing,
                      std::vector<TextureShare>& out) const;

 private:
  Crossing own(const Crossing& crossing) const;
  Ray to_object(const Ray& ray) const { return moved_ ? leaf_.placement.to_object.ray(ray) : ray; }
  void to_world(const Ray& ray, Crossing& crossing) const;

  Leaf leaf_;
  const ConvexSolid* convex_;  ///< the shape, if that is convex
  std::optional<PlacedHalfSpace> half_space_;
  bool moved_;
  Bounds bounds_;
  bool outside_;
};

/// The relative rounding of a coordinate in a ray and in a placement, generously.
inline constexpr double kPlacementError = 8 * 2.220446049250313e-16;

/// How far t can be off by the rounding of coordinates alone at t along a ray.
double rounding_of(const Ray& ray, double t);

}  // namespace dioptre::csg
