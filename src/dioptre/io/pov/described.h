// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/scene/scene.h"

namespace dioptre::pov {

/// Light sources, and the object that shows them or stands with them in a union, if any.
struct LightsValue {
  std::vector<Light> lights;
  std::optional<Object> object;
};
/// A material: what an object wears and what is in it.
struct MaterialValue {
  TextureId texture, interior_texture;
  InteriorId interior;
};
struct ColorMapValue {
  std::vector<ColorEntry> entries;
};
struct PigmentMapValue {
  std::vector<PigmentEntry> entries;
};
struct NormalMapValue {
  std::vector<NormalEntry> entries;
};
struct SlopeMapValue {
  std::vector<SlopeEntry> entries;
};
struct TextureMapValue {
  std::vector<TextureEntry> entries;
};
/// A thing that is read and checked but not rendered yet (media, density, ...).
struct UnrenderedValue {
  std::uint16_t keyword = 0;
};

/// Whatever an identifier can stand for beyond numbers and strings. Objects are by value, so that a
/// use can be changed without changing the declaration; they share their parts. Textures, pigments,
/// normals and interiors are in the scene already; a use that changes one appends a copy.
using Described =
    std::variant<Object, LightsValue, TextureId, PigmentId, NormalId, Finish, InteriorId,
                 MaterialValue, Camera, Affine, Fog, Rainbow, SkySphere, ColorMapValue, PigmentMapValue,
                 NormalMapValue, SlopeMapValue, TextureMapValue, UnrenderedValue>;
using DescribedPtr = std::shared_ptr<const Described>;

}  // namespace dioptre::pov
