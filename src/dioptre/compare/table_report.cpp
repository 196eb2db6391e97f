// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "dioptre/compare/reports.h"

namespace dioptre {
namespace {

std::string or_dash(const char* form, const std::optional<double>& value) {
  return value ? fmt::format(fmt::runtime(form), *value) : "-";
}

const char* verdict(const StructureResult& each) {
  if (!each.same_image) return "OTHER";
  return each.same_answers ? "equal" : "HITS";
}

std::string structures_table(const Comparison& c) {
  constexpr const char* kHead = "{:<10} {:>8} {:>8} {:>8} {:>6} {:>7} {:>6} {:>8} {:>5}{}\n";
  std::string out = fmt::format(kHead, "", "build", "memory", "nodes", "listed", "trace", "speed",
                                "render", "inter", " image");
  out += fmt::format(kHead, "", "ms", "KiB", "", "/item", "s", "/none", "s", "sect.", "");
  for (const StructureResult& each : c.structures) {
    const double items = static_cast<double>(std::max<std::size_t>(c.items, 1));
    std::optional<double> percent = each.intersection_share;
    if (percent) *percent *= 100;
    out += fmt::format("{:<10} {:>8.2f} {:>8.1f} {:>8} {:>6.2f} {:>7.3f} {:>6} {:>8.3f} {:>5} {}\n",
                       each.name, 1e3 * each.build_seconds,
                       static_cast<double>(each.size.bytes) / 1024, each.size.nodes,
                       static_cast<double>(each.size.references) / items, each.trace_seconds,
                       or_dash("{:.1f}", c.speed(each)), each.render_seconds,
                       or_dash("{:.0f}%", percent), verdict(each));
  }
  return out;
}

/// Side by side what rays of some sorts cost.
std::string costs_table(const Comparison& c, const std::vector<RaySort>& sorts) {
  std::string titles = fmt::format("{:<10}", ""), names = titles, out;
  for (const RaySort sort : sorts) {
    const std::string title = fmt::format("{} {} rays", c.traced(sort), name_of(sort));
    titles += fmt::format(" | {:<30}", title);
    names += fmt::format(" |{:>7} {:>7} {:>7} {:>7}", "steps", "boxes", "items", "ns");
  }
  for (const StructureResult& each : c.structures) {
    out += fmt::format("{:<10}", each.name);
    for (const RaySort sort : sorts) {
      const RayCost& cost = each.cost[static_cast<std::size_t>(sort)];
      out += fmt::format(" |{:>7.1f} {:>7.1f} {:>7.2f} {:>7.0f}", cost.steps, cost.boxes,
                         cost.items, cost.nanoseconds);
    }
    out += '\n';
  }
  titles.erase(titles.find_last_not_of(' ') + 1);
  return titles + '\n' + names + '\n' + out;
}

/// Breaks a text into lines of at most 80 characters, where words end.
std::string wrapped(std::string_view text) {
  constexpr std::size_t kColumns = 80;
  std::string out;
  while (text.size() > kColumns) {
    std::size_t end = text.rfind(' ', kColumns);
    if (end == std::string_view::npos || end == 0) end = kColumns;
    out.append(text.substr(0, end)).append("\n");
    text.remove_prefix(std::min(text.size(), text[end] == ' ' ? end + 1 : end));
  }
  return out.append(text).append("\n");
}

}  // namespace

std::string table_report(const Comparison& c) {
  std::string out = fmt::format(
      "{}: {} x {} pixels, {} items, {} rays\n"
      "(trace: all rays, one thread; render: all threads, with shading)\n\n",
      c.title, c.image.width, c.image.height, c.items, c.rays.total());
  out += structures_table(c);
  std::vector<RaySort> sorts;
  std::copy_if(kAllRaySorts.begin(), kAllRaySorts.end(), std::back_inserter(sorts),
               [&c](RaySort sort) { return c.has(sort); });
  for (std::size_t i = 0; i < sorts.size(); i += 2) {
    const auto end = std::min(i + 2, sorts.size());
    out += '\n' + costs_table(c, {sorts.begin() + static_cast<std::ptrdiff_t>(i),
                                  sorts.begin() + static_cast<std::ptrdiff_t>(end)});
  }
  out += '\n';
  for (const std::string& sentence : in_words(c)) out += wrapped(sentence);
  return out;
}

}  // namespace dioptre
