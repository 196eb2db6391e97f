// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/carving.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dioptre::csg {
namespace {

/// What is known of a place.
enum class Cover { kFree, kCovered, kUnclear };

using Stretch = std::array<Crossing, 2>;

/// The search along one ray that meets the core.
class Carving {
 public:
  /// `ends` are those of the core, then those of the general leaf, then those of the bites near the
  /// place; `window` is the part of the range in the core, and a little more.
  Carving(const Compiled& tree, const Ray& ray, Interval range, Interval window, Crossings& ends)
      : tree_(tree),
        ray_(ray),
        slabs_(ray),
        range_(range),
        window_(window),
        ends_(ends),
        general_(ends.size()) {}

  NearestEnd nearest(Crossing& out) {
    enter_core();
    if (!std::isfinite(at_.t)) return NearestEnd::kUnclear;
    ask_general();
    while (at_.t < core_exit_.t) {
      at_start_ = at_.t == range_.min;
      if (leave_gap()) continue;
      const Cover cover = leave_bites();
      if (cover == Cover::kCovered) continue;
      if (cover == Cover::kUnclear) return NearestEnd::kUnclear;
      if (at_start_) leave_solid();
      return decide(out);
    }
    return stands_alone(ends_, at_) ? NearestEnd::kNone : NearestEnd::kUnclear;
  }

 private:
  bool past(const Crossing& end) const { return end.t - end.error <= range_.min; }

  /// A length of the ray around t well above all errors there.
  double margin(double t) const {
    return kRangeMargin *
           (std::fabs(t) + max_component(abs(ray_.origin)) / max_component(abs(ray_.direction)));
  }

  /// Begins where the ray enters the core, or at the start of the range if that is inside.
  void enter_core() {
    for (const Crossing& end : ends_) {
      if (!std::isfinite(end.t)) continue;
      if (!end.entering) {
        if (end.t < core_exit_.t) core_exit_ = end;
      } else if (!past(end) && end.t > at_.t) {
        at_ = end;
      }
    }
  }

  /// Appends the crossings of the general leaf, if there is one.
  void ask_general() {
    if (tree_.general != kNone) {
      const auto leaf = static_cast<std::uint32_t>(tree_.general);
      double entry = 0;
      begins_in_gap_ = slabs_.meets(tree_.leaves[leaf].interest, window_, entry)
                           ? !tree_.placed[leaf].crossings(ray_, window_, leaf, ends_)
                           : !tree_.leaves[leaf].outside;
    }
    bites_ = ends_.size();
  }

  /// Whether the place lies behind an end, or at it.
  bool behind(const Crossing& end) const { return at_start_ ? past(end) : end.t <= at_.t; }

  /// Moves on to where the general leaf begins, or beyond everything, if the place is outside of
  /// it.
  bool leave_gap() {
    bool in_gap = begins_in_gap_;
    std::size_t i = general_;
    for (; i < bites_ && behind(ends_[i]); ++i) in_gap = !ends_[i].entering;
    if (in_gap) at_ = i < bites_ ? ends_[i] : Crossing{.t = kInfinity};
    return in_gap;
  }

  /// Appends the ends of the bites whose box the ray meets in the window, and calls
  /// `visitor(ends of one bite, window)`, which may cut the window short.
  template <class Visitor>
  void for_each_bite(Interval window, Visitor&& visitor) {
    ends_.resize(bites_);
    const auto meet = [&](std::uint32_t leaf, Interval& left) {
      Stretch bite;
      if (static_cast<std::int32_t>(leaf) == tree_.general) return;
      if (!tree_.placed[leaf].stretch(ray_, leaf, bite)) return;
      ends_.insert(ends_.end(), bite.begin(), bite.end());
      visitor(bite, left);
    };
    if (tree_.structure.bounds().empty()) {
      double entry = 0;
      for (const std::uint32_t leaf : tree_.optional) {
        if (slabs_.meets(tree_.leaves[leaf].interest, window, entry)) meet(leaf, window);
      }
    } else {
      tree_.structure.traverse(ray_, window, [&](std::uint32_t item, Interval& left) {
        meet(tree_.optional[item], left);
        return true;
      });
    }
  }

  /// Moves on to where the bites end that cover the place.
  Cover leave_bites() {
    const double t = at_.t, around = margin(t);
    if (!(at_.error < around)) return Cover::kUnclear;
    Cover cover = Cover::kFree;
    for_each_bite({t - around, t + around}, [&](const Stretch& bite, Interval&) {
      const bool covers =
          at_start_ ? past(bite[0]) && !past(bite[1]) : bite[0].t < t && t < bite[1].t;
      if (!covers || (cover == Cover::kCovered && bite[1].t < at_.t)) return;
      at_ = bite[1];
      cover = Cover::kCovered;
    });
    return cover;
  }

  /// From within the solid: moves to where it ends, at a bite or with the core or the general leaf.
  void leave_solid() {
    at_ = core_exit_;
    for (std::size_t i = general_; i < bites_; ++i) {
      if (!past(ends_[i]) && ends_[i].t < at_.t) at_ = ends_[i];
    }
    for_each_bite(window_, [&](const Stretch& bite, Interval& left) {
      if (past(bite[0]) || !(bite[0].t < at_.t)) return;
      at_ = bite[0];
      left.max = std::min(left.max, at_.t + margin(at_.t));
    });
  }

  /// Whether the place counts.
  NearestEnd decide(Crossing& out) const {
    if (!range_.surrounds(at_.t)) return NearestEnd::kNone;
    if (!stands_alone(ends_, at_) || past(at_)) return NearestEnd::kUnclear;
    if (!at_.visible || !tree_.leaves[at_.leaf].drawn) return NearestEnd::kUnclear;
    out = at_;
    return NearestEnd::kFound;
  }

  const Compiled& tree_;
  const Ray& ray_;
  const SlabRay slabs_;
  const Interval range_, window_;
  Crossings& ends_;
  const std::size_t general_;
  std::size_t bites_ = 0;
  bool begins_in_gap_ = false;    ///< the window, outside of the general leaf
  Crossing at_{.t = range_.min};  ///< how far the search has come
  bool at_start_ = true;
  Crossing core_exit_{.t = kInfinity};
};

}  // namespace

NearestEnd carve(const Compiled& tree, Scratch& scratch, const Ray& ray, Interval range,
                 Crossing& out) {
  Crossings& ends = scratch.crossings;
  ends.clear();
  Interval window{range.min, after(range.max)};
  if (!tree.core.meet(tree.placed, ray, window, ends)) return NearestEnd::kNone;
  return Carving(tree, ray, range, window, ends).nearest(out);
}

}  // namespace dioptre::csg
