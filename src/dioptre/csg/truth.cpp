// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/evaluation.h"

namespace dioptre::csg {

Truth::Truth(const Compiled& tree, Scratch& scratch)
    : tree_(tree), scratch_(scratch), stamp_(++scratch.clock) {
  if (scratch_.nodes.size() < tree.nodes.size()) scratch_.nodes.resize(tree.nodes.size());
  if (scratch_.leaves.size() < tree.leaves.size()) scratch_.leaves.resize(tree.leaves.size());
}

bool Truth::leaf(std::uint32_t leaf) const {
  const Scratch::LeafState& state = scratch_.leaves[leaf];
  return state.stamp == stamp_ ? state.truth : tree_.leaves[leaf].outside;
}

void Truth::set_leaf(std::uint32_t leaf, bool truth) {
  const bool old = this->leaf(leaf);
  if (old == truth) return;
  Scratch::LeafState& state = scratch_.leaves[leaf];
  if (state.cluster != cluster_) state.cluster = cluster_, state.before = old;
  state.stamp = stamp_;
  state.truth = truth;
  std::int32_t parent = tree_.leaves[leaf].parent;
  while (parent != kNone) {
    const auto index = static_cast<std::size_t>(parent);
    const CompiledNode& node = tree_.nodes[index];
    const std::uint32_t count = this->count(index);
    Scratch::NodeState& above = scratch_.nodes[index];
    if (above.cluster != cluster_) above.cluster = cluster_, above.before = count;
    above.stamp = stamp_;
    above.count = truth ? count + 1 : count - 1;
    if ((count >= node.threshold) == (above.count >= node.threshold)) return;
    parent = node.parent;
  }
}

bool Truth::passes(const Crossing& crossing) {
  const CompiledLeaf& leaf = tree_.leaves[crossing.leaf];
  const Scratch::LeafState& state = scratch_.leaves[crossing.leaf];
  bool after = this->leaf(crossing.leaf);
  bool before = state.cluster == cluster_ ? state.before : after;
  // A toggle changes the truth of the child it comes from; a sheet or an inner surface does not.
  bool toggles = before != after;
  if (!toggles && !leaf.sheet) return false;
  bool clips = leaf.clips;
  for (std::int32_t parent = leaf.parent; parent != kNone;) {
    if (clips && !toggles) return false;
    const auto index = static_cast<std::size_t>(parent);
    const CompiledNode& node = tree_.nodes[index];
    const std::uint32_t count_was = count_before(index), count_is = count(index);
    const bool was = count_was >= node.threshold, is = count_is >= node.threshold;
    if (node.operation == Operation::kUnion) {
      toggles = toggles && was != is;
    } else if (toggles) {
      if (was == is || scratch_.nodes[index].passed == cluster_) return false;
      scratch_.nodes[index].passed = cluster_;
    } else {
      // The siblings must allow it on both sides: a merge when none is true, else when all are.
      const std::uint32_t allowed = node.operation == Operation::kMerge ? 0 : node.children - 1;
      if (count_was - before != allowed || count_is - after != allowed) return false;
    }
    before = was;
    after = is;
    clips = node.clips;
    parent = node.parent;
  }
  return true;
}

}  // namespace dioptre::csg
