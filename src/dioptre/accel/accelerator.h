// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "dioptre/core/bounds.h"
#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"
#include "dioptre/core/result.h"

namespace dioptre {

/// What an accelerator calls for each item that the ray may meet.
class LeafVisitor {
 public:
  virtual ~LeafVisitor() = default;
  /// Looks at item `item`. May lower `range.max` (never raise it): what lies beyond is then
  /// skipped. Returning false ends the walk.
  virtual bool visit(std::uint32_t item, Interval& range) = 0;
};

/// Finds which of n boxes a ray or a point may meet. Knows only boxes and indices. May report an
/// item too often, never too seldom, and may report the same item twice.
class Accelerator {
 public:
  virtual ~Accelerator() = default;
  /// Reports the items whose box the ray meets within `range`, near ones first as far as it can.
  virtual void visit(const Ray& ray, Interval range, LeafVisitor& leaf) const = 0;
  /// Appends the items whose box holds p.
  virtual void items_at(Vec3 p, std::vector<std::uint32_t>& items) const = 0;
  /// A box around all items.
  virtual Bounds bounds() const = 0;
};

using AcceleratorPtr = std::unique_ptr<const Accelerator>;

/// The names that make_accelerator knows, best first.
std::span<const std::string_view> accelerator_names();

/// Builds the named structure over the boxes. Empty boxes are never reported; unbounded ones are
/// split off here and looked at for every ray. An unknown name is an error that lists the names.
Result<AcceleratorPtr> make_accelerator(std::string_view name, std::span<const Bounds> boxes);

}  // namespace dioptre
