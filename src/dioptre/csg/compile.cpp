// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "dioptre/csg/compiled.h"
#include "dioptre/csg/polytope_bounds.h"

namespace dioptre::csg {
namespace {

/// Copies the tree into flat nodes, parents before children. A node joins its parent where that has
/// the same associative operator, and a node of one child gives way to it. Keeps its own stack: the
/// depth is the user's.
class Flattener {
 public:
  Flattener(const Description& description, Compiled& out)
      : description_(description), out_(out), seen_(description.nodes.size(), false) {
    out_.leaves.resize(description.leaves.size());
  }

  void run() {
    pending_.push_back({description_.root, {}});
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      if (next.entry < 0) {
        add_leaf(static_cast<std::uint32_t>(~next.entry), next.place);
      } else {
        add_node(static_cast<std::size_t>(next.entry), next.place);
      }
    }
  }

 private:
  struct Place {
    std::int32_t parent = kNone;
    bool clips = false;
    bool drawn = true;
  };
  struct Pending {
    std::int32_t entry;
    Place place;
  };

  void count_child(const Place& place) {
    if (place.parent != kNone) ++out_.nodes[static_cast<std::size_t>(place.parent)].children;
  }

  void add_leaf(std::uint32_t index, const Place& place) {
    if (index >= out_.leaves.size() || out_.leaves[index].used) return;
    CompiledLeaf& leaf = out_.leaves[index];
    leaf.used = true;
    leaf.parent = place.parent;
    leaf.clips = place.clips;
    leaf.drawn = place.drawn;
    if (place.parent == kNone) out_.only_leaf = static_cast<std::int32_t>(index);
    count_child(place);
  }

  void add_node(std::size_t index, const Place& place) {
    if (index >= seen_.size() || seen_[index]) return;
    seen_[index] = true;
    const Node& node = description_.nodes[index];
    Place inner = place;
    if (node.children.size() != 1 && !joins(node, place)) {
      inner = {static_cast<std::int32_t>(out_.nodes.size()), false, place.drawn};
      count_child(place);
      CompiledNode& own = out_.nodes.emplace_back();
      own.operation = node.operation;
      own.parent = place.parent;
      own.clips = place.clips;
    }
    const bool clip = node.operation == Operation::kClip && node.children.size() > 1;
    for (std::size_t i = node.children.size(); i-- > 0;) {
      Place child = inner;
      if (clip && i > 0) child.clips = true, child.drawn = false;
      pending_.push_back({node.children[i], child});
    }
  }

  bool joins(const Node& node, const Place& place) const {
    return place.parent != kNone && node.operation != Operation::kClip &&
           out_.nodes[static_cast<std::size_t>(place.parent)].operation == node.operation;
  }

  const Description& description_;
  Compiled& out_;
  std::vector<bool> seen_;
  std::vector<Pending> pending_;
};

bool is_conjunction(Operation operation) {
  return operation == Operation::kIntersection || operation == Operation::kClip;
}

/// What is known of a subtree from its children.
struct Extent {
  Bounds bounds;       ///< around all that is inside or visible
  bool truth = false;  ///< far from everything
  bool solid = false;  ///< whether anything can be inside
};

/// Carries bounds up the tree, then down; what the leaves are cut to tightens their own bounds, and
/// so on, a few times.
class BoundsPass {
 public:
  explicit BoundsPass(Compiled& out)
      : out_(out), extents_(out.nodes.size()), polytopes_(out.nodes.size(), Bounds::all()) {
    for (const PlacedLeaf& leaf : out.placed) leaf_bounds_.push_back(leaf.bounds());
    find_polytopes();
  }

  void run() {
    constexpr int kRounds = 3;
    up_and_down();
    for (int round = 1; round < kRounds && tighten(); ++round) up_and_down();
    const Bounds root = extents_[0].bounds;
    Bounds surfaces;
    for (std::uint32_t i = 0; i < out_.leaves.size(); ++i) {
      CompiledLeaf& leaf = out_.leaves[i];
      if (!leaf.used) continue;
      const Bounds interest = part(leaf_bounds_[i], extent_around(leaf).bounds);
      leaf.interest = SlabBox(interest);
      if (!interest.empty()) surfaces = unite(surfaces, interest);
      sort_in(i, interest);
    }
    std::stable_sort(out_.required.begin(), out_.required.end(),
                     [&](auto a, auto b) { return out_.placed[a].cost() < out_.placed[b].cost(); });
    sort_required();
    out_.solid = extents_[0].solid;
    out_.bounds = extents_[0].truth ? root : part(surfaces, root);
    out_.extent = SlabBox(out_.bounds);
  }

 private:
  /// The common part, in one form if empty.
  static Bounds part(const Bounds& a, const Bounds& b) {
    const Bounds common = intersect(a, b);
    return common.empty() ? Bounds{} : common;
  }

  const Extent& extent_around(const CompiledLeaf& leaf) const {
    return extents_[static_cast<std::size_t>(leaf.parent)];
  }

  /// Cuts the leaves to what is around them; true if that made one smaller.
  bool tighten() {
    bool smaller = false;
    for (std::uint32_t i = 0; i < out_.leaves.size(); ++i) {
      const CompiledLeaf& leaf = out_.leaves[i];
      if (!leaf.used || leaf_bounds_[i].finite()) continue;
      const Bounds cut =
          part(leaf_bounds_[i], out_.placed[i].bounds_within(extent_around(leaf).bounds));
      smaller = smaller || cut != leaf_bounds_[i];
      leaf_bounds_[i] = cut;
    }
    return smaller;
  }

