// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
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

/// What walks have cost so far; a walk adds to it.
struct WalkCost {
  std::uint64_t nodes = 0;  ///< inner nodes, cells or bounding volumes looked at
  std::uint64_t boxes = 0;  ///< boxes of single items tested
  std::uint64_t items = 0;  ///< items reported
};

/// How large a structure is.
struct AcceleratorStatistics {
  std::size_t nodes = 0;       ///< inner nodes and leaves, or cells
  std::size_t references = 0;  ///< items listed, one listed in several places counted each time
  std::size_t bytes = 0;       ///< memory in use
};

/// Finds which of n boxes a ray or a point may meet. Knows only boxes and indices. May report an
/// item that the ray does not meet, never misses one that it does, and reports none twice.
class Accelerator {
 public:
  virtual ~Accelerator() = default;
  /// Reports the items whose box the ray meets within `range`, near ones first as far as it can,
  /// and adds up what that costs.
  virtual void visit(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const = 0;
  /// The same, uncounted.
  void visit(const Ray& ray, Interval range, LeafVisitor& leaf) const {
    WalkCost ignored;
    visit(ray, range, leaf, ignored);
  }
  /// Appends the items whose box holds p.
  virtual void items_at(Vec3 p, std::vector<std::uint32_t>& items) const = 0;
  /// A box around all items.
  virtual Bounds bounds() const = 0;
  /// The size of the structure.
  virtual AcceleratorStatistics statistics() const = 0;
};

using AcceleratorPtr = std::unique_ptr<const Accelerator>;

/// What an accelerator may be told besides the boxes.
struct AcceleratorOptions {
  /// Where the camera's rays start, if that is one point: what "extents" is built around.
  std::optional<Vec3> eye;
};

/// The names that make_accelerator knows, best first. "slabs:K" is known too, K from 3 to 13, and
/// "extents:NAME", with the structure for all rays but those from the eye ("bvh" for "extents").
std::span<const std::string_view> accelerator_names();

/// Builds the named structure over the boxes. Empty boxes are never reported; unbounded ones are
/// split off here and looked at for every ray. An unknown name is an error that lists the names.
Result<AcceleratorPtr> make_accelerator(std::string_view name, std::span<const Bounds> boxes,
                                        const AcceleratorOptions& options = {});

}  // namespace dioptre
