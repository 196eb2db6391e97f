// SPDX-License-Identifier: Apache-2.0
#include "dioptre/render/solid_builder.h"

namespace dioptre {
namespace {

/// Walks an object and collects the leaves and nodes of its CSG tree.
class SolidBuilder {
 public:
  SolidBuilder(const Scene& scene, PreparedShapes& shapes) : scene_(scene), shapes_(shapes) {}

  /// Adds the object and returns its entry (see csg::Node::children).
  Result<std::int32_t> add(ObjectId id, const Inherited& from, bool complement) {
    const Object& object = at(scene_.objects, id);
    const Inherited own = shapes_.inherit(from, object);
    const bool inverted = complement != object.inverse;
    auto entry = std::holds_alternative<Csg>(object.geometry)
                     ? add_csg(std::get<Csg>(object.geometry), own, inverted)
                     : add_leaf(id, own, inverted);
    if (!entry || object.clipped_by.empty()) return entry;
    return add_clip(*entry, object, from, complement);
  }

  csg::Description description;
  std::vector<Part> parts;
  std::vector<PartTextures> textures;

 private:
  Result<std::int32_t> add_leaf(ObjectId id, const Inherited& own, bool complement) {
    auto leaf = place(id, own.to_world);
    if (!leaf) return tl::unexpected(leaf.error());
    leaf->complement = complement;
    description.leaves.push_back(*leaf);
    parts.push_back({.object = id,
                     .texture = own.texture,
                     .interior_texture = own.interior_texture,
                     .interior = own.interior,
                     .medium = own.medium,
                     .has_part_textures = !at(scene_.objects, id).part_textures.empty(),
                     .uv_mapping = own.uv_mapping,
                     .double_illuminate = own.double_illuminate,
                     .light_group = own.light_group,
                     .global_lights = own.global_lights});
    textures.push_back({own.texture_to_world, own.to_world});
    return ~static_cast<std::int32_t>(description.leaves.size() - 1);
  }

  Result<csg::Leaf> place(ObjectId id, const Affine& to_world) {
    const auto& geometry = std::get<ShapeData>(at(scene_.objects, id).geometry);
    const auto* patch = std::get_if<BicubicPatch>(&geometry);
    auto shape = patch ? shapes_.patch(*patch, to_world) : shapes_.shape(id);
    if (!shape) return tl::unexpected(shape.error());
    if (patch) return csg::Leaf{*shape, {}};
    const auto to_object = inverse(to_world);
    if (!to_object) return fail("an object is flattened by a singular transform");
    return csg::Leaf{*shape, {to_world, *to_object}};
  }

  Result<std::int32_t> add_csg(const Csg& csg, const Inherited& own, bool complement) {
    csg::Node node{operation(csg.operation, complement), {}};
    node.children.reserve(csg.children.size());
    bool first = true;
    for (const ObjectId child : csg.children) {
      const bool subtract = csg.operation == CsgOperation::kDifference && !first;
      first = false;
      auto entry = add(child, own, complement != subtract);
      if (!entry) return entry;
      node.children.push_back(*entry);
    }
    return add_node(std::move(node));
  }

  Result<std::int32_t> add_clip(std::int32_t entry, const Object& object, const Inherited& from,
                                bool complement) {
    // The complement of a clipped solid is what is outside it or outside a clip.
    csg::Node node{complement ? csg::Operation::kMerge : csg::Operation::kClip, {entry}};
    for (const ObjectId clip : object.clipped_by) {
      auto child = add(clip, from, complement);
      if (!child) return child;
      node.children.push_back(*child);
    }
    return add_node(std::move(node));
  }

  std::int32_t add_node(csg::Node node) {
    description.nodes.push_back(std::move(node));
    return static_cast<std::int32_t>(description.nodes.size() - 1);
  }

  /// De Morgan: the complement of a union is the intersection of the complements.
  static csg::Operation operation(CsgOperation operation, bool complement) {
    switch (operation) {
      case CsgOperation::kUnion:
        return complement ? csg::Operation::kIntersection : csg::Operation::kUnion;
      case CsgOperation::kMerge:
        return complement ? csg::Operation::kIntersection : csg::Operation::kMerge;
      case CsgOperation::kIntersection:
      case CsgOperation::kDifference:
        return complement ? csg::Operation::kMerge : csg::Operation::kIntersection;
    }
    return csg::Operation::kUnion;
  }

  const Scene& scene_;
  PreparedShapes& shapes_;
};

}  // namespace

Inherited PreparedShapes::inherit(const Inherited& from, const Object& object) {
  Inherited own = from;
  own.to_world = then(object.transform, from.to_world);
  if (object.texture) {
    own.texture = own.interior_texture = object.texture;
    own.texture_to_world = then(object.texture_transform, from.to_world);
  }
  if (object.interior_texture) own.interior_texture = object.interior_texture;
  if (object.interior) {
    own.interior = object.interior;
    own.medium = ++media_;
  }
  if (object.has_hollow) own.hollow = object.hollow;
  own.no_shadow = from.no_shadow || object.no_shadow;
  own.no_image = from.no_image || object.no_image;
  own.no_reflection = from.no_reflection || object.no_reflection;
  own.double_illuminate = from.double_illuminate || object.double_illuminate;
  own.uv_mapping = from.uv_mapping || object.uv_mapping;
  own.light_group = object.light_group ? object.light_group : from.light_group;
  own.global_lights = object.light_group ? object.global_lights : from.global_lights;
  return own;
}

Result<const Shape*> PreparedShapes::shape(ObjectId id) {
  if (by_object_.size() < scene_.objects.size()) by_object_.resize(scene_.objects.size());
  const Shape*& known = by_object_[id.index];
  if (!known) {
    auto prepared =
        prepare_with({accelerator_, fields_}, std::get<ShapeData>(at(scene_.objects, id).geometry));
    if (!prepared) return tl::unexpected(prepared.error());
    known = prepared->get();
    shapes_.push_back(std::move(*prepared));
  }
  return known;
}

Result<const Shape*> PreparedShapes::patch(const BicubicPatch& patch, const Affine& to_world) {
  auto prepared = prepare(transformed(patch, to_world), {accelerator_});
  if (!prepared) return tl::unexpected(prepared.error());
  shapes_.push_back(std::move(*prepared));
  return shapes_.back().get();
}

Result<Solid> build_solid(const Scene& scene, PreparedShapes& shapes, ObjectId id,
                          const Inherited& from) {
  SolidBuilder builder(scene, shapes);
  auto root = builder.add(id, from, false);
  if (!root) return tl::unexpected(root.error());
  builder.description.root = *root;
  return Solid{csg::build(std::move(builder.description), shapes.accelerator()),
               std::move(builder.parts), std::move(builder.textures)};
}

}  // namespace dioptre
