// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/whitted.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dioptre/integrators/render_image.h"

namespace dioptre {
namespace {

/// A scene seen along +z through one pixel; the values expected below are those that POV-Ray prints
/// for the same scene.
class OnePixel {
 public:
  OnePixel() {
    scene.camera.kind = Camera::Kind::kOrthographic;
    scene.camera.location = {0, 0, -5};
    scene.camera.right = {1e-3, 0, 0};
    scene.camera.up = {0, 1e-3, 0};
    scene.default_texture = texture({}, {});
  }

  TextureId texture(PigmentColor color, const Finish& finish) {
    return append(scene.textures, Texture{LayeredTexture{{layer(color, finish)}}, {}});
  }
  TextureLayer layer(PigmentColor color, const Finish& finish) {
    return {append(scene.pigments, Pigment{SolidPigment{color}, {}, false}), {}, finish, {}};
  }
  Object& add(ShapeData shape, PigmentColor color, const Finish& finish) {
    Object object;
    object.geometry = std::move(shape);
    object.texture = texture(color, finish);
    scene.roots.push_back(append(scene.objects, object));
    return scene.objects.back();
  }
  Color render() const {
    const auto result = render_image(scene, {}, {.width = 1, .height = 1}, {});
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? result->image.at(0, 0) : Color{};
  }

