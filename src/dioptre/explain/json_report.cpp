// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "dioptre/explain/words.h"
#include "dioptre/shading/fresnel.h"

namespace dioptre {
namespace {

using Json = nlohmann::ordered_json;

Json of(Vec3 v) { return Json::array({v.x, v.y, v.z}); }
Json of(Color c) { return Json::array({c.r, c.g, c.b}); }
/// Infinite numbers have no place in JSON.
Json of(double v) { return std::isfinite(v) ? Json(v) : Json(); }

Json stretches_json(const std::vector<Interval>& stretches) {
  Json out = Json::array();
  for (const Interval& each : stretches) out.push_back(Json::array({of(each.min), of(each.max)}));
  return out;
}

Json solid_json(const ExplainedScene& scene, const Meeting& m) {
  Json out{{"nodes", Json::array()}, {"events", Json::array()}};
  for (std::size_t i = 0; i < m.stretches.nodes.size(); ++i) {
    const csg::NodeStretches& node = m.stretches.nodes[i];
    out["nodes"].push_back({{"name", node_name(scene, m, i)},
                            {"parent", node.parent},
                            {"inside", stretches_json(node.inside)}});
  }
  for (const csg::EventFate& event : m.stretches.events) {
    Json each{{"t", event.t},
              {"entering", event.entering},
              {"seen", event.seen},
              {"text", fate_text(scene, m, event)}};
    if (!event.seen) each["stopped_at"] = event.stopped_at, each["because_of"] = event.because_of;
    out["events"].push_back(std::move(each));
  }
  return out;
}

Json meeting_json(const ExplainedScene& scene, const Meeting& m) {
  Json out{{"object", scene.name_of(m.object)},
           {"item", m.item},
           {"distance", m.distance},
           {"position", of(m.position)},
           {"normal", of(m.normal)},
           {"shading_normal", of(m.shading_normal)},
           {"angle", m.angle},
           {"layers", Json::array()},
           {"solid", solid_json(scene, m)}};
  for (const SurfaceLayer& layer : m.layers) {
    out["layers"].push_back({{"color", of(layer.pigment.color)},
                             {"filter", layer.pigment.filter},
                             {"transmit", layer.pigment.transmit}});
  }
  return out;
}

/// The figures of a ray that goes through the surface that the one before it met.
void add_refraction(const TreeRay& from, const TreeRay& ray, Json& out) {
  if (ray.start.kind != RayKind::kTransmitted || !from.meeting) return;
  const double cosine = std::fabs(dot(ray.start.ray.direction, from.meeting->shading_normal));
  const double ratio = ray.start.ior / from.start.ior;
  out["refraction"] = {{"angle_before", from.meeting->angle},
                       {"angle_behind", std::acos(std::min(1.0, cosine))},
                       {"index_before", from.start.ior},
                       {"index_behind", ray.start.ior},
                       {"fresnel", fresnel_reflectance(std::cos(from.meeting->angle), ratio)}};
}

Json ray_json(const ExplainedScene& scene, const RayTree& tree, const TreeRay& ray) {
  Json out{{"kind", kind_name(ray.start.kind)},
           {"level", ray.start.level},
           {"parent", ray.parent},
           {"children", ray.children},
           {"origin", of(ray.start.ray.origin)},
           {"direction", of(ray.start.ray.direction)},
           {"share", of(ray.start.share)},
           {"index_of_refraction", ray.start.ior},
           {"light", of(ray.light)},
           {"meeting", ray.meeting ? meeting_json(scene, *ray.meeting) : Json()},
           {"lights", Json::array()},
           {"received", Json::array()}};
  if (ray.parent >= 0) add_refraction(tree.rays[static_cast<std::size_t>(ray.parent)], ray, out);
  for (const LightSeen& light : ray.lights) {
    out["lights"].push_back(
        {{"light", light.light + 1},
         {"position", of(scene.compiled.scene().lights[light.light].location)},
         {"rays", light.rays},
         {"blocked", light.blocked},
         {"visible", of(light.visible)},
         {"blocker", light.blocker ? Json(scene.name_of(*light.blocker)) : Json()}});
  }
  for (const Received& each : ray.received) {
    out["received"].push_back({{"term", term_name(each.term)}, {"light", of(each.light)}});
  }
  return out;
}

}  // namespace

std::string json_report(const ExplainedScene& scene, const RayTree& tree) {
  Json out{{"scene", scene.title},
           {"pixel", {tree.column, tree.row}},
           {"size", {tree.width, tree.height}},
           {"value", of(tree.value)},
           {"gap", tree.gap()},
           {"rays", Json::array()},
           {"boxes", Json::array()}};
  for (const TreeRay& ray : tree.rays) out["rays"].push_back(ray_json(scene, tree, ray));
  for (const Item& item : scene.compiled.items()) {
    const Bounds box = item.shape->bounds();
    if (!box.finite() || box.empty()) continue;
    out["boxes"].push_back({{"name", scene.name_of(scene.compiled.first_part(item).object)},
                            {"min", of(box.min)},
                            {"max", of(box.max)}});
  }
  // Names come from the scene and need not be UTF-8.
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace dioptre
