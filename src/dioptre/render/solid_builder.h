// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/csg/tree.h"
#include "dioptre/render/render_scene.h"
#include "dioptre/scene/scene.h"

namespace dioptre {

/// What a whole hands down to its parts.
struct Inherited {
  Affine to_world;  ///< the whole's own space to the world
  TextureId texture, interior_texture;
  Affine texture_to_world;
  InteriorId interior;
  std::uint32_t medium = 0;
  bool hollow = false;
  bool no_shadow = false;
  bool no_image = false;
  bool no_reflection = false;
  bool double_illuminate = false;
  bool uv_mapping = false;
  std::uint32_t light_group = 0;
  bool global_lights = true;
};

/// Prepares the primitives of a scene, each once, however often it is used.
class PreparedShapes {
 public:
  /// `fields` are the scene's functions; they must outlive the shapes.
  PreparedShapes(const Scene& scene, const ScalarFields& fields,
                 std::string_view accelerator = "bvh")
      : scene_(scene), fields_(&fields), accelerator_(accelerator) {}
  /// The structure over the parts of one object: triangles of a mesh, primitives of a solid.
  const std::string& accelerator() const { return accelerator_; }
  /// The primitive of an object whose geometry is a ShapeData.
  Result<const Shape*> shape(ObjectId id);
  /// A patch that is prepared in the world, where its flatness is measured (measured).
  Result<const Shape*> patch(const BicubicPatch& patch, const Affine& to_world);
  /// What `object` hands down in its turn. An interior of its own is a medium of its own, even if
  /// another object has the same one (measured).
  Inherited inherit(const Inherited& from, const Object& object);
  /// Moves all shapes out, for a RenderScene to keep.
  std::vector<ShapePtr> take() { return std::move(shapes_); }

 private:
  const Scene& scene_;
  const ScalarFields* fields_;
  std::string accelerator_;
  std::vector<ShapePtr> shapes_;
  std::vector<const Shape*> by_object_;
  std::uint32_t media_ = 0;
};

/// Where the textures of a part lie.
struct PartTextures {
  Affine whole;  ///< of the part's texture, to the world
  Affine own;    ///< of those of the shape's own parts, to the world
};

/// One solid with the look of its parts, in the order of Crossing::leaf.
struct Solid {
  ShapePtr shape;
  std::vector<Part> parts;
  std::vector<PartTextures> textures;  ///< of each part
};

/// Builds the shape of one object with all its parts, placed by `from`.
Result<Solid> build_solid(const Scene& scene, PreparedShapes& shapes, ObjectId id,
                          const Inherited& from);

}  // namespace dioptre
