// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "dioptre/shading/normals/normal_evaluator.h"
#include "dioptre/shading/pigments/pigment_evaluator.h"
#include "dioptre/shading/texture_evaluator.h"

namespace dioptre {

/// What textures are made of.
struct TextureParts {
  const PigmentTable& pigments;
  const NormalTable& normals;
  const std::vector<ImageSampler>& images;
  bool old_opacity = false;  ///< as Settings has it
};

/// A texture made ready. Immutable.
class TextureLook {
 public:
  virtual ~TextureLook() = default;
  /// Appends stacks whose weights sum to `weight`. `normal` is the undisturbed one, a covector of
  /// any length in the space of the lookup; the normals of the layers are such covectors too, and
  /// equal to it where nothing disturbs it.
  virtual void evaluate(const Lookup& at, Vec3 normal, float weight, TextureSample& out) const = 0;
  virtual Color transmittance(const Lookup& at) const = 0;
};

/// All textures of a scene, by id.
class TextureTable {
 public:
  /// Makes all textures of the scene ready. The table must not move afterwards.
  void compile(const Scene& scene, const TextureParts& parts, const PatternServices& services);

  /// Appends what a texture is at a point, as stacks whose weights sum to `weight`; nothing for no
  /// texture.
  void append(TextureId id, float weight, const TexturePoint& point, TextureSample& out) const;
  /// The share of light that passes; white for no texture.
  Color transmittance(TextureId id, const TexturePoint& point) const;
  /// True if the texture lets no light through anywhere. May be false where it could be true.
  bool opaque(TextureId id) const { return id.index < opaque_.size() && opaque_[id.index]; }

  /// The same inside another texture, see TextureLook.
  void evaluate(TextureId id, const Lookup& at, Vec3 normal, float weight,
                TextureSample& out) const;
  Color transmittance(TextureId id, const Lookup& at) const;

 private:
  void find_opaque(const Scene& scene, const PigmentTable& pigments);

  std::vector<std::unique_ptr<const TextureLook>> looks_;
  std::vector<bool> opaque_;
};

}  // namespace dioptre
