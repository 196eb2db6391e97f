// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/bounding_volume_hierarchy.h"
#include "dioptre/accel/slab_test.h"

namespace dioptre {
namespace {

/// Tests every box: what all the others are measured against.
class EveryBox final : public Accelerator {
 public:
  explicit EveryBox(std::span<const Bounds> boxes) {
    boxes_.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].empty()) continue;
      boxes_.push_back({SlabBox(boxes[i]), i});
      bounds_ = unite(bounds_, boxes[i]);
    }
  }

  void visit(const Ray& ray, Interval range, LeafVisitor& leaf) const override {
    const SlabRay slabs(ray);
    double entry = 0;
    for (const auto& [box, item] : boxes_) {
      if (slabs.meets(box, range, entry) && !leaf.visit(item, range)) return;
    }
  }

  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const override {
    for (const auto& [box, item] : boxes_) {
      if (box.contains(p)) items.push_back(item);
    }
  }

  Bounds bounds() const override { return bounds_; }

 private:
  struct Entry {
    SlabBox box;
    std::uint32_t item;
  };
  std::vector<Entry> boxes_;
  Bounds bounds_;
};

class Hierarchy final : public Accelerator {
 public:
  explicit Hierarchy(std::span<const Bounds> boxes) : tree_(boxes, 2) {}

  void visit(const Ray& ray, Interval range, LeafVisitor& leaf) const override {
    tree_.traverse(ray, range,
                   [&leaf](std::uint32_t item, Interval& left) { return leaf.visit(item, left); });
  }

  void items_at(Vec3 p, std::vector<std::uint32_t>& items) const override {
    tree_.visit_at(p, [&items](std::uint32_t item) { items.push_back(item); });
  }

  Bounds bounds() const override { return tree_.bounds(); }

 private:
  BoundingVolumeHierarchy tree_;
};

template <class Kind>
AcceleratorPtr make(std::span<const Bounds> boxes) {
  return std::make_unique<Kind>(boxes);
}

/// The one table of accelerators.
struct Row {
  std::string_view name;
  AcceleratorPtr (*make)(std::span<const Bounds>);
};
constexpr std::array kTable{Row{"bvh", make<Hierarchy>}, Row{"none", make<EveryBox>}};

constexpr auto kNames = [] {
  std::array<std::string_view, kTable.size()> names;
  for (std::size_t i = 0; i < kTable.size(); ++i) names[i] = kTable[i].name;
  return names;
}();

}  // namespace

std::span<const std::string_view> accelerator_names() { return kNames; }

Result<AcceleratorPtr> make_accelerator(std::string_view name, std::span<const Bounds> boxes) {
  for (const Row& row : kTable) {
    if (row.name == name) return row.make(boxes);
  }
  std::string message = "there is no accelerator '" + std::string(name) + "'; there are:";
  for (const std::string_view each : kNames) message.append(" ").append(each);
  return fail(std::move(message));
}

}  // namespace dioptre