  Scene scene;
};

Finish dark() {
  Finish finish;
  finish.ambient = {};
  finish.diffuse = 0;
  return finish;
}
Finish glowing(float amount) {
  Finish finish = dark();
  finish.emission = {amount, amount, amount};
  return finish;
}
PigmentColor clear(float filter, float transmit) { return {{1, 1, 1}, filter, transmit}; }
const Box kUnitBox{{-1, -1, -1}, {1, 1, 1}};

TEST(Whitted, TheDefaultFinishIsAmbientAndDiffuse) {
  OnePixel pixel;
  pixel.add(kUnitBox, {{0.5f, 1, 0.25f}}, Finish{});
  pixel.scene.lights.push_back({.location = {0, 0, -100}});
  const Color c = pixel.render();
  EXPECT_NEAR(c.r, 0.35, 1e-6);
  EXPECT_NEAR(c.g, 0.7, 1e-6);
  EXPECT_NEAR(c.b, 0.175, 1e-6);
}

TEST(Whitted, HighlightsAreNotDimmedByTransparency) {
  for (const auto& [color, expected] :
       {std::pair{clear(0, 0), 0.3}, {clear(1, 0), 0.6}, {clear(0, 0.5), 0.375}}) {
    OnePixel pixel;
    Finish finish = dark();
    finish.specular = 0.3;
    pixel.add(kUnitBox, color, finish);
    pixel.scene.lights.push_back({.location = {0, 0, -100}});
    EXPECT_NEAR(pixel.render().g, expected, 1e-5);
  }
}

TEST(Whitted, FilterTintsTheBackgroundAtEverySurface) {
  OnePixel pixel;
  pixel.add(kUnitBox, {{0.5f, 1, 1}, 0.5f, 0}, dark());
  pixel.scene.atmosphere.background = {0.2f, 0.4f, 0.6f};
  const Color c = pixel.render();
  EXPECT_NEAR(c.r, 0.0125, 1e-6);
  EXPECT_NEAR(c.g, 0.1, 1e-6);
  EXPECT_NEAR(c.b, 0.15, 1e-6);
}

TEST(Whitted, LayersAddMirrorsUndimmedAndFilterTheRest) {
  OnePixel pixel;
  Finish bottom = dark(), top = dark();
  bottom.ambient = {1, 1, 1};
  top.ambient = {0.5f, 0.5f, 0.5f};
  const TextureLayer lower = pixel.layer({{0.2f, 0.4f, 0.6f}}, bottom);
  const TextureLayer upper = pixel.layer({{1, 0.5f, 1}, 0.5f, 0}, top);
  Object& object = pixel.add(kUnitBox, {}, {});
  object.texture = append(pixel.scene.textures, Texture{LayeredTexture{{lower, upper}}, {}});
  const Color c = pixel.render();
  EXPECT_NEAR(c.r, 0.35, 1e-6);
  EXPECT_NEAR(c.g, 0.225, 1e-6);
  EXPECT_NEAR(c.b, 0.55, 1e-6);
}

TEST(Whitted, MirrorsUseUpLevels) {
  const double expected[] = {0.1, 0.1, 0.125, 0.125, 0.13125};
  for (std::uint32_t level = 1; level <= 5; ++level) {
    OnePixel pixel;
    Finish mirror = glowing(0.1f);
    mirror.reflection_min = mirror.reflection_max = {0.5f, 0.5f, 0.5f};
    pixel.add(kUnitBox, clear(0, 0), mirror);
    pixel.add(Plane{{0, 0, 1}, -10}, {}, mirror);
    pixel.scene.settings.max_trace_level = level;
    EXPECT_NEAR(pixel.render().g, expected[level - 1], 1e-6) << level;
  }
}

TEST(Whitted, GoingStraightThroughUsesNoLevelButRefractionDoes) {
  for (const double ior : {1.0, 1.5}) {
    for (const std::uint32_t level : {1u, 2u, 6u, 7u}) {
      OnePixel pixel;
      const InteriorId glass = append(pixel.scene.interiors, Interior{ior, true});
      for (int i = 0; i < 3; ++i) {
        const double z = i;
        Object& slab = pixel.add(Box{{-1, -1, z}, {1, 1, z + 0.5}}, clear(0, 1), dark());
        slab.interior = glass;
      }
      pixel.scene.atmosphere.background = {1, 1, 1};
      pixel.scene.settings.max_trace_level = level;
      const bool through = ior == 1.0 ? level >= 2 : level >= 7;
      EXPECT_NEAR(pixel.render().g, through ? 1 : 0, 1e-6) << ior << ' ' << level;
    }
  }
}

TEST(Whitted, TotalReflectionMirrorsAllTheLightAndNothingElseDoes) {
  // From inside a block of glass: mirrored at the top, out at the side.
  const auto seen = [](float filter, float reflection, bool conserve) {
    OnePixel pixel;
    pixel.scene.camera.location = {0, 0, 0};
    pixel.scene.camera.direction = normalize(Vec3{1.6, 1, 0});
    pixel.scene.camera.right = {0, 0, 1e-3};
    pixel.scene.camera.up = 1e-3 * normalize(Vec3{-1, 1.6, 0});
    pixel.scene.settings.max_trace_level = 3;
    pixel.scene.atmosphere.background = {0.2f, 0.2f, 0.2f};
    Finish finish = dark();
    finish.reflection_min = finish.reflection_max = {reflection, reflection, reflection};
    finish.conserve_energy = conserve;
    Object& block = pixel.add(Box{{-2, -5, -5}, {3, 1, 5}}, clear(filter, 0), finish);
    block.interior = append(pixel.scene.interiors, Interior{1.5, true});
    return pixel.render().g;
  };
  EXPECT_NEAR(seen(1, 0, false), 0.2, 1e-6);
  EXPECT_NEAR(seen(0.5f, 0, false), 0.1, 1e-6);
  EXPECT_NEAR(seen(0.1f, 0.3f, false), 0.02, 1e-6);
  EXPECT_NEAR(seen(0.5f, 0.7f, false), 0.1, 1e-6);
  EXPECT_NEAR(seen(0.5f, 0.7f, true), 0.03, 1e-6);
}

TEST(Whitted, WhatCountsNegativelyCounts) {
  OnePixel pixel;
  pixel.scene.atmosphere.background = {0.25f, 0.25f, 0.25f};
  pixel.add(kUnitBox, clear(0, -1), dark());
  EXPECT_NEAR(pixel.render().g, 0.25, 1e-6);  // twice by -1
  pixel.add(Plane{{0, 0, -1}, -2}, clear(0, -1), dark());
  EXPECT_NEAR(pixel.render().g, -0.25, 1e-6);
}

TEST(Whitted, RaysThatCountForLessThanTheBailoutAreDropped) {
  for (const auto& [bailout, expected] :
       {std::pair{0.6, 0.1}, {0.5, 0.15}, {0.26, 0.15}, {0.25, 0.175}, {0.1, 0.1875}}) {
    OnePixel pixel;
    Finish mirror = glowing(0.1f);
    mirror.reflection_min = mirror.reflection_max = {0.5f, 0.5f, 0.5f};
    pixel.add(kUnitBox, clear(0, 0), mirror);
    pixel.add(Plane{{0, 0, 1}, -10}, clear(0, 0), mirror);
    pixel.scene.settings.max_trace_level = 20;
    pixel.scene.settings.adc_bailout = bailout;
    EXPECT_NEAR(pixel.render().g, expected, 1e-6) << bailout;
  }
}

TEST(Whitted, ShadowsAreFilteredAndFadeInsideTheSolid) {
  const auto lit = [](double fade_power, Color fade_color) {
    OnePixel pixel;
    pixel.scene.camera.location = {3, 0, -5};
    pixel.scene.camera.direction = normalize(Vec3{-3, 0, 5});
    pixel.scene.camera.right = 1e-3 * normalize(Vec3{5, 0, 3});
    Finish matte = dark();
    matte.diffuse = 1;
    Object& pane = pixel.add(Box{{-1, -1, -2}, {1, 1, -1}}, {{1, 0.5f, 0.25f}, 0.5f, 0}, dark());
    pane.no_image = true;
    pane.interior =
        append(pixel.scene.interiors,
               Interior{.fade_distance = 1, .fade_power = fade_power, .fade_color = fade_color});
    pixel.add(Plane{{0, 0, -1}, 0}, clear(0, 0), matte);
    pixel.scene.lights.push_back({.location = {0, 0, -100}});
    return pixel.render();
  };
  const Color plain = lit(0, {});
  EXPECT_NEAR(plain.r, 0.25, 1e-5);
  EXPECT_NEAR(plain.g, 0.0625, 1e-5);
  EXPECT_NEAR(plain.b, 0.015625, 1e-5);
  EXPECT_NEAR(lit(2, {}).r, 0.125, 1e-5);
  EXPECT_NEAR(lit(1001, {}).r, 0.25 * std::exp(-1), 1e-5);
  EXPECT_NEAR(lit(1, {1, 0, 0}).r, 0.25, 1e-5);
  EXPECT_NEAR(lit(1, {1, 0, 0}).g, 0.03125, 1e-5);
}

TEST(Whitted, AreaLightsWeighTheirSamplesByHalving) {
  // An opaque edge hides the samples left of it; the weights are those of the scene language.
  const auto lit = [](std::uint32_t size, double edge) {
    OnePixel pixel;
    pixel.scene.camera.location = {0, 1, 0};
    pixel.scene.camera.direction = {0, -1, 0};
    pixel.scene.camera.up = {0, 0, 1e-3};
    Finish matte = dark();
    matte.diffuse = 1;
    pixel.add(Plane{{0, 1, 0}, 0}, clear(0, 0), matte);
    pixel.add(Box{{-10, 5, -10}, {edge, 5.01, 10}}, {}, dark());
    Light light;
    light.location = {0, 10, 0};
    light.is_area = true;
    light.area.axis1 = {4, 0, 0};
    light.area.axis2 = {0, 0, 4};
    light.area.size1 = light.area.size2 = size;
    pixel.scene.lights.push_back(light);
    return pixel.render().g;
  };
  const double edges[] = {-0.75, -0.25, 0.25, 0.75};
  const double expected[][4] = {{0.5, 0.5, 0.5, 0.5},
                                {0.75, 0.75, 0.25, 0.25},
                                {0.75, 0.5, 0.5, 0.25},
                                {0.875, 0.625, 0.375, 0.125},
                                {0.875, 0.625, 0.375, 0.125}};
  for (std::uint32_t size = 2; size <= 6; ++size) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(lit(size, edges[i]), expected[size - 2][i], 1e-5) << size << ' ' << edges[i];
    }
  }
}

