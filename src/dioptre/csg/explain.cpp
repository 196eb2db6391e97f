// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/explain.h"

#include <algorithm>

#include "dioptre/csg/explainable.h"

namespace dioptre::csg {
namespace {

using Stretches = std::vector<Interval>;

/// Of points this near to each other, relative to their distance, either may count as inside.
constexpr double kNear = 1e-9;

bool holds(const Stretches& inside, double t) {
  return std::any_of(inside.begin(), inside.end(),
                     [t](const Interval& each) { return each.contains(t); });
}

/// Whether t is an end of one of the stretches, but for rounding.
bool ends_at(const Stretches& inside, double t) {
  const double near = kNear * std::max(1.0, std::fabs(t));
  return std::any_of(inside.begin(), inside.end(), [&](const Interval& each) {
    return std::fabs(each.min - t) <= near || std::fabs(each.max - t) <= near;
  });
}

Stretches either(Stretches a, const Stretches& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end(), [](auto& x, auto& y) { return x.min < y.min; });
  Stretches out;
  for (const Interval& each : a) {
    if (out.empty() || each.min > out.back().max) {
      out.push_back(each);
    } else {
      out.back().max = std::max(out.back().max, each.max);
    }
  }
  return out;
}

Stretches both(const Stretches& a, const Stretches& b) {
  Stretches out;
  for (const Interval& x : a) {
    for (const Interval& y : b) {
      const Interval common = intersect(x, y);
      if (common.min < common.max) out.push_back(common);
    }
  }
  return out;
}

bool is_conjunction(Operation operation) {
  return operation == Operation::kIntersection || operation == Operation::kClip;
}

}  // namespace

Stretches stretches_of(const Crossings& crossings, bool inside, Interval range) {
  Stretches out;
  double begin = range.min;
  for (const Crossing& crossing : crossings) {
    if (inside && !crossing.entering) out.push_back({begin, crossing.t});
    if (crossing.entering) begin = crossing.t;
    inside = crossing.entering;
  }
  if (inside) out.push_back({begin, range.max});
  return out;
}

void join_children(RayStretches& tree) {
  std::vector<bool> begun(tree.nodes.size(), false);
  for (std::size_t i = tree.nodes.size(); i-- > 1;) {
    const auto parent = static_cast<std::size_t>(tree.nodes[i].parent);
    NodeStretches& whole = tree.nodes[parent];
    const Stretches& part = tree.nodes[i].inside;
    if (!begun[parent]) {
      whole.inside = part;
      begun[parent] = true;
    } else {
      whole.inside =
          is_conjunction(whole.operation) ? both(whole.inside, part) : either(whole.inside, part);
    }
  }
}

EventFate fate_of(const RayStretches& tree, std::size_t node, const Crossing& crossing) {
  EventFate fate{crossing.t, crossing.leaf, crossing.entering, true};
  for (auto child = node; tree.nodes[child].parent >= 0;) {
    const auto parent = static_cast<std::size_t>(tree.nodes[child].parent);
    const Operation operation = tree.nodes[parent].operation;
    // A union shows the surfaces within it; the others only where they bound the whole.
    const bool hides =
        operation != Operation::kUnion && !ends_at(tree.nodes[parent].inside, fate.t);
    for (std::size_t i = parent + 1; hides && i < tree.nodes.size(); ++i) {
      if (tree.nodes[i].parent != static_cast<std::int32_t>(parent) || i == child) continue;
      if (holds(tree.nodes[i].inside, fate.t) == is_conjunction(operation)) continue;
      fate.seen = false;
      fate.stopped_at = static_cast<std::uint32_t>(parent);
      fate.because_of = static_cast<std::uint32_t>(i);
      return fate;
    }
    child = parent;
  }
  return fate;
}

RayStretches explain(const Shape& shape, const Ray& ray, Interval range) {
  const auto* const tree = dynamic_cast<const Explainable*>(&shape);
  return tree ? tree->explain(ray, range) : RayStretches{};
}

}  // namespace dioptre::csg
