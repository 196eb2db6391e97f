// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "dioptre/accel/box_set.h"
#include "dioptre/accel/slab_test.h"

namespace dioptre {

/// An axis-aligned bounding box, for a VolumeHierarchy.
class BoxVolume {
 public:
  using Items = std::span<const BoxedItem>;
  explicit BoxVolume(Items items) : box_(bounds_of(items)) {}
  bool contains(Vec3 p) const { return box_.contains(p); }

  /// A ray prepared for tests.
  class Probe {
   public:
    explicit Probe(const Ray& ray) : slabs_(ray) {}
    bool meets(const BoxVolume& volume, const Interval& range, double& entry) const {
      return slabs_.meets(volume.box_, range, entry);
    }

   private:
    SlabRay slabs_;
  };

 private:
  SlabBox box_;
};

}  // namespace dioptre
