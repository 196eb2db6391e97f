// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/tree.h"

#include <algorithm>
#include <utility>

#include "dioptre/csg/carving.h"
#include "dioptre/csg/compiled.h"
#include "dioptre/csg/evaluation.h"
#include "dioptre/csg/explainable.h"

namespace dioptre::csg {
namespace {

/// A tree that is just one leaf.
class PlacedShape final : public Explainable {
 public:
  PlacedShape(PlacedLeaf leaf, std::uint32_t id) : leaf_(std::move(leaf)), id_(id) {}

  Bounds bounds() const override { return leaf_.outside() ? Bounds::all() : leaf_.bounds(); }
  bool solid() const override { return leaf_.solid(); }
  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    return leaf_.crossings(ray, range, id_, out);
  }
  bool contains(Vec3 p) const override { return leaf_.contains(p); }
  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    return leaf_.surface(ray, crossing);
  }
  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    return leaf_.uv(ray, crossing);
  }
  void texture_shares(const Ray& ray, const Crossing& crossing,
                      std::vector<TextureShare>& out) const override {
    leaf_.texture_shares(ray, crossing, out);
  }
  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    if (!leaf_.nearest(ray, range, out)) return false;
    out.leaf = id_;
    return true;
  }

  RayStretches explain(const Ray& ray, Interval range) const override {
    Crossings crossings;
    const bool inside = leaf_.crossings(ray, range, id_, crossings);
    RayStretches out;
    out.nodes.push_back({.is_leaf = true,
                         .leaf = id_,
                         .complement = leaf_.complement(),
                         .inside = stretches_of(crossings, inside, range)});
    for (const Crossing& crossing : crossings) out.events.push_back(fate_of(out, 0, crossing));
    return out;
  }

 private:
  PlacedLeaf leaf_;
  std::uint32_t id_;
};

/// A tree of operators over several leaves.
class Tree final : public Explainable {
 public:
  explicit Tree(Compiled compiled) : compiled_(std::move(compiled)) {}

  Bounds bounds() const override { return compiled_.bounds; }
  bool solid() const override { return compiled_.solid; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const SlabRay slabs(ray);
    Interval within = range;
    if (!slabs.clip(compiled_.extent, within)) return false;
    const ScratchLease scratch;
    const bool inside = Sweep(compiled_, *scratch, ray, slabs, range, within).run(true);
    out.insert(out.end(), (*scratch).passed.begin(), (*scratch).passed.end());
    return inside;
  }

