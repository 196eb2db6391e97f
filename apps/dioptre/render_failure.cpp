// SPDX-License-Identifier: Apache-2.0
#include "render_failure.h"

#include <variant>

#include "commands.h"
#include "dioptre/render/solid_builder.h"

namespace dioptre::app {
namespace {

/// The first primitive that cannot be prepared for this reason, or else the first whole that cannot
/// be built; none if there is no such.
ObjectId culprit(const Scene& scene, const std::string& message) {
  const auto textures = TextureEvaluator::compile(scene, nullptr);
  if (!textures) return {};
  PreparedShapes shapes(scene, (*textures)->fields());
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    if (!std::holds_alternative<ShapeData>(scene.objects[i].geometry)) continue;
    const auto shape = shapes.shape(ObjectId{i});
    if (!shape && shape.error().message == message) return ObjectId{i};
  }
  for (const ObjectId root : scene.roots) {
    const auto solid = build_solid(scene, shapes, root, {});
    if (!solid && solid.error().message == message) return root;
  }
  return {};
}

}  // namespace

int report_render_failure(const LoadedScene& loaded, const std::string& message) {
  const ObjectId object = culprit(loaded.scene, message);
  if (!object) return report_error(message);
  print_message(about_object(loaded, object, message));
  return kFailure;
}

}  // namespace dioptre::app
