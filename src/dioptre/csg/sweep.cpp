// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "dioptre/csg/evaluation.h"

namespace dioptre::csg {
namespace {

/// Where leaves are asked: nothing is inside or visible outside of `within`.
Interval window(const Ray& ray, Interval range, Interval within) {
  const double margin =
      kRangeMargin * max_component(abs(ray.origin)) / max_component(abs(ray.direction));
  return {std::max(range.min, before(within.min) - margin),
          std::min(after(range.max), after(within.max) + margin)};
}

/// The scratches of one thread: those in use first.
struct ScratchStack {
  std::vector<std::unique_ptr<Scratch>> all;
  std::size_t used = 0;
};

ScratchStack& scratch_stack() {
  thread_local ScratchStack stack;
  return stack;
}

}  // namespace

ScratchLease::ScratchLease() {
  ScratchStack& stack = scratch_stack();
  if (stack.used == stack.all.size()) stack.all.push_back(std::make_unique<Scratch>());
  scratch_ = stack.all[stack.used++].get();
}

ScratchLease::~ScratchLease() { --scratch_stack().used; }

Sweep::Sweep(const Compiled& tree, Scratch& scratch, const Ray& ray, const SlabRay& slabs,
             Interval range, Interval within)
    : tree_(tree),
      scratch_(scratch),
      ray_(ray),
      slabs_(slabs),
      range_(range),
      window_(window(ray, range, within)),
      truth_(tree, scratch) {
  scratch_.crossings.clear();
  scratch_.heap.clear();
  scratch_.passed.clear();
}

bool Sweep::run(bool all) {
  if (!open_required()) return false;
  if (tree_.structure.bounds().empty()) {
    double entry = 0;
    for (const std::uint32_t leaf : tree_.optional) {
      if (slabs_.meets(tree_.leaves[leaf].interest, window_, entry)) open(leaf);
    }
    sweep_before(kInfinity, all);
  } else if (const BoundingVolumeHierarchy* hierarchy = tree_.structure.hierarchy()) {
    NearestFirst walk(*hierarchy, slabs_, window_, scratch_.walk);
    std::uint32_t item = 0;
    bool going = true;
    while (going && walk.next(item)) {
      open(tree_.optional[item]);
      going = sweep_before(walk.bound(), all);
    }
    if (going) sweep_before(kInfinity, all);
  } else {
    // Other structures do not say what they have passed: all that the ray may meet is opened.
    Interval met = window_;
    tree_.structure.traverse(ray_, met, [this](std::uint32_t item, Interval&) {
      open(tree_.optional[item]);
      return true;
    });
    sweep_before(kInfinity, all);
  }
  return started_ ? inside_at_start_ : truth_.root();
}

/// Opens the leaves that the root needs; false if the ray misses one, and so everything. The window
/// shrinks to where all are met.
bool Sweep::open_required() {
  if (!tree_.core.meet(tree_.placed, ray_, window_, scratch_.crossings)) return false;
  const auto ends = static_cast<std::uint32_t>(scratch_.crossings.size());
  for (const std::uint32_t leaf : tree_.beside) {
    const std::size_t first = scratch_.crossings.size();
    open(leaf);
    const bool begins_inside = truth_.leaf(leaf);
    if (first == scratch_.crossings.size()) {
      if (!begins_inside) return false;
      continue;
    }
    const Crossing& front = scratch_.crossings[first];
    const Crossing& back = scratch_.crossings.back();
    if (!begins_inside) window_.min = std::max(window_.min, before(front.t - front.error));
    if (!back.entering) window_.max = std::min(window_.max, after(back.t + back.error));
    if (window_.empty()) return false;
  }
  open_core(ends);
  return true;
}

/// Makes events of the ends of the core's stretches, the first so many crossings.
void Sweep::open_core(std::uint32_t ends) {
  for (std::uint32_t i = 0; i < ends;) {
    const std::uint32_t leaf = scratch_.crossings[i].leaf;
    bool inside = true;
    for (; i < ends && scratch_.crossings[i].leaf == leaf; ++i) {
      const Crossing& end = scratch_.crossings[i];
      const bool ahead = end.t > window_.min;
      inside = inside && ahead != end.entering;
      if (ahead && end.t < window_.max) add_event(i);
    }
    truth_.set_leaf(leaf, inside);
  }
}

void Sweep::add_event(std::uint32_t crossing) {
  const Crossing& at = scratch_.crossings[crossing];
  scratch_.heap.push_back({at.t, at.leaf, crossing});
  std::push_heap(scratch_.heap.begin(), scratch_.heap.end());
}

/// Asks a leaf for its events in the window: before it, nothing is inside whatever this leaf is.
/// Those before the place already swept come too late to matter: its bounds of interest begin
/// later.
void Sweep::open(std::uint32_t leaf) {
  Crossings& crossings = scratch_.crossings;
  auto i = static_cast<std::uint32_t>(crossings.size());
  bool inside = tree_.placed[leaf].crossings(ray_, window_, leaf, crossings);
  if (tree_.leaves[leaf].sheet) inside = tree_.leaves[leaf].outside;
  for (; i < crossings.size(); ++i) {
    const Crossing& crossing = crossings[i];
    if (crossing.t <= swept_) {
      if (!tree_.leaves[leaf].sheet) inside = crossing.entering;
    } else if (crossing.t > swept_) {
      add_event(i);
    }
  }
  truth_.set_leaf(leaf, inside);
}

/// Sweeps the events that nothing beginning at `bound` or later can change. False when done.
bool Sweep::sweep_before(double bound, bool all) {
  if (bound < kInfinity) bound -= rounding_of(ray_, bound);
  while (!scratch_.heap.empty() && scratch_.heap.front().t < bound) {
    const double end = gather_cluster();
    if (end >= bound && bound < kInfinity) {
      for (const Scratch::Event& event : scratch_.cluster) {
        scratch_.heap.push_back(event);
        std::push_heap(scratch_.heap.begin(), scratch_.heap.end());
      }
      return true;
    }
    if (!started_ && !is_at_start()) {
      started_ = true;
      inside_at_start_ = truth_.root();
    }
    truth_.begin_cluster();
    apply_cluster();
    swept_ = end;
    if (started_ && emit_cluster() && !all) return false;
  }
  return true;
}

/// Moves the next events whose error intervals hang together from the heap to scratch.cluster.
/// Events of one leaf alone stay apart. Returns where the cluster ends.
double Sweep::gather_cluster() {
  auto& heap = scratch_.heap;
  auto& cluster = scratch_.cluster;
  cluster.clear();
  double end = -kInfinity;
  bool mixed = false;
  while (!heap.empty()) {
    const Scratch::Event next = heap.front();
    const double error = scratch_.crossings[next.index].error;
    if (!cluster.empty() && next.t - error > end) break;
    mixed = mixed || (!cluster.empty() && next.leaf != cluster.front().leaf);
    std::pop_heap(heap.begin(), heap.end());
    heap.pop_back();
    cluster.push_back(next);
    end = std::max(end, next.t + error);
  }
  while (!mixed && cluster.size() > 1) {
    heap.push_back(cluster.back());
    std::push_heap(heap.begin(), heap.end());
    cluster.pop_back();
    end = cluster.front().t;
  }
  return end;
}

/// Whether the cluster cannot be told from the start of the ray.
bool Sweep::is_at_start() const {
  for (const Scratch::Event& event : scratch_.cluster) {
    if (event.t - scratch_.crossings[event.index].error <= range_.min) return true;
  }
  return false;
}

void Sweep::apply_cluster() {
  for (const Scratch::Event& event : scratch_.cluster) {
    if (tree_.leaves[event.leaf].sheet) continue;
    truth_.set_leaf(event.leaf, scratch_.crossings[event.index].entering);
  }
}

/// Appends the events of the cluster that reach the root; true if one of them is visible.
bool Sweep::emit_cluster() {
  auto& cluster = scratch_.cluster;
  const auto visible = [this](const Scratch::Event& event) {
    return scratch_.crossings[event.index].visible && tree_.leaves[event.leaf].drawn;
  };
  // Of the events that pass an operator together, the first in this order stays.
  if (cluster.size() > 1) {
    std::sort(cluster.begin(), cluster.end(), [&](const auto& a, const auto& b) {
      if (visible(a) != visible(b)) return visible(a);
      return a.leaf != b.leaf ? a.leaf < b.leaf : a.index < b.index;
    });
  }
  const auto first = static_cast<std::ptrdiff_t>(scratch_.passed.size());
  bool any_visible = false;
  for (const Scratch::Event& event : cluster) {
    Crossing crossing = scratch_.crossings[event.index];
    crossing.visible = visible(event);
    if (!range_.surrounds(crossing.t) || !truth_.passes(crossing)) continue;
    scratch_.passed.push_back(crossing);
    any_visible = any_visible || crossing.visible;
  }
  if (cluster.size() > 1) {
    std::stable_sort(scratch_.passed.begin() + first, scratch_.passed.end(),
                     [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
  }
  return any_visible;
}

}  // namespace dioptre::csg
