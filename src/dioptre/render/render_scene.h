// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/core/result.h"
#include "dioptre/geometry/shape.h"
#include "dioptre/scene/id_graph.h"
#include "dioptre/scene/scene.h"
#include "dioptre/shading/texture_evaluator.h"

namespace dioptre {

/// What the surface of one primitive wears, with all that its wholes hand down worked in.
struct Part {
  ObjectId object;              ///< the primitive, for explaining
  TextureId texture;            ///< never none
  TextureId interior_texture;   ///< seen from inside; never none
  InteriorId interior;          ///< may be none
  std::uint32_t medium = 0;     ///< a number for each use of an interior; 0 without one
  std::uint32_t placement = 0;  ///< of the texture, index into RenderScene's placements
  /// Of the textures of the shape's own parts; the same kind of index. 0 without such.
  std::uint32_t part_placement = 0;
  bool has_part_textures = false;
  bool uv_mapping = false;
  TextureNeeds needs;  ///< of both textures
  bool double_illuminate = false;
  std::uint32_t light_group = 0;  ///< 0: none
  bool global_lights = true;      ///< lights of no group shine on it
};

/// Where a texture lies.
struct TexturePlacement {
  Affine to_world, to_object;
  bool moved = false;  ///< not the identity
};

/// What stands in the accelerator on its own: a primitive, or a whole CSG solid.
struct Item {
  ShapePtr shape;                ///< in world space
  std::uint32_t first_part = 0;  ///< Crossing::leaf counts from here
  std::uint32_t part_count = 0;
  bool opaque = true;  ///< no part lets light through
  bool hollow = false;
  bool no_shadow = false;
  bool no_image = false;
  bool no_reflection = false;
};

/// What a ray is for: some objects are hidden from some rays.
enum class RayPurpose : std::uint8_t { kCamera, kReflection, kShadow };

/// The crossing that a ray meets first.
struct Hit {
  Crossing crossing;
  const Item* item = nullptr;
};

/// The surface at a hit, in world space.
struct SurfaceInteraction {
  Surface surface;
  const Part* part = nullptr;
  Vec2 uv;           ///< if the part's textures need it
  double error = 0;  ///< a bound on the distance of surface.position from the true point
};

/// Of surfaces nearer to each other than this along a shadow ray only the first counts; nor does
/// what is nearer to the surface in question or to the light (measured): things that touch, a lamp
/// in its glass or a block on another, shade once. In scene units, but a scene smaller than one
/// unit has a gap as much smaller: see RenderScene::shadow_gap.
constexpr double kShadowGap = 1e-3;

/// Names the structure over the items, over the triangles of a mesh and the many primitives of a
/// solid; "extents" stands for the hierarchy within objects.
struct CompileOptions {
  std::string accelerator = "bvh";
};

/// A scene made ready for rays: immutable, shared by all threads without locks. Refers to the Scene
/// it was compiled from, which must outlive it.
class RenderScene {
 public:
  /// Prepares all shapes, textures and the accelerator. The error names the object at fault.
  static Result<std::unique_ptr<const RenderScene>> compile(const Scene& scene,
                                                            const CompileOptions& options);

  const Scene& scene() const { return scene_; }
  const TextureEvaluator& textures() const { return *textures_; }
  const std::vector<Item>& items() const { return items_; }
  Bounds bounds() const { return accelerator_->bounds(); }
  /// The structure over the boxes of the items.
  const Accelerator& accelerator() const { return *accelerator_; }

  /// The first visible crossing in the range that a ray of this purpose may see.
  bool nearest(const Ray& ray, Interval range, RayPurpose purpose, Hit& hit) const;
  /// The same, and adds up what that costs.
  bool nearest(const Ray& ray, Interval range, RayPurpose purpose, Hit& hit, WalkCost& cost) const;

  SurfaceInteraction interaction(const Ray& ray, const Hit& hit) const;

  /// Finds the surfaces that light meets within the range, in order, into `hits`; of those that
  /// touch (shadow_gap) only the first. False if one belongs to an opaque item: no light comes
  /// through, `hits` is of no use, and `blocker` becomes that item. If `blocker` is one already, it
  /// is looked at first.
  bool shadow_hits(const Ray& ray, Interval range, std::vector<Hit>& hits,
                   const Item*& blocker) const;
  /// The same, and adds up what that costs.
  bool shadow_hits(const Ray& ray, Interval range, std::vector<Hit>& hits, const Item*& blocker,
                   WalkCost& cost) const;

  /// The share of light that gets through such a surface, brightened by `caustics`. What the
  /// insides of solids take is not counted.
  Color surface_transmittance(const Ray& ray, const Hit& hit) const;

  /// The texture of a surface seen along the ray: its layers, with normals in world space. The
  /// normal of the interaction must face the viewer already.
  void evaluate_texture(const SurfaceInteraction& at, const Ray& ray, const Hit& hit,
                        bool from_inside, TextureSample& out) const;

  /// What the surface at a hit wears.
  const Part& part(const Hit& hit) const {
    return parts_[hit.item->first_part + hit.crossing.leaf];
  }

  /// kShadowGap, or that share of the size of all that is finite in the scene if that is smaller.
  double shadow_gap() const { return shadow_gap_; }

  /// What the light of this number in the scene is projected through; null for most lights.
  const Shape* window(std::size_t light) const { return windows_[light].get(); }

  /// The first part of an item, which speaks for what fills it.
  const Part& first_part(const Item& item) const { return parts_[item.first_part]; }

 private:
  friend class Compiler;
  explicit RenderScene(const Scene& scene) : scene_(scene) {}
  float caustic(const SurfaceInteraction& facing, const Ray& ray, const Hit& hit,
                bool leaving) const;
  TexturePoint texture_point(const SurfaceInteraction& at, Vec3 view,
                             const TexturePlacement& placement) const;
  template <class Visitor>
  void for_each_texture(const SurfaceInteraction& at, const Ray& ray, const Hit& hit,
                        bool from_inside, Visitor&& visit) const;
  void append_texture(const SurfaceInteraction& at, Vec3 view, TextureId texture, float share,
                      const TexturePlacement& placement, TextureSample& out) const;

  const Scene& scene_;
  std::vector<ShapePtr> shapes_;
  std::vector<ShapePtr> windows_;  ///< one for each light
  std::vector<Item> items_;
  std::vector<Part> parts_;
  std::vector<TexturePlacement> placements_;
  AcceleratorPtr accelerator_;
  double shadow_gap_ = kShadowGap;
  std::unique_ptr<const TextureEvaluator> textures_;
};

}  // namespace dioptre
