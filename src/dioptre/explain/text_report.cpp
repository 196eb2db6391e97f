// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "dioptre/explain/reports.h"
#include "dioptre/explain/words.h"
#include "dioptre/shading/fresnel.h"

namespace dioptre {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
/// Of the primitives of a large solid only those that the ray meets are told of.
constexpr std::size_t kMostNodes = 12;

std::string vector_text(Vec3 v) { return fmt::format("<{:.5g}, {:.5g}, {:.5g}>", v.x, v.y, v.z); }
std::string light_text(Vec3 v) { return fmt::format("{:.4f} {:.4f} {:.4f}", v.x, v.y, v.z); }

Vec3 to_vec(Color c) { return {c.r, c.g, c.b}; }

/// Writes one tree, line by line.
class Writer {
 public:
  Writer(const ExplainedScene& scene, const RayTree& tree) : scene_(scene), tree_(tree) {}

  std::string write() {
    out_ = fmt::format("{}, pixel {},{} of {} x {}: {}\n", scene_.title, tree_.column, tree_.row,
                       tree_.width, tree_.height, light_text(to_vec(tree_.value)));
    ray(0, 0);
    const double gap = tree_.gap();
    line(0, fmt::format(
                "The contributions sum to {}: {}.", light_text(tree_.rays[0].light),
                gap <= kLargestGap ? "the value of the pixel" : fmt::format("off by {:.2g}", gap)));
    return std::move(out_);
  }

 private:
  void line(int depth, const std::string& text) {
    out_.append(static_cast<std::size_t>(2 * depth), ' ').append(text).append("\n");
  }

  void ray(std::size_t index, int depth) {
    const TreeRay& ray = tree_.rays[index];
    const RayStart& start = ray.start;
    std::string head = fmt::format("{} ray", kind_name(start.kind));
    if (ray.parent >= 0) {
      head += fmt::format(", level {}, counts {}", start.level, light_text(to_vec(start.share)));
    }
    if (start.ior != 1) head += fmt::format(", in a medium of index {:.4g}", start.ior);
    line(depth, fmt::format("{}: brings {}", head, light_text(ray.light)));
    line(depth + 1, fmt::format("from {} towards {}", vector_text(start.ray.origin),
                                vector_text(start.ray.direction)));
    if (ray.meeting) {
      meeting(*ray.meeting, depth + 1);
    } else {
      line(depth + 1, "meets nothing");
    }
    for (const LightSeen& light : ray.lights) seen(light, depth + 1);
    for (const Received& each : ray.received) {
      line(depth + 1, fmt::format("{:<10} {}", term_name(each.term), light_text(each.light)));
    }
    for (const std::uint32_t child : ray.children) {
      bend(ray, tree_.rays[child], depth + 1);
      this->ray(child, depth + 1);
    }
  }

  void meeting(const Meeting& m, int depth) {
    line(depth, fmt::format("meets {} after {:.6g} at {}", scene_.name_of(m.object), m.distance,
                            vector_text(m.position)));
    line(depth + 1,
         fmt::format(
             "normal {}{}, {:.2f} degrees off the ray", vector_text(m.normal),
             m.normal == m.shading_normal ? "" : ", for shading " + vector_text(m.shading_normal),
             m.angle * kDegrees));
    for (const SurfaceLayer& layer : m.layers) {
      line(depth + 1, fmt::format("pigment {}, filter {:.4g}, transmit {:.4g}",
                                  light_text(to_vec(layer.pigment.color)), layer.pigment.filter,
                                  layer.pigment.transmit));
    }
    if (m.stretches.nodes.size() > 1) stretches(m, depth + 1);
  }

  void stretches(const Meeting& m, int depth) {
    const auto& nodes = m.stretches.nodes;
    line(depth, "the ray in the solid, by operators:");
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes.size() > kMostNodes && nodes[i].inside.empty()) {
        ++left_out;
        continue;
      }
      line(depth + 1 + level_of(m, i),
           fmt::format("{}: {}", node_name(scene_, m, i), stretches_text(nodes[i].inside)));
    }
    if (left_out > 0) line(depth + 1, fmt::format("and {} that it is not inside of", left_out));
    for (const csg::EventFate& event : m.stretches.events) {
      line(depth + 1, fate_text(scene_, m, event));
    }
  }

  static int level_of(const Meeting& m, std::size_t node) {
    int level = 0;
    for (auto parent = m.stretches.nodes[node].parent; parent >= 0; ++level) {
      parent = m.stretches.nodes[static_cast<std::size_t>(parent)].parent;
    }
    return level;
  }

  void seen(const LightSeen& light, int depth) {
    std::string text = fmt::format("light {}: ", light.light + 1);
    if (light.rays > 1) text += fmt::format("{} of {} rays blocked, ", light.blocked, light.rays);
    text += light.blocked == light.rays ? "hidden"
                                        : fmt::format("{} arrives", light_text(light.visible));
    if (light.blocker) text += fmt::format(", by {}", scene_.name_of(*light.blocker));
    line(depth, text);
  }

  /// The laws of Snell and Fresnel for a ray that goes on from a surface.
  void bend(const TreeRay& from, const TreeRay& to, int depth) {
    if (!from.meeting || to.start.kind != RayKind::kTransmitted) return;
    const double before = from.start.ior, behind = to.start.ior;
    const double a = from.meeting->angle;
    if (before == behind) return;
    const double cosine = std::fabs(dot(to.start.ray.direction, from.meeting->shading_normal));
    const double b = std::acos(std::min(1.0, cosine));
    line(depth, fmt::format("Snell: {:.4g} sin {:.2f} = {:.4g} sin {:.2f}; Fresnel: {:.4f} of the "
                            "light would be mirrored",
                            before, a * kDegrees, behind, b * kDegrees,
                            fresnel_reflectance(std::cos(a), behind / before)));
  }

  const ExplainedScene& scene_;
  const RayTree& tree_;
  std::string out_;
};

}  // namespace

std::string text_report(const ExplainedScene& scene, const RayTree& tree) {
  return Writer(scene, tree).write();
}

}  // namespace dioptre