  /// Bounds the conjunctions of half-spaces: their faces may be tilted, and none of them finite.
  void find_polytopes() {
    std::vector<std::vector<PlacedHalfSpace>> sides(out_.nodes.size());
    for (std::uint32_t i = 0; i < out_.leaves.size(); ++i) {
      const auto& half = out_.placed[i].half_space();
      if (out_.leaves[i].used && half) {
        sides[static_cast<std::size_t>(out_.leaves[i].parent)].push_back(*half);
      }
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (is_conjunction(out_.nodes[i].operation)) polytopes_[i] = polytope_bounds(sides[i]);
    }
  }

  void up_and_down() {
    up();
    for (std::size_t i = 1; i < extents_.size(); ++i) {
      const auto parent = static_cast<std::size_t>(out_.nodes[i].parent);
      extents_[i].bounds = part(extents_[i].bounds, extents_[parent].bounds);
    }
  }

  void up() {
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      CompiledNode& node = out_.nodes[i];
      node.count = 0;
      const bool all = is_conjunction(node.operation) && node.children > 0;
      node.threshold = all ? node.children : 1;
      extents_[i].bounds = all ? polytopes_[i] : Bounds{};
      extents_[i].solid = all;
    }
    for (std::uint32_t i = 0; i < out_.leaves.size(); ++i) {
      CompiledLeaf& leaf = out_.leaves[i];
      if (!leaf.used) continue;
      leaf.outside = out_.placed[i].outside();
      leaf.sheet = !out_.placed[i].solid();
      add(leaf.parent, {leaf.outside ? Bounds::all() : leaf_bounds_[i], leaf.outside,
                        !leaf.sheet || leaf.outside});
    }
    for (std::size_t i = extents_.size(); i-- > 1;) {
      extents_[i].truth = out_.nodes[i].count >= out_.nodes[i].threshold;
      add(out_.nodes[i].parent, extents_[i]);
    }
    extents_[0].truth = out_.nodes[0].count >= out_.nodes[0].threshold;
  }

  /// Tells a parent of one child.
  void add(std::int32_t parent, const Extent& child) {
    CompiledNode& node = out_.nodes[static_cast<std::size_t>(parent)];
    Extent& extent = extents_[static_cast<std::size_t>(parent)];
    if (child.truth) ++node.count;
    if (is_conjunction(node.operation)) {
      extent.bounds = part(extent.bounds, child.bounds);
      extent.solid = extent.solid && child.solid;
    } else {
      extent.bounds = unite(extent.bounds, child.bounds);
      extent.solid = extent.solid || child.solid;
    }
  }

  void sort_in(std::uint32_t index, const Bounds& interest) {
    const CompiledLeaf& leaf = out_.leaves[index];
    const bool conjunct = leaf.parent == 0 && is_conjunction(out_.nodes[0].operation);
    if (conjunct && (!leaf.outside || out_.placed[index].half_space())) {
      out_.required.push_back(index);
    } else if (!interest.empty()) {
      out_.optional.push_back(index);
    }
  }

  /// Tells the core from the other required leaves. Convex leaves that are no half-spaces join it
  /// only where the tree is carved or all core: else asking them one by one is faster.
  void sort_required() {
    const bool simple = find_general() && out_.nodes.size() == 1;
    out_.convex = simple && out_.optional.empty() && out_.general == kNone;
    out_.carved = simple && !out_.convex;
    for (const std::uint32_t i : out_.required) {
      if (i == static_cast<std::uint32_t>(out_.general)) {
        out_.beside.push_back(i);
      } else if (simple || out_.placed[i].half_space()) {
        out_.core.add(out_.placed[i], i);
      } else {
        out_.beside.push_back(i);
      }
    }
  }

  /// Finds the leaf that is neither of the core nor a bite; false if there are several such leaves,
  /// or sheets.
  bool find_general() {
    const auto sort_out = [this](const std::vector<std::uint32_t>& leaves, auto known) {
      for (const std::uint32_t i : leaves) {
        if (known(out_.placed[i])) continue;
        if (out_.general != kNone || out_.leaves[i].sheet) return false;
        out_.general = static_cast<std::int32_t>(i);
      }
      return true;
    };
    const bool one =
        sort_out(out_.required,
                 [](const PlacedLeaf& leaf) { return leaf.half_space() || leaf.convex(); }) &&
        sort_out(out_.optional, [](const PlacedLeaf& leaf) { return leaf.bite(); });
    if (!one) out_.general = kNone;
    return one;
  }

  Compiled& out_;
  std::vector<Extent> extents_;
  std::vector<Bounds> polytopes_;  ///< around the half-spaces of each conjunction
  std::vector<Bounds> leaf_bounds_;
};

}  // namespace

Compiled compile(const Description& description, std::size_t many, std::string_view accelerator) {
  Compiled out;
  out.placed.reserve(description.leaves.size());
  for (const Leaf& leaf : description.leaves) out.placed.emplace_back(leaf);
  Flattener(description, out).run();
  if (out.nodes.empty()) return out;
  out.only_leaf = kNone;
  BoundsPass(out).run();
  if (out.optional.size() > many) {
    std::vector<Bounds> boxes;
    boxes.reserve(out.optional.size());
    for (const std::uint32_t i : out.optional) {
      const auto& p = out.leaves[i].interest.plane;
      boxes.push_back({{p[0], p[1], p[2]}, {p[3], p[4], p[5]}});
    }
    out.structure = PartStructure(accelerator, boxes, 1);
  }
  return out;
}

}  // namespace dioptre::csg
