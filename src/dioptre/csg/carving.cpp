// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/carving.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dioptre::csg {
namespace {

/// What bites say of a place.
enum class Cover { kFree, kCovered, kUnclear };

using Stretch = std::array<Crossing, 2>;

/// The search along one ray that meets the core.
class Carving {
 public:
  /// `ends` are those of the core, and later, from `bites_` on, of the bites near the place, too;
  /// `window` is the part of the range in the core, and a little more.
  Carving(const Compiled& tree, const Ray& ray, Interval range, Interval window, Crossings& ends)
      : tree_(tree),
        ray_(ray),
        slabs_(ray),
        range_(range),
        window_(window),
        ends_(ends),
        bites_(ends.size()) {}

  NearestEnd nearest(Crossing& out) {
    enter_core();
    if (!std::isfinite(at_.t)) return NearestEnd::kUnclear;
    while (at_.t < core_exit_.t) {
      const bool at_start = at_.t == range_.min;
      const Cover cover = leave_bites(at_start);
      if (cover == Cover::kCovered) continue;
      if (cover == Cover::kUnclear) return NearestEnd::kUnclear;
      if (at_start) go_to_first_bite();
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

  /// Appends the ends of the bites whose box the ray meets in the window, and calls
  /// `visitor(ends of one bite, window)`, which may cut the window short.
  template <class Visitor>
  void for_each_bite(Interval window, Visitor&& visitor) {
    ends_.resize(bites_);
    const auto meet = [&](std::uint32_t leaf, Interval& left) {
      Stretch bite;
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
  Cover leave_bites(bool at_start) {
    const double t = at_.t, around = margin(t);
    if (!(at_.error < around)) return Cover::kUnclear;
    Cover cover = Cover::kFree;
    for_each_bite({t - around, t + around}, [&](const Stretch& bite, Interval&) {
      const bool covers =
          at_start ? past(bite[0]) && !past(bite[1]) : bite[0].t < t && t < bite[1].t;
      if (!covers || (cover == Cover::kCovered && bite[1].t < at_.t)) return;
      at_ = bite[1];
      cover = Cover::kCovered;
    });
    return cover;
  }

  /// From within the solid: moves to where it ends, at a bite or with the core.
  void go_to_first_bite() {
    at_ = core_exit_;
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
  const std::size_t bites_;
  Crossing at_{.t = range_.min};  ///< how far the search has come
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
