// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/scene/atmosphere.h"
#include "dioptre/scene/camera.h"
#include "dioptre/scene/function.h"
#include "dioptre/scene/image_source.h"
#include "dioptre/scene/interior.h"
#include "dioptre/scene/light.h"
#include "dioptre/scene/normal.h"
#include "dioptre/scene/object.h"
#include "dioptre/scene/pigment.h"
#include "dioptre/scene/settings.h"
#include "dioptre/scene/texture.h"

namespace dioptre {

/// A scene as plain data: what is there, never how it is evaluated. Copyable, comparable, without
/// pointers into itself; all readers produce it and the compiler consumes it.
struct Scene {
  std::vector<Object> objects;  ///< all, parts of others included; parts come before their wholes
  std::vector<ObjectId> roots;  ///< the objects that stand in the world, in the order of the file
  std::vector<Texture> textures;
  std::vector<Pigment> pigments;
  std::vector<Normal> normals;
  std::vector<Interior> interiors;
  std::vector<Function> functions;
  std::vector<ImageSource> images;
  std::vector<Light> lights;
  TextureId default_texture;  ///< of objects without one
  Camera camera;
  Atmosphere atmosphere;
  Settings settings;
  bool operator==(const Scene&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("objects", self.objects);
    visit("roots", self.roots);
    visit("textures", self.textures);
    visit("pigments", self.pigments);
    visit("normals", self.normals);
    visit("interiors", self.interiors);
    visit("functions", self.functions);
    visit("images", self.images);
    visit("lights", self.lights);
    visit("default_texture", self.default_texture);
    visit("camera", self.camera);
    visit("atmosphere", self.atmosphere);
    visit("settings", self.settings);
  }
};

}  // namespace dioptre
