// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "dioptre/render/solid_builder.h"
#include "dioptre/scene/all_patterns.h"

namespace dioptre {
namespace {

/// True if the children of an object can stand in the scene on their own: a union keeps all
/// surfaces of its children, so nothing is lost.
bool splits(const Object& object) {
  const Csg* csg = std::get_if<Csg>(&object.geometry);
  return csg && csg->operation == CsgOperation::kUnion && !object.inverse &&
         object.clipped_by.empty();
}

}  // namespace

/// Turns the description into items, parts and structures.
class Compiler {
 public:
  Compiler(const Scene& scene, const CompileOptions& options, RenderScene& out)
      : scene_(scene),
        out_(out),
        shapes_(scene, out.textures_->fields(), options.accelerator),
        needs_(texture_needs(scene)) {}

  Result<void> add_all() {
    Inherited world;
    world.texture = world.interior_texture = scene_.default_texture;
    for (const ObjectId root : scene_.roots) {
      if (auto added = add(root, world); !added) return added;
    }
    if (auto added = add_windows(); !added) return added;
    out_.shapes_ = shapes_.take();
    return {};
  }

  Result<void> finish(const CompileOptions& options) {
    for (Item& item : out_.items_) {
      for (std::uint32_t p = 0; p < item.part_count; ++p) {
        item.opaque = item.opaque && opaque(out_.parts_[item.first_part + p]);
      }
    }
    std::vector<Bounds> boxes;
    boxes.reserve(out_.items_.size());
    Bounds finite;
    for (const Item& item : out_.items_) {
      boxes.push_back(item.shape->bounds());
      if (boxes.back().finite()) finite = unite(finite, boxes.back());
    }
    if (!finite.empty() && finite.finite()) {
      out_.shadow_gap_ = kShadowGap * std::min(1.0, max_component(finite.extent()));
    }
    auto accelerator = make_accelerator(options.accelerator, boxes, {scene_.camera.location});
    if (!accelerator) return tl::unexpected(accelerator.error());
    out_.accelerator_ = std::move(*accelerator);
    return {};
  }

 private:
  Result<void> add(ObjectId id, const Inherited& from) {
    const Object& object = at(scene_.objects, id);
    if (splits(object)) {
      const Inherited own = shapes_.inherit(from, object);
      for (const ObjectId child : std::get<Csg>(object.geometry).children) {
        if (auto added = add(child, own); !added) return added;
      }
      return {};
    }
    auto solid = build_solid(scene_, shapes_, id, from);
    if (!solid) return tl::unexpected(solid.error());
    const Inherited own = shapes_.inherit(from, object);
    Item item;
    item.shape = std::move(solid->shape);
    item.first_part = static_cast<std::uint32_t>(out_.parts_.size());
    item.part_count = static_cast<std::uint32_t>(solid->parts.size());
    item.hollow = own.hollow;
    item.no_shadow = own.no_shadow;
    item.no_image = own.no_image;
    item.no_reflection = own.no_reflection;
    for (std::size_t i = 0; i < solid->parts.size(); ++i) {
      Part part = solid->parts[i];
      auto index = placement(solid->textures[i].whole);
      if (!index) return tl::unexpected(index.error());
      part.placement = *index;
      if (part.has_part_textures) {
        auto own = placement(solid->textures[i].own);
        if (!own) return tl::unexpected(own.error());
        part.part_placement = *own;
      }
      part.needs = needs(part);
      out_.parts_.push_back(part);
    }
    out_.items_.push_back(std::move(item));
    return {};
  }

  Result<void> add_windows() {
    for (const Light& light : scene_.lights) {
      out_.windows_.emplace_back();
      if (!light.projected_through) continue;
      auto solid = build_solid(scene_, shapes_, light.projected_through, {});
      if (!solid) return tl::unexpected(solid.error());
      out_.windows_.back() = std::move(solid->shape);
    }
    return {};
  }

  /// Neighbours in the file mostly share the placement of their texture, so looking at the last one
  /// is enough to keep the list short.
  Result<std::uint32_t> placement(const Affine& to_world) {
    auto& all = out_.placements_;
    if (all.empty() || !(all.back().to_world == to_world)) {
      const auto to_object = inverse(to_world);
      if (!to_object) return fail("a texture is flattened by a singular transform");
      all.push_back({to_world, *to_object, !(to_world == Affine{})});
    }
    return static_cast<std::uint32_t>(all.size() - 1);
  }

  TextureNeeds needs(const Part& part) const {
    TextureNeeds all{.uv = part.uv_mapping};
    const auto add = [&](TextureId id) {
      all.uv = all.uv || needs_[id.index].uv;
      all.surface = all.surface || needs_[id.index].surface;
    };
    add(part.texture);
    add(part.interior_texture);
    for (const TextureId id : at(scene_.objects, part.object).part_textures) add(id);
    return all;
  }

  bool opaque(const Part& part) const {
    const auto lets_nothing_through = [&](TextureId id) { return out_.textures_->opaque(id); };
    const Object& object = at(scene_.objects, part.object);
    for (const TextureId id : object.part_textures) {
      if (!lets_nothing_through(id)) return false;
    }
    return lets_nothing_through(part.texture) && lets_nothing_through(part.interior_texture);
  }

  const Scene& scene_;
  RenderScene& out_;
  PreparedShapes shapes_;
  std::vector<TextureNeeds> needs_;  ///< by texture
};

namespace {

/// The solids that `object` patterns ask about. Textures and functions hold their test, and they
/// may be made of functions themselves: so it is filled when those are there.
struct PatternSolids {
  std::vector<ShapePtr> primitives;
  std::map<ObjectId, Solid> solids;

  bool contains(ObjectId id, Vec3 p) const {
    const auto found = solids.find(id);
    return found != solids.end() && found->second.shape->contains(p);
  }

  Result<void> build(const Scene& scene, const ScalarFields& fields) {
    PreparedShapes shapes(scene, fields);
    for (const Pattern* pattern : all_patterns(scene)) {
      const auto* data = std::get_if<ObjectPattern>(&pattern->data);
      if (!data || solids.contains(data->object)) continue;
      auto solid = build_solid(scene, shapes, data->object, {});
      if (!solid) return tl::unexpected(solid.error());
      solids.emplace(data->object, std::move(*solid));
    }
    primitives = shapes.take();
    return {};
  }
};

}  // namespace

Result<std::unique_ptr<const RenderScene>> RenderScene::compile(const Scene& scene,
                                                                const CompileOptions& options) {
  std::unique_ptr<RenderScene> out(new RenderScene(scene));
  const auto solids = std::make_shared<PatternSolids>();
  auto textures = TextureEvaluator::compile(
      scene, [solids](ObjectId id, Vec3 p) { return solids->contains(id, p); });
  if (!textures) return tl::unexpected(textures.error());
  out->textures_ = std::move(*textures);
  if (auto built = solids->build(scene, out->textures_->fields()); !built) {
    return tl::unexpected(built.error());
  }
  Compiler compiler(scene, options, *out);
  if (auto added = compiler.add_all(); !added) return tl::unexpected(added.error());
  if (auto done = compiler.finish(options); !done) return tl::unexpected(done.error());
  return out;
}

}  // namespace dioptre
