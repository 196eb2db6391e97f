// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "dioptre/scene/scene.h"

namespace dioptre {

/// A small scene with a name.
struct RasterScene {
  std::string name;
  Scene scene;
};

/// Scenes of all kinds of surfaces: flat and curved, solids and sheets, simple and made of others,
/// bounded or not, in front of the eye or around it.
std::vector<RasterScene> raster_scenes();

/// An object of a shape; the texture is the default one.
Object object_of(ShapeData shape);

/// A scene without objects but with a light and a texture, seen from (0, 1, -6) along +z.
Scene empty_scene();

}  // namespace dioptre
