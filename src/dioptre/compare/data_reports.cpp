// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "dioptre/compare/reports.h"

namespace dioptre {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::string or_nothing(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

Json structure_json(const Comparison& c, const StructureResult& each) {
  Json out{{"name", each.name},
           {"build_seconds", each.build_seconds},
           {"bytes", each.size.bytes},
           {"nodes", each.size.nodes},
           {"references", each.size.references},
           {"trace_seconds", each.trace_seconds},
           {"speed_against_none", or_null(c.speed(each))},
           {"render_seconds", each.render_seconds},
           {"intersection_share", or_null(each.intersection_share)},
           {"same_image", each.same_image},
           {"same_answers", each.same_answers}};
  for (const RaySort sort : kAllRaySorts) {
    if (!c.has(sort)) continue;
    const RayCost& cost = each.cost[static_cast<std::size_t>(sort)];
    out["cost"][name_of(sort)] = {{"steps", cost.steps},
                                  {"boxes", cost.boxes},
                                  {"items", cost.items},
                                  {"nanoseconds", cost.nanoseconds}};
  }
  return out;
}

}  // namespace

std::string csv_report(const Comparison& c) {
  std::string out =
      "structure,items,build_seconds,bytes,nodes,references,trace_seconds,speed_against_none,"
      "render_seconds,intersection_share,same_image,same_answers";
  for (const RaySort sort : kAllRaySorts) {
    out += fmt::format(",{0}_rays,{0}_sampled,{0}_steps,{0}_boxes,{0}_items,{0}_nanoseconds",
                       name_of(sort));
  }
  out += '\n';
  for (const StructureResult& each : c.structures) {
    out += fmt::format("{},{},{:.6g},{},{},{},{:.6g},{},{:.6g},{},{:d},{:d}", each.name, c.items,
                       each.build_seconds, each.size.bytes, each.size.nodes, each.size.references,
                       each.trace_seconds, or_nothing(c.speed(each)), each.render_seconds,
                       or_nothing(each.intersection_share), each.same_image, each.same_answers);
    for (const RaySort sort : kAllRaySorts) {
      const auto index = static_cast<std::size_t>(sort);
      const RayCost& cost = each.cost[index];
      out += fmt::format(",{},{}", c.traced(sort), c.sampled[index]);
      out += c.has(sort) ? fmt::format(",{:.6g},{:.6g},{:.6g},{:.6g}", cost.steps, cost.boxes,
                                       cost.items, cost.nanoseconds)
                         : ",,,,";
    }
    out += '\n';
  }
  return out;
}

std::string json_report(const Comparison& c) {
  Json out{{"title", c.title},
           {"width", c.image.width},
           {"height", c.image.height},
           {"items", c.items},
           {"all_equal", c.all_equal()}};
  for (const RaySort sort : kAllRaySorts) {
    out["rays"][name_of(sort)] = {{"traced", c.traced(sort)},
                                  {"sampled", c.sampled[static_cast<std::size_t>(sort)]}};
  }
  out["structures"] = Json::array();
  for (const StructureResult& each : c.structures) {
    out["structures"].push_back(structure_json(c, each));
  }
  out["words"] = in_words(c);
  // A title need not be UTF-8.
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace dioptre
