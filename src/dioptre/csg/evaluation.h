// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/accel/nearest_first.h"
#include "dioptre/csg/compiled.h"

namespace dioptre::csg {

/// Room for evaluations, kept from one to the next so that none allocates. What a stamp does not
/// mark as of this evaluation counts as unset, so nothing is ever cleared.
struct Scratch {
  struct NodeState {
    std::uint64_t stamp = 0;    ///< the evaluation that set `count`
    std::uint64_t cluster = 0;  ///< the cluster that set `before`
    std::uint64_t passed = 0;   ///< the cluster of which an event has passed
    std::uint32_t count = 0;    ///< of true children
    std::uint32_t before = 0;   ///< the same before the cluster
  };
  struct LeafState {
    std::uint64_t stamp = 0;    ///< the evaluation that set `truth`
    std::uint64_t cluster = 0;  ///< the cluster that set `before`
    bool truth = false;
    bool before = false;
  };
  /// A crossing that is not yet swept.
  struct Event {
    double t;
    std::uint32_t leaf, index;
    /// Orders a heap so that the nearest is on top.
    bool operator<(const Event& b) const {
      return t != b.t ? t > b.t : leaf != b.leaf ? leaf > b.leaf : index > b.index;
    }
  };

  std::uint64_t clock = 0;  ///< the last stamp given out
  std::vector<NodeState> nodes;
  std::vector<LeafState> leaves;
  Crossings crossings;
  std::vector<Event> heap, cluster;
  std::vector<Crossing> passed;
  std::vector<NearestFirst::Pending> walk;
};

/// Lends the calling thread a scratch; leases nest, as one tree may be asked within another.
class ScratchLease {
 public:
  ScratchLease();
  ~ScratchLease();
  ScratchLease(const ScratchLease&) = delete;
  ScratchLease& operator=(const ScratchLease&) = delete;
  Scratch& operator*() const { return *scratch_; }

 private:
  Scratch* scratch_;
};

/// The truth of all leaves and operators of a tree at one place, kept up to date as leaves change.
class Truth {
 public:
  Truth(const Compiled& tree, Scratch& scratch);

  bool leaf(std::uint32_t leaf) const;
  bool root() const { return count(0) >= tree_.nodes[0].threshold; }
  void set_leaf(std::uint32_t leaf, bool truth);

  /// Begins a group of changes that happen at one place.
  void begin_cluster() { cluster_ = ++scratch_.clock; }
  /// Whether a crossing of the current group, its changes made, reaches the root as surface.
  bool passes(const Crossing& crossing);

 private:
  std::uint32_t count(std::size_t node) const {
    const Scratch::NodeState& state = scratch_.nodes[node];
    return state.stamp == stamp_ ? state.count : tree_.nodes[node].count;
  }
  std::uint32_t count_before(std::size_t node) const {
    const Scratch::NodeState& state = scratch_.nodes[node];
    return state.cluster == cluster_ ? state.before : count(node);
  }

  const Compiled& tree_;
  Scratch& scratch_;
  std::uint64_t stamp_, cluster_ = 0;
};

/// The walk along one ray: leaves are opened, and their events swept in order of t.
class Sweep {
 public:
  /// `slabs` is made of `ray`, `within` is the part of the range in the tree's extent; all must
  /// outlive the walk.
  Sweep(const Compiled& tree, Scratch& scratch, const Ray& ray, const SlabRay& slabs,
        Interval range, Interval within);

  /// Appends what the root lets through to scratch.passed, in order of t, up to the first visible
  /// crossing or, with `all`, to the end. Returns whether the ray is inside just after range.min.
  bool run(bool all);

 private:
  bool open_required();
  void open_core(std::uint32_t ends);
  void add_event(std::uint32_t crossing);
  void open(std::uint32_t leaf);
  bool sweep_before(double bound, bool all);
  double gather_cluster();
  bool is_at_start() const;
  void apply_cluster();
  bool emit_cluster();

  const Compiled& tree_;
  Scratch& scratch_;
  const Ray& ray_;
  const SlabRay& slabs_;
  Interval range_;   ///< as asked
  Interval window_;  ///< where something can still be inside or visible, and a little more
  Truth truth_;
  double swept_ = -kInfinity;  ///< all events up to here have been swept
  bool started_ = false;
  bool inside_at_start_ = false;
};

}  // namespace dioptre::csg
