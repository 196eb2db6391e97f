// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "dioptre/core/color.h"
#include "dioptre/core/result.h"
#include "dioptre/core/scalar_field.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/scene.h"

namespace dioptre {

/// Answers whether a point (in the frame of the object's parent) lies inside an object of the
/// scene: the `object` pattern needs it, and only the renderer can tell.
using InsideTest = std::function<bool(ObjectId, Vec3)>;

/// Where a texture is looked up. Position, normal and view direction are in the space in which the
/// texture's own transform places it (Texture::transform and TextureLayer::transform are applied by
/// the evaluator).
struct TexturePoint {
  Vec3 position;
  Vec3 normal;  ///< unit, shading normal, facing the viewer
  Vec3 view;    ///< unit, the direction of the ray that arrives
  Vec2 uv;
};

/// One layer of a texture at one point.
struct SurfaceLayer {
  PigmentColor pigment;
  Vec3 normal;  ///< unit, disturbed, in the space of TexturePoint::normal
  const Finish* finish = nullptr;
  bool old_opacity = false;  ///< as Settings has it

  /// The share of the surface's own light; not clamped.
  float opacity() const {
    const PigmentColor& p = pigment;
    if (!old_opacity) return p.opacity();
    return 1 - p.transmit - p.filter * max_component(p.color);
  }
};

/// What a texture is at a point: stacks of layers with weights that sum to 1 (more than one stack
/// where a texture map or an average mixes textures; each stack is shaded by itself).
struct TextureSample {
  struct Stack {
    float weight = 1;
    std::uint32_t first = 0, count = 0;  ///< range of `layers`, the top layer first
  };
  std::vector<Stack> stacks;
  std::vector<SurfaceLayer> layers;
  void clear() { stacks.clear(), layers.clear(); }
};

/// All textures, pigments, normals and functions of a scene, compiled for evaluation: immutable,
/// shared by all threads, no allocation per call beyond the growth of the sample.
class TextureEvaluator {
 public:
  static Result<std::unique_ptr<const TextureEvaluator>> compile(const Scene& scene,
                                                                 InsideTest inside);
  virtual ~TextureEvaluator() = default;

  /// What a texture is at a point.
  void evaluate(TextureId texture, const TexturePoint& point, TextureSample& out) const {
    out.clear();
    append(texture, 1, point, out);
  }
  /// Appends what a texture is at a point, as stacks whose weights sum to `weight`.
  virtual void append(TextureId texture, float weight, const TexturePoint& point,
                      TextureSample& out) const = 0;
  /// Only the colours, for shadow rays: the share of light that passes through all layers.
  virtual Color transmittance(TextureId texture, const TexturePoint& point) const = 0;
  /// True if the texture lets no light through anywhere.
  virtual bool opaque(TextureId texture) const = 0;
  virtual PigmentColor pigment(PigmentId pigment, Vec3 point) const = 0;
  /// Disturbs a unit normal (the camera's, say) by a normal of the scene.
  virtual Vec3 perturb(NormalId normal, Vec3 position, Vec3 unit_normal) const = 0;
  virtual double call(FunctionId function, std::span<const double> arguments) const = 0;
  /// The functions as fields for shapes.
  virtual const ScalarFields& fields() const = 0;
};

}  // namespace dioptre
