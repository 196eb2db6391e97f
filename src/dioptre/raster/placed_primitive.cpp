// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/placed_primitive.h"

namespace dioptre {
namespace {

/// Follows the objects of a scene in the order in which they became items.
class Walk {
 public:
  explicit Walk(const RenderScene& scene) : scene_(scene), found_(scene.items().size()) {
    for (const ObjectId root : scene.scene().roots) visit(root, {});
  }
  std::vector<std::optional<PlacedPrimitive>> take() { return std::move(found_); }

 private:
  void visit(ObjectId id, const Affine& to_world) {
    const Object& object = at(scene_.scene().objects, id);
    const Affine own = then(object.transform, to_world);
    const Csg* csg = std::get_if<Csg>(&object.geometry);
    const bool plain = object.clipped_by.empty();
    if (csg && csg->operation == CsgOperation::kUnion && !object.inverse && plain) {
      for (const ObjectId child : csg->children) visit(child, own);
      return;
    }
    const std::size_t index = next_++;
    if (csg || !plain || index >= found_.size()) return;
    // An item tells which object it is: where that is another, its faces are found without it.
    const Item& item = scene_.items()[index];
    if (item.part_count != 1 || scene_.first_part(item).object != id) return;
    found_[index] = PlacedPrimitive{&std::get<ShapeData>(object.geometry), own};
  }

  const RenderScene& scene_;
  std::vector<std::optional<PlacedPrimitive>> found_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<std::optional<PlacedPrimitive>> placed_primitives(const RenderScene& scene) {
  return Walk(scene).take();
}

}  // namespace dioptre
