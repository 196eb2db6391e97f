// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/texture_evaluator.h"

#include "dioptre/shading/functions/function_table.h"
#include "dioptre/shading/normals/normal_evaluator.h"
#include "dioptre/shading/pigments/pigment_evaluator.h"
#include "dioptre/shading/textures/texture_table.h"

namespace dioptre {
namespace {

/// Everything compiled, in one place: the parts refer to one another.
class CompiledTextures final : public TextureEvaluator {
 public:
  CompiledTextures(const Scene& scene, InsideTest inside) {
    PatternServices services;
    services.scene = &scene;
    services.images = &images_;
    services.call = [this](FunctionId id, std::span<const double> a) { return call(id, a); };
    services.pigment = [this](PigmentId id, Vec3 p) { return pigment(id, p); };
    services.inside = std::move(inside);
    images_.reserve(scene.images.size());
    for (const ImageSource& image : scene.images) images_.emplace_back(image);
    pigments_.compile(scene, images_, services);
    normals_.compile(scene, images_, services);
    functions_.compile(scene, pigments_, services);
    textures_.compile(scene, {pigments_, normals_, images_, scene.settings.old_opacity}, services);
  }

  void append(TextureId texture, float weight, const TexturePoint& point,
              TextureSample& out) const override {
    textures_.append(texture, weight, point, out);
  }
  Color transmittance(TextureId texture, const TexturePoint& point) const override {
    return textures_.transmittance(texture, point);
  }
  bool opaque(TextureId texture) const override { return textures_.opaque(texture); }
  PigmentColor pigment(PigmentId pigment, Vec3 point) const override {
    return pigments_.color(pigment, {point, {}, {}});
  }
  Vec3 perturb(NormalId normal, Vec3 position, Vec3 unit_normal) const override {
    return normals_.disturbed(normal, {position, {unit_normal, -unit_normal}, {}}, unit_normal);
  }
  double call(FunctionId function, std::span<const double> arguments) const override {
    return functions_.call(function, arguments);
  }
  const ScalarFields& fields() const override { return functions_; }

 private:
  std::vector<ImageSampler> images_;
  PigmentTable pigments_;
  NormalTable normals_;
  FunctionTable functions_;
  TextureTable textures_;
};

}  // namespace

Result<std::unique_ptr<const TextureEvaluator>> TextureEvaluator::compile(const Scene& scene,
                                                                          InsideTest inside) {
  if (!inside) inside = [](ObjectId, Vec3) { return false; };
  return std::make_unique<const CompiledTextures>(scene, std::move(inside));
}

}  // namespace dioptre
