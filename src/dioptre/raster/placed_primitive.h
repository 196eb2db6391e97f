// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "dioptre/render/render_scene.h"

namespace dioptre {

/// A primitive that stands in the scene by itself, whole.
struct PlacedPrimitive {
  const ShapeData* shape = nullptr;
  Affine to_world;
};

/// For every item of the scene, in order, the primitive it consists of; nothing for solids made of
/// several, and for what is clipped.
std::vector<std::optional<PlacedPrimitive>> placed_primitives(const RenderScene& scene);

}  // namespace dioptre
