// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "dioptre/compare/reports.h"

namespace dioptre {
namespace {

/// Times nearer to each other than this are called equal.
constexpr double kSame = 1.05;

std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) out += i + 1 == parts.size() ? " and " : ", ";
    out += parts[i];
  }
  return out;
}

/// All that a ray looks at on the way.
double looks(const RayCost& cost) { return cost.steps + cost.boxes; }

/// What one does less of than the other.
std::string less_work(const RayCost& cost, const RayCost& other) {
  std::vector<std::string> parts;
  if (looks(cost) * kSame < looks(other)) {
    parts.push_back(
        fmt::format("{:.1f} steps and boxes against {:.1f}", looks(cost), looks(other)));
  }
  if (cost.items * kSame < other.items) {
    parts.push_back(fmt::format("{:.2f} items against {:.2f}", cost.items, other.items));
  }
  if (!parts.empty()) return "a ray takes " + joined(parts);
  return "a ray does no less, but each step costs less";
}

/// Why a structure that lists items in cells is slow; empty for no reason of that kind.
std::string weakness_of_cells(double listed, const RayCost& cost, const RayCost& best) {
  if (cost.steps > 3 * cost.boxes) {
    return fmt::format("most of the {:.1f} cells on the way of a ray are empty", cost.steps);
  }
  if (cost.boxes > 4 * std::max(looks(best), 1.0)) {
    return fmt::format("items crowd in few of its cells: a ray tests {:.1f} boxes", cost.boxes);
  }
  if (listed > 2 && cost.boxes > 2 * cost.items) {
    return fmt::format(
        "it lists an item {:.1f} times, and a ray tests {:.1f} boxes for {:.1f} items", listed,
        cost.boxes, cost.items);
  }
  return "";
}

/// Why a structure is slow for a sort of rays, from what it does per ray.
std::string weakness(const Comparison& c, const StructureResult& each, const RayCost& cost,
                     const RayCost& best) {
  const double listed = static_cast<double>(each.size.references) /
                        static_cast<double>(std::max<std::size_t>(c.items, 1));
  if (listed > 1.01) {
    if (std::string reason = weakness_of_cells(listed, cost, best); !reason.empty()) return reason;
  }
  if (cost.items > 1.5 * best.items) {
    return fmt::format("its volumes are loose: a ray tests {:.1f} items against {:.1f}", cost.items,
                       best.items);
  }
  if (looks(cost) > 1.5 * looks(best)) {
    return fmt::format("a ray takes {:.1f} steps and boxes", looks(cost));
  }
  return "a ray takes hardly more steps than with the fastest, but dearer ones";
}

using Ranking = std::vector<const StructureResult*>;

Ranking by_time(const Comparison& c, RaySort sort) {
  const auto index = static_cast<std::size_t>(sort);
  Ranking all;
  for (const StructureResult& each : c.structures) all.push_back(&each);
  std::stable_sort(all.begin(), all.end(), [index](const auto* a, const auto* b) {
    return a->cost[index].nanoseconds < b->cost[index].nanoseconds;
  });
  return all;
}

std::string about(const Comparison& c, RaySort sort) {
  const auto index = static_cast<std::size_t>(sort);
  const Ranking all = by_time(c, sort);
  const auto cost = [index](const StructureResult* each) { return each->cost[index]; };
  std::string out = fmt::format("For {} rays {} is the fastest ({:.0f} ns)", name_of(sort),
                                all[0]->name, cost(all[0]).nanoseconds);
  if (all.size() < 2) return out + ".";
  const double ahead = cost(all[1]).nanoseconds / cost(all[0]).nanoseconds;
  if (ahead < kSame) {
    out += fmt::format(", with {} as good as equal.", all[1]->name);
  } else {
    out += fmt::format(", {:.2f} times as fast as {}: {}.", ahead, all[1]->name,
                       less_work(cost(all[0]), cost(all[1])));
  }
  // What has no structure is no surprise; the slowest of the others may be.
  const auto last =
      std::find_if(all.rbegin(), all.rend(), [](const auto* each) { return each->name != "none"; });
  if (last == all.rend() || *last == all[0] || *last == all[1]) return out;
  return out + fmt::format(" The slowest structure is {} ({:.0f} ns): {}.", (*last)->name,
                           cost(*last).nanoseconds, weakness(c, **last, cost(*last), cost(all[0])));
}

std::string about_equality(const Comparison& c) {
  if (c.structures.size() < 2) return "There is one structure, and so nothing to be equal to.";
  std::vector<std::string> images, answers;
  for (const StructureResult& each : c.structures) {
    if (!each.same_image) images.push_back(each.name);
    if (!each.same_answers) answers.push_back(each.name);
  }
  const std::string& first = c.structures.front().name;
  if (images.empty() && answers.empty()) {
    return fmt::format("All {} images are equal, bit by bit.", c.structures.size());
  }
  std::string out;
  if (!images.empty()) {
    out += fmt::format("The image of {} DIFFERS from that of {}.", joined(images), first);
  }
  if (!answers.empty()) {
    out += fmt::format("{}{} does NOT find the same hits as {}.", out.empty() ? "" : " ",
                       joined(answers), first);
  }
  return out;
}

std::string about_none(const Comparison& c) {
  std::vector<std::string> no_better;
  double least = kInfinity, most = 0;
  for (const StructureResult& each : c.structures) {
    const auto speed = c.speed(each);
    if (!speed || each.name == "none") continue;
    if (*speed < kSame) no_better.push_back(each.name);
    least = std::min(least, *speed), most = std::max(most, *speed);
  }
  if (most == 0) return "";
  if (most < kSame) {
    return fmt::format(
        "Over all rays no structure beats none: {} items are too few to save more than the walk "
        "costs.",
        c.items);
  }
  if (no_better.empty()) {
    return fmt::format("Over all rays none loses to every structure, by {:.1f} to {:.1f} times.",
                       least, most);
  }
  return fmt::format(
      "Over all rays none is about as fast as {}, or faster; the others gain up to {:.1f} times.",
      joined(no_better), most);
}

}  // namespace

std::vector<std::string> in_words(const Comparison& c) {
  std::vector<std::string> out{about_equality(c)};
  for (const RaySort sort : kAllRaySorts) {
    if (c.has(sort)) out.push_back(about(c, sort));
  }
  if (std::string none = about_none(c); !none.empty()) out.push_back(std::move(none));
  return out;
}

}  // namespace dioptre
