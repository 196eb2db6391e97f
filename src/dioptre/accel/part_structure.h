// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/bounding_volume_hierarchy.h"

namespace dioptre {

/// The structure over the parts of one object, the triangles of a mesh or the primitives of a
/// solid: the hierarchy, which is walked without virtual calls, or any other by its name.
class PartStructure {
 public:
  PartStructure() = default;
  /// Builds the named structure; the hierarchy, with at most `leaf_size` parts in a leaf, for "bvh"
  /// and for a name that is not known.
  PartStructure(std::string_view name, std::span<const Bounds> boxes, std::uint32_t leaf_size);

  /// A box around all parts.
  Bounds bounds() const { return other_ ? other_->bounds() : tree_.bounds(); }
  /// The hierarchy; null if another structure is in its place.
  const BoundingVolumeHierarchy* hierarchy() const { return other_ ? nullptr : &tree_; }

  /// As BoundingVolumeHierarchy::traverse.
  template <class Leaf>
  void traverse(const Ray& ray, Interval& range, Leaf&& leaf) const {
    if (!other_) return tree_.traverse(ray, range, leaf);
    Visitor<Leaf> visitor(leaf);
    other_->visit(ray, range, visitor);
  }

  /// As BoundingVolumeHierarchy::visit_at.
  template <class Leaf>
  void visit_at(Vec3 p, Leaf&& leaf) const {
    if (!other_) return tree_.visit_at(p, leaf);
    std::vector<std::uint32_t> parts;
    other_->items_at(p, parts);
    for (const std::uint32_t part : parts) leaf(part);
  }

 private:
  template <class Leaf>
  class Visitor final : public LeafVisitor {
   public:
    explicit Visitor(Leaf& leaf) : leaf_(leaf) {}
    bool visit(std::uint32_t part, Interval& range) override { return leaf_(part, range); }

   private:
    Leaf& leaf_;
  };

  BoundingVolumeHierarchy tree_;
  AcceleratorPtr other_;
};

}  // namespace dioptre
