// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/csg/placed_leaf.h"

namespace dioptre::csg {

/// Leaves are asked this much beyond a range, relative to the numbers that t came from, so that
/// faces that coincide at its end are seen together.
inline constexpr double kRangeMargin = 1e-9;

inline double before(double t) { return t - kRangeMargin * std::fabs(t); }
inline double after(double t) { return t < kInfinity ? t + kRangeMargin * std::fabs(t) : t; }

/// Those of a tree's required leaves that every ray meets in one stretch at most: what is inside
/// the tree lies in the common part of these stretches. Half-spaces, the most frequent of them, are
/// met in world space.
class ConvexCore {
 public:
  /// Takes in a leaf, which is convex or a half-space.
  void add(const PlacedLeaf& leaf, std::uint32_t id);

  /// Appends the ends of all stretches along a ray, and cuts `window` to the common part of the
  /// stretches and a little more. False, with some ends missing, if that is empty. The ends of a
  /// leaf stand together, its entry first; those at infinity may be there or not, but each leaf has
  /// an end. `placed` are all leaves of the tree.
  bool meet(const std::vector<PlacedLeaf>& placed, const Ray& ray, Interval& window,
            Crossings& ends) const;

 private:
  struct HalfSpaceLeaf {
    PlacedHalfSpace half;
    std::uint32_t id;
  };
  std::vector<HalfSpaceLeaf> half_spaces_;
  std::vector<std::uint32_t> others_;
};

/// What nearest_end says.
enum class NearestEnd {
  kNone,
  kFound,
  kUnclear,  ///< another end may lie at the same place
};

/// Whether the error interval of `end` meets none of another finite end. What has its leaf and its
/// t is `end` itself.
bool stands_alone(const Crossings& ends, const Crossing& end);

/// The first visible end of the common part of the stretches with these ends that lies in the
/// range and not at its start.
NearestEnd nearest_end(const Crossings& ends, Interval range, Crossing& out);

}  // namespace dioptre::csg
