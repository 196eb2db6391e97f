// SPDX-License-Identifier: Apache-2.0
#include "dioptre/render/scene_queries.h"

#include <memory>
#include <unordered_map>

#include "dioptre/render/solid_builder.h"

namespace dioptre {
namespace {

class RendererQueries final : public SceneQueries {
 public:
  std::optional<Hit> trace(const Scene& scene, ObjectId object, const Ray& towards) override {
    const Shape* shape = solid(scene, object);
    const Ray ray{towards.origin, normalize(towards.direction)};
    Crossing crossing;
    if (!shape || !shape->nearest(ray, {kNearest, kInfinity}, crossing)) return std::nullopt;
    const Surface surface = shape->surface(ray, crossing);
    const double facing = dot(surface.shading_normal, ray.direction);
    return Hit{surface.position, facing > 0 ? -surface.shading_normal : surface.shading_normal};
  }

  bool inside(const Scene& scene, ObjectId object, Vec3 point) override {
    const Shape* shape = solid(scene, object);
    return shape && shape->contains(point);
  }

  Bounds extent(const Scene& scene, ObjectId object) override {
    const Shape* shape = solid(scene, object);
    return shape ? shape->bounds() : Bounds{};
  }

  double call(const Scene& scene, FunctionId function, std::span<const double> arguments) override {
    const auto evaluator = textures(scene);
    return evaluator ? evaluator->call(function, arguments) : 0;
  }

  PigmentColor pigment(const Scene& scene, PigmentId pigment, Vec3 point) override {
    const auto evaluator = textures(scene);
    return evaluator ? evaluator->pigment(pigment, point) : PigmentColor{};
  }

 private:
  /// A ray that starts on a surface does not meet it again.
  static constexpr double kNearest = 1e-10;

  struct Prepared {
    std::vector<ShapePtr> primitives;
    ShapePtr shape;
    std::shared_ptr<const TextureEvaluator> functions;  ///< if the shape is made of them
  };

  /// Asks for the functions of the scene when a shape is the first to be made of one.
  class LateFields final : public ScalarFields {
   public:
    LateFields(RendererQueries& queries, const Scene& scene, Prepared& user)
        : queries_(queries), scene_(scene), user_(user) {}
    std::unique_ptr<const ScalarField> field(FunctionId function) const override {
      if (!user_.functions) user_.functions = queries_.textures(scene_);
      return user_.functions ? user_.functions->fields().field(function) : nullptr;
    }

   private:
    RendererQueries& queries_;
    const Scene& scene_;
    Prepared& user_;
  };

  const Shape* solid(const Scene& scene, ObjectId object) {
    const auto [place, is_new] = solids_.try_emplace(object.index);
    Prepared& prepared = place->second;
    if (is_new) {
      const LateFields fields(*this, scene, prepared);
      PreparedShapes shapes(scene, fields);
      if (auto built = build_solid(scene, shapes, object, {})) {
        prepared.primitives = shapes.take();
        prepared.shape = std::move(built->shape);
      }
    }
    return prepared.shape.get();
  }

  /// Compiled anew when the scene has grown since; what was asked about before has not changed.
  const std::shared_ptr<const TextureEvaluator>& textures(const Scene& scene) {
    const std::size_t size = scene.functions.size() + scene.pigments.size();
    if (!textures_ || size != textures_size_) {
      auto compiled = TextureEvaluator::compile(
          scene, [this, &scene](ObjectId id, Vec3 p) { return inside(scene, id, p); });
      textures_ = compiled ? std::move(*compiled) : nullptr;
      textures_size_ = size;
    }
    return textures_;
  }

  std::unordered_map<std::uint32_t, Prepared> solids_;
  std::shared_ptr<const TextureEvaluator> textures_;
  std::size_t textures_size_ = 0;
};

}  // namespace

std::unique_ptr<SceneQueries> make_scene_queries() { return std::make_unique<RendererQueries>(); }

}  // namespace dioptre