TEST(Whitted, FogFollowsBeerAndItsTurbulence) {
  OnePixel pixel;
  pixel.scene.camera.location = {0.3, 0.7, 0};
  pixel.add(Plane{{0, 0, -1}, -10}, {}, dark());
  Fog fog;
  fog.distance = 10;
  fog.color.color = {1, 1, 1};
  pixel.scene.atmosphere.fogs.push_back(fog);
  EXPECT_NEAR(pixel.render().g, 1 - std::exp(-1), 1e-5);
  pixel.scene.atmosphere.fogs[0].turbulence = {1, 1, 1};
  pixel.scene.atmosphere.fogs[0].turb_depth = 1;
  EXPECT_NEAR(pixel.render().g, 1 - std::exp(-0.6734), 1e-4);
}

TEST(Whitted, ADisturbedMirrorNeverLooksBelowItsSurface) {
  OnePixel pixel;
  Finish mirror = dark();
  mirror.reflection_min = mirror.reflection_max = {1, 1, 1};
  Object& floor = pixel.add(Plane{{0, 1, 0}, 0}, clear(0, 0), mirror);
  PatternNormal bumps{Pattern{.data = Bumps{}}, {}, 5};
  TextureLayer layer = pixel.layer(clear(0, 0), mirror);
  layer.normal = append(pixel.scene.normals, Normal{bumps});
  floor.texture = append(pixel.scene.textures, Texture{LayeredTexture{{layer}}, {}});
  pixel.scene.atmosphere.background = {1, 1, 1};
  for (int i = 0; i < 50; ++i) {
    pixel.scene.camera.location = {0.37 * i, 0.3, -5};
    pixel.scene.camera.direction = normalize(Vec3{0, -0.3, 5});
    EXPECT_NEAR(pixel.render().g, 1, 1e-6);
  }
}

TEST(RenderImage, TheImageDoesNotDependOnThreads) {
  OnePixel pixel;
  pixel.scene.camera = Camera{};
  pixel.scene.camera.location = {0, 1, -5};
  Finish shiny;
  shiny.reflection_min = shiny.reflection_max = {0.4f, 0.4f, 0.4f};
  pixel.add(Sphere{{0, 1, 0}, 1}, {{1, 0.3f, 0.2f}, 0.3f, 0}, shiny);
  pixel.add(Plane{{0, 1, 0}, 0}, {{0.7f, 0.8f, 1}}, shiny);
  pixel.scene.lights.push_back({.location = {4, 8, -5}});
  std::vector<Color> first;
  for (const std::uint32_t threads : {1u, 2u, 4u}) {
    RenderOptions options{.width = 70, .height = 50, .threads = threads};
    options.antialias.method = 1;
    const auto result = render_image(pixel.scene, {}, options, {});
    ASSERT_TRUE(result);
    if (first.empty()) first = result->image.pixels;
    EXPECT_TRUE(first == result->image.pixels) << threads;
  }
}

}  // namespace
}  // namespace dioptre
