// SPDX-License-Identifier: Apache-2.0
#include "dioptre/explain/words.h"

#include <fmt/format.h>

namespace dioptre {
namespace {

const char* operation_name(csg::Operation operation) {
  switch (operation) {
    case csg::Operation::kUnion:
      return "union";
    case csg::Operation::kMerge:
      return "merge";
    case csg::Operation::kIntersection:
      return "intersection";
    case csg::Operation::kClip:
      return "clipped_by";
  }
  return "";
}

}  // namespace

const char* kind_name(RayKind kind) {
  switch (kind) {
    case RayKind::kCamera:
      return "eye";
    case RayKind::kReflected:
      return "reflected";
    case RayKind::kTransmitted:
      return "transmitted";
  }
  return "";
}

const char* term_name(LightTerm term) {
  switch (term) {
    case LightTerm::kBackground:
      return "background";
    case LightTerm::kAmbient:
      return "ambient";
    case LightTerm::kDiffuse:
      return "diffuse";
    case LightTerm::kHighlight:
      return "highlight";
  }
  return "";
}

std::string ExplainedScene::name_of(ObjectId id) const {
  const Object& object = at(compiled.scene().objects, id);
  std::string name = std::visit(
      [](const auto& geometry) -> std::string {
        if constexpr (requires { std::visit([](const auto&) {}, geometry); }) {
          return std::visit([](const auto& shape) { return shape.kName; }, geometry);
        } else {
          return geometry.kName;
        }
      },
      object.geometry);
  if (!object.name.empty()) name += " '" + object.name + "'";
  if (id.index >= places.objects.size()) return name;
  const SourcePosition place = places.objects[id.index];
  if (place.line == 0 || place.file >= places.files.size()) return name;
  return fmt::format("{} ({}:{})", name, places.files[place.file], place.line);
}

std::string node_name(const ExplainedScene& scene, const Meeting& meeting, std::size_t node) {
  const csg::NodeStretches& each = meeting.stretches.nodes[node];
  if (!each.is_leaf) return operation_name(each.operation);
  const std::string name =
      each.leaf < meeting.leaves.size() ? scene.name_of(meeting.leaves[each.leaf]) : "primitive";
  return each.complement ? "all but " + name : name;
}

std::string stretches_text(const std::vector<Interval>& stretches) {
  std::string text;
  for (const Interval& each : stretches) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{:.6g} to {}", each.min,
                        each.max < kInfinity ? fmt::format("{:.6g}", each.max) : "infinity");
  }
  return text.empty() ? "nowhere" : text;
}

std::string fate_text(const ExplainedScene& scene, const Meeting& meeting,
                      const csg::EventFate& event) {
  const auto& nodes = meeting.stretches.nodes;
  const std::string what = event.leaf < meeting.leaves.size()
                               ? scene.name_of(meeting.leaves[event.leaf])
                               : std::string("primitive");
  const std::string head = fmt::format("{:.6g}: surface of {}", event.t, what);
  if (event.seen) return head + " stays";
  const csg::NodeStretches& stopper = nodes[event.stopped_at];
  const bool merged = stopper.operation == csg::Operation::kMerge;
  return fmt::format("{} is removed by the {}, being {} {}", head,
                     operation_name(stopper.operation), merged ? "inside" : "outside",
                     node_name(scene, meeting, event.because_of));
}

}  // namespace dioptre
