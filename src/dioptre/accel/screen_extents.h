// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/box_set.h"

namespace dioptre {

/// The extents of items on screens before the eye, so that a camera ray looks only at what covers
/// its pixel (Roth 1982, "Ray casting for modeling solids").
///
/// The screens are the six faces of a cube around the eye, whatever the camera looks at, and each
/// is divided into squares that list the items whose extent covers them, nearest first (as in
/// Haines and Greenberg 1986, "The light buffer"). Rays that do not start in the eye walk another
/// structure over the same boxes.
class ScreenExtents {
 public:
  /// `others` stands over the boxes of the items, in their order. Without an eye all rays take it.
  ScreenExtents(std::span<const BoxedItem> items, std::optional<Vec3> eye, AcceleratorPtr others);

  /// Reports the items whose box the ray meets.
  void walk(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const;
  /// Appends the items whose box holds p.
  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const;
  AcceleratorStatistics statistics() const;

 private:
  friend class ScreenBuilder;
  /// A box as seen from the eye.
  struct Seen {
    SlabBox box;
    double distance;  ///< of its nearest point
    std::uint32_t item;
  };

  class Renumbering;

  void look(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const;
  std::span<const std::uint32_t> covering(Vec3 direction) const;

  std::optional<Vec3> eye_;
  std::vector<Seen> seen_;
  std::size_t side_ = 1;  ///< squares along each side of a screen
  /// Square i of all screens lists listed_[first_[i], first_[i + 1]).
  std::vector<std::uint32_t> first_, listed_;
  std::vector<std::uint32_t> item_of_;  ///< the items of the boxes in `others_`
  AcceleratorPtr others_;
};

}  // namespace dioptre
