// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/bounding_volume_hierarchy.h"
#include "dioptre/accel/box_volume.h"
#include "dioptre/accel/every_box.h"
#include "dioptre/accel/grid.h"
#include "dioptre/accel/octree.h"
#include "dioptre/accel/screen_extents.h"
#include "dioptre/accel/slab_volume.h"
#include "dioptre/accel/sphere_volume.h"
#include "dioptre/accel/split_tree.h"
#include "dioptre/accel/two_level_grid.h"
#include "dioptre/accel/volume_hierarchy.h"

namespace dioptre {
namespace {

/// A structure over the boxes of moderate numbers, and the others apart.
template <class Structure>
class Over final : public Accelerator {
 public:
  template <class... More>
  explicit Over(BoxSet set, More&&... more)
      : bounds_(set.bounds),
        apart_(std::move(set.apart)),
        structure_(std::move(set.walkable), std::forward<More>(more)...) {}

  void visit(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const override {
    if (!apart_.walk_on(SlabRay(ray), range, leaf, cost)) return;
    structure_.walk(ray, range, leaf, cost);
  }

  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const override {
    apart_.items_at(p, items);
    structure_.items_at(p, items);
  }

  Bounds bounds() const override { return bounds_; }

  AcceleratorStatistics statistics() const override {
    const AcceleratorStatistics few = apart_.statistics();
    AcceleratorStatistics size = structure_.statistics();
    size.references += few.references;
    size.bytes += few.bytes;
    return size;
  }

 private:
  Bounds bounds_;
  EveryBox apart_;
  Structure structure_;
};

/// The hierarchy that meshes and solids use too.
class Hierarchy final : public Accelerator {
 public:
  /// One item in a leaf: its own box is then tested beside its neighbour's.
  explicit Hierarchy(std::span<const Bounds> boxes) : tree_(boxes, 1) {}

  void visit(const Ray& ray, Interval range, LeafVisitor& leaf, WalkCost& cost) const override {
    tree_.traverse(ray, range, Report{leaf, cost});
  }

  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const override {
    tree_.visit_at(p, [&items](std::uint32_t item) { items.push_back(item); });
  }

  Bounds bounds() const override { return tree_.bounds(); }

  AcceleratorStatistics statistics() const override {
    return {tree_.node_count(), tree_.item_count(), tree_.bytes()};
  }

 private:
  struct Report {
    LeafVisitor& leaf;
    WalkCost& cost;
    void step() { ++cost.nodes; }
    bool operator()(std::uint32_t item, Interval& left) {
      ++cost.items;
      return leaf.visit(item, left);
    }
  };

  BoundingVolumeHierarchy tree_;
};

using Boxes = std::span<const Bounds>;
using Options = AcceleratorOptions;
using Make = AcceleratorPtr (*)(Boxes, const Options&);

AcceleratorPtr make_bvh(Boxes boxes, const Options&) { return std::make_unique<Hierarchy>(boxes); }

template <class Structure>
AcceleratorPtr make(Boxes boxes, const Options&) {
  return std::make_unique<Over<Structure>>(sort_boxes(boxes));
}

template <void (*build)(std::span<const BoxedItem>, SplitTree::Builder&)>
AcceleratorPtr make_bsp(Boxes boxes, const Options&) {
  return std::make_unique<Over<SplitTree>>(sort_boxes(boxes), build);
}

/// For the rays that do not start in the eye the structure `others` stands over the same boxes.
template <class MakeOthers>
AcceleratorPtr make_extents_over(Boxes boxes, const Options& options, MakeOthers others) {
  BoxSet set = sort_boxes(boxes);
  std::vector<Bounds> walkable;
  walkable.reserve(set.walkable.size());
  for (const BoxedItem& each : set.walkable) walkable.push_back(each.box);
  return std::make_unique<Over<ScreenExtents>>(std::move(set), options.eye,
                                               others(walkable, options));
}

AcceleratorPtr make_extents(Boxes boxes, const Options& options) {
  return make_extents_over(boxes, options, make_bvh);
}

/// The one table of accelerators.
struct Row {
  std::string_view name;
  Make make;
};
constexpr std::array kTable{Row{"bvh", make_bvh},
                            Row{"bsp", make_bsp<build_bsp_sah>},
                            Row{"bsp-median", make_bsp<build_bsp_median>},
                            Row{"octree", make<Octree>},
                            Row{"grid2", make<TwoLevelGrid>},
                            Row{"grid", make<Grid>},
                            Row{"boxes", make<VolumeHierarchy<BoxVolume>>},
                            Row{"slabs", make<VolumeHierarchy<SlabVolume<7>>>},
                            Row{"spheres", make<VolumeHierarchy<SphereVolume>>},
                            Row{"extents", make_extents},
                            Row{"none", make<EveryBox>}};

constexpr auto kNames = [] {
  std::array<std::string_view, kTable.size()> names;
  for (std::size_t i = 0; i < kTable.size(); ++i) names[i] = kTable[i].name;
  return names;
}();

/// Hierarchies of slabs by the number of directions, from 3 on.
constexpr auto kSlabs = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array{make<VolumeHierarchy<SlabVolume<I + 3>>>...};
}
(std::make_index_sequence<kDiagonals.size() + 1>());

/// The builder for "slabs:K", or null.
Make find_slabs(std::string_view name) {
  constexpr std::string_view kPrefix = "slabs:";
  if (!name.starts_with(kPrefix)) return nullptr;
  const char* const end = name.data() + name.size();
  std::size_t directions = 0;
  const auto read = std::from_chars(name.data() + kPrefix.size(), end, directions);
  if (read.ec != std::errc() || read.ptr != end) return nullptr;
  return directions >= 3 && directions - 3 < kSlabs.size() ? kSlabs[directions - 3] : nullptr;
}

/// The structure that "extents:NAME" pairs the extents with, or null.
Make find_paired(std::string_view name) {
  constexpr std::string_view kPrefix = "extents:";
  if (!name.starts_with(kPrefix)) return nullptr;
  name.remove_prefix(kPrefix.size());
  for (const Row& row : kTable) {
    if (row.name == name) return row.make;
  }
  return find_slabs(name);
}

}  // namespace

std::span<const std::string_view> accelerator_names() { return kNames; }

Result<AcceleratorPtr> make_accelerator(std::string_view name, std::span<const Bounds> boxes,
                                        const AcceleratorOptions& options) {
  for (const Row& row : kTable) {
    if (row.name == name) return row.make(boxes, options);
  }
  if (const auto make_slabs = find_slabs(name)) return make_slabs(boxes, options);
  if (const auto paired = find_paired(name)) return make_extents_over(boxes, options, paired);
  std::string message = "there is no accelerator '" + std::string(name) + "'; there are:";
  for (const std::string_view each : kNames) message.append(" ").append(each);
  return fail(std::move(message));
}

}  // namespace dioptre