  /// Whoever asks has mostly tested the box already: the core is faster than one more test.
  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    if (compiled_.convex) {
      const NearestEnd found = nearest_end_of_core(ray, range, out);
      if (found != NearestEnd::kUnclear) return found == NearestEnd::kFound;
    }
    const ScratchLease scratch;
    if (compiled_.carved) {
      const NearestEnd found = carve(compiled_, *scratch, ray, range, out);
      if (found != NearestEnd::kUnclear) return found == NearestEnd::kFound;
    }
    const SlabRay slabs(ray);
    Interval within = range;
    if (!slabs.clip(compiled_.extent, within)) return false;
    Sweep(compiled_, *scratch, ray, slabs, range, within).run(false);
    for (const Crossing& crossing : (*scratch).passed) {
      if (!crossing.visible) continue;
      out = crossing;
      return true;
    }
    return false;
  }

  bool contains(Vec3 p) const override {
    if (!compiled_.extent.contains(p)) return false;
    const ScratchLease scratch;
    Truth truth(compiled_, *scratch);
    const auto ask = [&](std::uint32_t leaf) {
      if (compiled_.leaves[leaf].sheet || !compiled_.leaves[leaf].interest.contains(p)) return;
      truth.set_leaf(leaf, compiled_.placed[leaf].contains(p));
    };
    for (const std::uint32_t leaf : compiled_.required) {
      ask(leaf);
      if (!truth.leaf(leaf)) return false;
    }
    if (compiled_.structure.bounds().empty()) {
      for (const std::uint32_t leaf : compiled_.optional) ask(leaf);
    } else {
      compiled_.structure.visit_at(p, [&](std::uint32_t i) { ask(compiled_.optional[i]); });
    }
    return truth.root();
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    return compiled_.placed[crossing.leaf].surface(ray, crossing);
  }
  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    return compiled_.placed[crossing.leaf].uv(ray, crossing);
  }
  void texture_shares(const Ray& ray, const Crossing& crossing,
                      std::vector<TextureShare>& out) const override {
    compiled_.placed[crossing.leaf].texture_shares(ray, crossing, out);
  }

  RayStretches explain(const Ray& ray, Interval range) const override {
    RayStretches out;
    for (const CompiledNode& node : compiled_.nodes) {
      out.nodes.push_back({.parent = node.parent, .operation = node.operation});
    }
    Crossings all;
    const std::size_t first_leaf = out.nodes.size();
    std::vector<std::size_t> place(compiled_.placed.size(), 0);
    for (std::uint32_t i = 0; i < compiled_.placed.size(); ++i) {
      if (!compiled_.leaves[i].used) continue;
      const PlacedLeaf& leaf = compiled_.placed[i];
      Crossings crossings;
      const bool inside = leaf.crossings(ray, range, i, crossings);
      place[i] = out.nodes.size();
      out.nodes.push_back({.parent = compiled_.leaves[i].parent,
                           .is_leaf = true,
                           .leaf = i,
                           .complement = leaf.complement(),
                           .inside = stretches_of(crossings, inside, range)});
      all.insert(all.end(), crossings.begin(), crossings.end());
    }
    if (first_leaf > 0) join_children(out);
    std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) {
      return a.t != b.t ? a.t < b.t : a.leaf < b.leaf;
    });
    for (const Crossing& crossing : all) {
      out.events.push_back(fate_of(out, place[crossing.leaf], crossing));
    }
    return out;
  }

 private:
  NearestEnd nearest_end_of_core(const Ray& ray, Interval range, Crossing& out) const {
    const ScratchLease scratch;
    Crossings& ends = (*scratch).crossings;
    ends.clear();
    Interval window{range.min, after(range.max)};
    if (!compiled_.core.meet(compiled_.placed, ray, window, ends)) return NearestEnd::kNone;
    for (Crossing& end : ends) end.visible = end.visible && compiled_.leaves[end.leaf].drawn;
    return nearest_end(ends, range, out);
  }

  Compiled compiled_;
};

/// What contains nothing and has no surface.
class Nothing final : public Shape {
 public:
  Bounds bounds() const override { return {}; }
  bool crossings(const Ray&, Interval, Crossings&) const override { return false; }
  bool contains(Vec3) const override { return false; }
  Surface surface(const Ray&, const Crossing&) const override { return {}; }
};

Operation dual(Operation operation) {
  const bool any = operation == Operation::kUnion || operation == Operation::kMerge;
  return any ? Operation::kIntersection : Operation::kMerge;
}

}  // namespace

void complement(Description& description, std::int32_t entry) {
  std::vector<std::int32_t> pending{entry};
  std::vector<bool> seen(description.nodes.size(), false);
  while (!pending.empty()) {
    const std::int32_t next = pending.back();
    pending.pop_back();
    if (next < 0) {
      const auto leaf = static_cast<std::size_t>(~next);
      if (leaf >= description.leaves.size()) continue;
      description.leaves[leaf].complement = !description.leaves[leaf].complement;
    } else if (const auto i = static_cast<std::size_t>(next); i < seen.size() && !seen[i]) {
      seen[i] = true;
      Node& node = description.nodes[i];
      node.operation = dual(node.operation);
      pending.insert(pending.end(), node.children.begin(), node.children.end());
    }
  }
}

ShapePtr build(Description description, std::string_view accelerator) {
  Compiled compiled = compile(description, kManyLeaves, accelerator);
  if (compiled.only_leaf != kNone) {
    const auto leaf = static_cast<std::uint32_t>(compiled.only_leaf);
    return std::make_unique<PlacedShape>(std::move(compiled.placed[leaf]), leaf);
  }
  if (compiled.nodes.empty()) return std::make_unique<Nothing>();
  return std::make_unique<Tree>(std::move(compiled));
}

}  // namespace dioptre::csg
