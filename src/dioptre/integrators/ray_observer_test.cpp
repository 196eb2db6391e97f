// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/ray_observer.h"

#include <gtest/gtest.h>

#include <vector>

#include "dioptre/integrators/eye_rays.h"
#include "dioptre/integrators/integrator.h"

namespace dioptre {
namespace {

/// Adds up the light of a ray tree by what RayObserver promises.
class Sum final : public RayObserver {
 public:
  void begin(const RayStart& start) override {
    open_.push_back({start.share, {}});
    ++begun;
  }
  void meet(const Hit& hit, const SurfaceInteraction&, const TextureSample&) override {
    EXPECT_NE(hit.item, nullptr);
  }
  void receive(LightTerm, Color light) override { open_.back().light += light; }
  void shadow(const ShadowRay&) override { ++shadows; }
  void end() override {
    const Color light = open_.back().share * open_.back().light;
    open_.pop_back();
    (open_.empty() ? total : open_.back().light) += light;
  }
  bool all_ended() const { return open_.empty(); }

  Color total;
  std::uint64_t begun = 0, shadows = 0;

 private:
  struct OpenRay {
    Color share, light;
  };
  std::vector<OpenRay> open_;
};

TextureId texture(Scene& scene, PigmentColor color, const Finish& finish) {
  const PigmentId pigment = append(scene.pigments, Pigment{SolidPigment{color}, {}, false});
  return append(scene.textures, Texture{LayeredTexture{{{pigment, {}, finish, {}}}}, {}});
}

/// A ball of tinted glass with a mirror's finish over a shiny floor, in a mist, under two lights.
Scene glass_in_mist() {
  Scene scene;
  scene.default_texture = texture(scene, {{1, 1, 1}}, {});
  scene.camera.location = {0, 1, -5};
  Finish shiny;
  shiny.phong = 0.5;
  shiny.reflection_min = shiny.reflection_max = {0.4f, 0.4f, 0.4f};
  Finish soft = shiny;
  soft.reflection_exponent = 0.5;
  Object ball, floor;
  ball.geometry = Sphere{{0, 1, 0}, 1};
  ball.texture = texture(scene, {{1, 0.3f, 0.2f}, 0.5f, 0.2f}, shiny);
  ball.interior = append(scene.interiors, Interior{.ior = 1.5, .has_ior = true});
  floor.geometry = Plane{{0, 1, 0}, 0};
  floor.texture = texture(scene, {{0.7f, 0.8f, 1}}, soft);
  scene.roots.push_back(append(scene.objects, ball));
  scene.roots.push_back(append(scene.objects, floor));
  scene.lights.push_back({.location = {4, 8, -5}});
  scene.lights.push_back({.location = {-4, 3, -2}});
  scene.atmosphere.background = {0.2f, 0.3f, 0.6f};
  scene.atmosphere.fogs.push_back({.distance = 20, .color = {{0.5f, 0.5f, 0.5f}}});
  return scene;
}

TEST(RayObserver, TheLightOfTheTreeIsThatOfThePixel) {
  const Scene scene = glass_in_mist();
  const auto compiled = RenderScene::compile(scene, {});
  ASSERT_TRUE(compiled);
  const auto eye = EyeRays::prepare(**compiled, 20, 15);
  ASSERT_TRUE(eye);
  for (const std::string_view name : integrator_names()) {
    const auto integrator = make_integrator(name, **compiled, {});
    ASSERT_TRUE(integrator);
    for (int i = 0; i < 300; ++i) {
      const auto ray = eye->ray(i % 20 + 0.5, i / 20 + 0.5);
      Sum sum;
      RayLog unseen, seen{{}, &sum};
      const Color expected = (*integrator)->radiance(*ray, unseen).color;
      EXPECT_EQ((*integrator)->radiance(*ray, seen).color, expected);
      EXPECT_LT(max_component(abs(sum.total - expected)), 1e-6f) << name << ", pixel " << i;
      EXPECT_TRUE(sum.all_ended());
      EXPECT_EQ(sum.begun, seen.counts.total() - seen.counts.shadow);
      EXPECT_EQ(sum.shadows, seen.counts.shadow);
    }
  }
}

}  // namespace
}  // namespace dioptre
