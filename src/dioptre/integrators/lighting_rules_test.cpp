// SPDX-License-Identifier: Apache-2.0
// Rules of light between surfaces; the numbers are those that POV-Ray prints for the same scenes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dioptre/integrators/render_image.h"

namespace dioptre {
namespace {

Finish finish_of(float emission, double diffuse) {
  Finish finish;
  finish.ambient = {};
  finish.emission = {emission, emission, emission};
  finish.diffuse = diffuse;
  return finish;
}

/// A scene seen through one pixel, from (0, 0, -5) along +z unless moved.
class LitScene {
 public:
  LitScene() {
    scene.camera.kind = Camera::Kind::kOrthographic;
    scene.camera.location = {0, 0, -5};
    scene.camera.right = {1e-3, 0, 0};
    scene.camera.up = {0, 1e-3, 0};
    scene.default_texture = texture({}, finish_of(0, 0));
  }

  TextureId texture(PigmentColor color, const Finish& finish) {
    const PigmentId pigment = append(scene.pigments, Pigment{SolidPigment{color}, {}, false});
    return append(scene.textures, Texture{LayeredTexture{{{pigment, {}, finish, {}}}}, {}});
  }
  Object& add(ShapeData shape, PigmentColor color, const Finish& finish = finish_of(0, 0)) {
    Object object;
    object.geometry = std::move(shape);
    object.texture = texture(color, finish);
    scene.roots.push_back(append(scene.objects, object));
    return scene.objects.back();
  }
  Object& add_filled(ShapeData shape, PigmentColor color, const Interior& interior) {
    Object& object = add(std::move(shape), color);
    object.interior = append(scene.interiors, interior);
    return object;
  }
  Light& add_light(Vec3 location, Color color = {1, 1, 1}) {
    Light light;
    light.location = location;
    light.color = color;
    scene.lights.push_back(light);
    return scene.lights.back();
  }
  /// A white wall at z = 0, looked at from the side, and a light behind the camera.
  void look_at_wall_past_the_light() {
    scene.camera.location = {8, 0, -5};
    scene.camera.direction = normalize(Vec3{-8, 0, 5});
    scene.camera.right = 1e-3 * normalize(Vec3{5, 0, 8});
    add(Plane{{0, 0, -1}, 0}, {{1, 1, 1}}, finish_of(0, 1));
    add_light({0, 0, -100});
  }
  Color render(std::uint32_t width = 1, std::uint32_t column = 0) const {
    const auto result = render_image(scene, {}, {.width = width, .height = 1}, {});
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? result->image.at(column, 0) : Color{};
  }

  Scene scene;
};

constexpr PigmentColor kClear{{1, 1, 1}, 0, 1};
Interior fading(double distance, double power) {
  return {.fade_distance = distance, .fade_power = power};
}

TEST(InteriorFading, DimsWhatComesThroughTheSurfaceThatEndsIt) {
  for (const auto& [power, left] :
       {std::pair{-1.0, 2.0 / 3}, {0.0, 0.5}, {0.5, 0.414214}, {1.0, 1.0 / 3}, {2.0, 0.2}}) {
    LitScene lit;
    lit.scene.atmosphere.background = {1, 1, 1};
    lit.add_filled(Box{{-1, -1, -1}, {1, 1, 2}}, kClear, fading(1.5, power));
    EXPECT_NEAR(lit.render().g, left, 1e-5) << power;
  }
}

TEST(InteriorFading, LeavesTheSurfaceItselfAndWhatIsInsideAlone) {
  LitScene lit;
  lit.scene.atmosphere.background = {1, 1, 1};
  Object& box = lit.add_filled(Box{{-1, -1, -1}, {1, 1, 2}}, {}, fading(1.5, 2));
  box.texture = lit.texture({{1, 1, 1}, 0, 0.9f}, finish_of(1, 0));
  EXPECT_NEAR(lit.render().g, 0.1 + 0.9 * (0.1 + 0.2 * 0.9), 1e-5);
  lit.add(Sphere{{0, 0, 0}, 0.5}, {{1, 1, 1}}, finish_of(1, 0));
  EXPECT_NEAR(lit.render().g, 1, 1e-5);
}

TEST(Media, EachUseOfAnInteriorIsAMediumOfItsOwn) {
  // Seen along z through a slab of glass with a ball in it; where the ball bends the ray, it shows
  // another place of the wall behind.
  const auto seen = [](double ior, bool shared) {
    LitScene lit;
    lit.scene.camera.location = {0.15, 0, -4};
    lit.scene.camera.right = 1e-3 * Vec3{1, 0, 0};
    lit.add(Box{{0.1, -1, 3}, {0.2, 1, 4}}, {{1, 1, 1}}, finish_of(1, 0));
    const Finish clear = finish_of(0, 0);
    const InteriorId glass = append(lit.scene.interiors, Interior{1.5, true});
    lit.add(Box{{-1, -1, -0.5}, {1, 1, 0.5}}, {{1, 1, 1}, 1, 0}, clear).interior = glass;
    Object& ball = lit.add(Sphere{{0, 0, 0}, 0.3}, {{1, 1, 1}, 1, 0}, clear);
    if (ior > 0) ball.interior = append(lit.scene.interiors, Interior{ior, true});
    if (shared) ball.interior = glass;
    return lit.render().g;
  };
  EXPECT_EQ(seen(1.5, false), 1);  // glass in glass bends nothing,
  EXPECT_EQ(seen(1.5, true), 1);   // though it be the same
  EXPECT_EQ(seen(1, false), 0);
  EXPECT_EQ(seen(0, false), 0);  // what has no interior is air
}

TEST(InteriorFading, CountsFromTheSurfaceMetLast) {
  const auto through = [](ShapeData other, const Interior& interior) {
    LitScene lit;
    lit.scene.atmosphere.background = {1, 1, 1};
    lit.add_filled(Box{{-1, -1, -1}, {1, 1, 2}}, kClear, fading(1.5, 2));
    lit.add_filled(std::move(other), kClear, interior);
    return lit.render().g;
  };
  const double third = 1 / (1 + 1 / 2.25);
  EXPECT_NEAR(through(Disc{{0, 0, 0.5}, {0, 0, 1}, 1, 0}, {}), 0.5, 1e-5);
  EXPECT_NEAR(through(Box{{-1, -1, 0}, {1, 1, 1}}, fading(1, 2)), third * 0.5, 1e-5);
}

TEST(InteriorFading, OfShadowsFollowsTheSameRuleFromTheSurfaceOn) {
  const auto lit_through = [](Box box, const Interior& interior, bool sheet) {
    LitScene lit;
    lit.look_at_wall_past_the_light();
    lit.add_filled(box, kClear, interior).no_image = true;
    if (sheet) lit.add(Disc{{0, 0, -2}, {0, 0, 1}, 1, 0}, kClear).no_image = true;
    return lit.render().g;
  };
  const Box slab{{-1, -1, -3}, {1, 1, -1}};
  EXPECT_NEAR(lit_through(slab, fading(1, 1), false), 1.0 / 3, 1e-5);
  EXPECT_NEAR(lit_through(slab, fading(1, 1), true), 0.5, 1e-5);
  EXPECT_NEAR(lit_through(slab, fading(1, 0), false), 1, 1e-5);
  EXPECT_NEAR(lit_through(slab, fading(1, -1), false), 1, 1e-5);
  EXPECT_NEAR(lit_through({{-1, -1, -4}, {1, 1, 1}}, fading(1, 1), false), 1, 1e-5);
}

TEST(Caustics, BrightenWhatGoesStraightThrough) {
  for (const double caustics : {0.5, 1.0, 2.0}) {
    for (const double degrees : {10.0, 20.0, 40.0}) {
      LitScene lit;
      lit.look_at_wall_past_the_light();
      const double turn = degrees * std::numbers::pi / 180;
      lit.add_filled(Disc{{0, 0, -3}, {0, std::sin(turn), std::cos(turn)}, 3, 0},
                     {{1, 1, 1}, 0, 0.25f}, {.caustics = caustics})
          .no_image = true;
      EXPECT_NEAR(lit.render().g, 0.25 * (1 + std::pow(std::cos(turn), 45 * caustics)), 1e-5);
    }
  }
}

TEST(Fog, DimsOnlyLightsThatAskForItAndOnlyOutsideSolids) {
  const auto lit = [](bool attenuated, bool with_solid, bool hollow) {
    LitScene lit;
    lit.look_at_wall_past_the_light();
    lit.scene.lights[0].location = {0, 0, -20};
    lit.scene.lights[0].media_attenuation = attenuated;
    if (with_solid) {
      Object& solid = lit.add(Box{{-1, -1, -10}, {1, 1, -5}}, kClear);
      solid.no_image = true;
      solid.hollow = solid.has_hollow = hollow;
    }
    Fog fog;
    fog.distance = 40;
    lit.scene.atmosphere.fogs.push_back(fog);
    return lit.render().g / std::exp(-length(Vec3{8, 0, 5}) / 40);
  };
  EXPECT_NEAR(lit(false, false, false), 1, 1e-5);
  EXPECT_NEAR(lit(true, false, false), std::exp(-20.0 / 40), 1e-4);
  EXPECT_NEAR(lit(true, true, false), std::exp(-15.0 / 40), 1e-4);
  EXPECT_NEAR(lit(true, true, true), std::exp(-20.0 / 40), 1e-4);
}

TEST(ProjectedThrough, LightComesThroughItsWindowOnly) {
  const auto lit = [](Vec3 window, bool shadowless, double blocker) {
    LitScene lit;
    lit.look_at_wall_past_the_light();
    Object shape;
    shape.geometry = Disc{window, {0, 0, 1}, 0.7, 0};
    lit.scene.lights[0].projected_through = append(lit.scene.objects, shape);
    lit.scene.lights[0].shadowless = shadowless;
    lit.add(Sphere{{0, 0, blocker}, 0.3}, {{1, 1, 1}}).no_image = true;
    return lit.render().g;
  };
  EXPECT_NEAR(lit({0, 0, -2}, false, -50), 1, 1e-5);
  EXPECT_NEAR(lit({0, 0, -2}, false, -1), 0, 1e-5);
  EXPECT_NEAR(lit({0, 0, -2}, true, -1), 1, 1e-5);
  EXPECT_NEAR(lit({0, 1, -2}, false, -50), 0, 1e-5);
  EXPECT_NEAR(lit({0, 1, -2}, true, -50), 0, 1e-5);
}

TEST(Shadows, AreNotThrownByWhatTouchesTheLightOrTheSurface) {
  for (const double distance : {1.0, 10.0, 1000.0}) {
    for (const auto& [gap, lit_up] : {std::pair{0.0, 1.0}, {0.99e-3, 1.0}, {1.01e-3, 0.0}}) {
      LitScene lit;
      lit.look_at_wall_past_the_light();
      lit.scene.lights[0].location = {0, 0, -distance};
      lit.add(Disc{{0, 0, gap - distance}, {0, 0, 1}, 1, 0}, {}).no_image = true;
      EXPECT_NEAR(lit.render().g, lit_up, 1e-5) << distance << ' ' << gap;
      std::get<Disc>(std::get<ShapeData>(lit.scene.objects.back().geometry)).center.z = -gap;
      EXPECT_NEAR(lit.render().g, lit_up, 1e-5) << gap;
    }
  }
}

TEST(Shadows, CountSurfacesThatTouchOnce) {
  for (const auto& [gap, surfaces] : {std::pair{0.0, 1}, {0.99e-3, 1}, {1.01e-3, 2}}) {
    LitScene lit;
    lit.look_at_wall_past_the_light();
    for (const double z : {-3.0, -3.0 - gap}) {
      lit.add(Disc{{0, 0, z}, {0, 0, 1}, 1, 0}, {{1, 1, 1}, 0, 0.5f}).no_image = true;
    }
    EXPECT_NEAR(lit.render().g, std::pow(0.5, surfaces), 1e-5) << gap;
  }
}

TEST(ConservedEnergy, IsTakenFromTheWeightOfWhatComesThrough) {
  for (const auto& [conserve, bailout, seen] :
       {std::tuple{false, 0.3, 0.5}, {false, 0.6, 0.0}, {true, 0.2, 0.25}, {true, 0.3, 0.0}}) {
    LitScene lit;
    lit.scene.settings.adc_bailout = bailout;
    lit.add(Plane{{0, 0, -1}, -5}, {{1, 1, 1}}, finish_of(1, 0));
    Finish mirror = finish_of(0, 0);
    mirror.reflection_min = mirror.reflection_max = {0.5f, 0.5f, 0.5f};
    mirror.conserve_energy = conserve;
    lit.add(Disc{{0, 0, 0}, {0, 0, 1}, 1, 0}, {{1, 1, 1}, 0, 0.5f}, mirror);
    EXPECT_NEAR(lit.render().g, seen, 1e-5) << conserve << ' ' << bailout;
  }
}

TEST(LightGroups, TheirLightsShineOnTheirOwnObjectsAlone) {
  const auto lit = [](std::uint32_t object_group, bool global_lights) {
    LitScene lit;
    lit.add_light({0, 0, -100}, {1, 0, 0});
    lit.add_light({0, 0, -100}, {0, 1, 0}).group = 1;
    lit.add_light({0, 0, -100}, {0, 0, 1}).group = 2;
    Object& object = lit.add(Box{{-1, -1, 0}, {1, 1, 1}}, {{1, 1, 1}}, finish_of(0, 1));
    object.light_group = object_group;
    object.global_lights = global_lights;
    const Color c = lit.render();
    return std::array{c.r > 0.5f, c.g > 0.5f, c.b > 0.5f};
  };
  EXPECT_EQ(lit(0, false), (std::array{true, false, false}));
  EXPECT_EQ(lit(1, false), (std::array{false, true, false}));
  EXPECT_EQ(lit(2, false), (std::array{false, false, true}));
  EXPECT_EQ(lit(2, true), (std::array{true, false, true}));
}

/// A rainbow of one colour whose band lies in the middle of the view.
Rainbow bow(PigmentColor color) {
  Rainbow rainbow;
  rainbow.direction = {0.5, 0, std::sqrt(0.75)};
  rainbow.angle = 30;
  rainbow.width = 10;
  rainbow.distance = 10;
  rainbow.colors = {{0, color}, {1, color}};
  return rainbow;
}

TEST(Rainbow, IsAFogOfItsColourWhoseFilterTintsTheRest) {
  for (const auto& [color, distance, expected] :
       {std::tuple{PigmentColor{{1, 0.5f, 0.25f}, 0, 0}, 10.0, Color{0.7057f, 0.46322f, 0.45234f}},
        {{{1, 0.5f, 0.25f}, 0, 0.3f}, 20.0, {0.76f, 0.47f, 0.415f}},
        {{{1, 0.5f, 0.25f}, 0.3f, 0}, 10.0, {0.7057f, 0.44926f, 0.41048f}},
        {{{1, 0.5f, 0.25f}, 0.8f, 0.2f}, 20.0, {0.84f, 0.4544f, 0.28321f}}}) {
    LitScene lit;
    lit.add(Plane{{0, 0, -1}, 5 - distance}, {{0.2f, 0.4f, 0.8f}}, finish_of(1, 0));
    lit.scene.atmosphere.rainbows = {bow(color)};
    const Color c = lit.render();
    EXPECT_NEAR(c.r, expected.r, 1e-4);
    EXPECT_NEAR(c.g, expected.g, 1e-4);
    EXPECT_NEAR(c.b, expected.b, 1e-4);
  }
}

TEST(Rainbow, SeveralInOneDirectionAreAveraged) {
  LitScene lit;
  lit.scene.atmosphere.background = {0.2f, 0.4f, 0.8f};
  lit.scene.atmosphere.rainbows = {bow({{1, 0.5f, 0.25f}, 0, 0}), bow({{0, 1, 0}, 0, 0.5f})};
  const Color c = lit.render();
  EXPECT_NEAR(c.r, 0.55, 1e-5);
  EXPECT_NEAR(c.g, 0.6, 1e-5);
  EXPECT_NEAR(c.b, 0.325, 1e-5);
}

TEST(Rainbow, FadesOutTowardsTheEndsOfItsArc) {
  for (const auto& [degrees, share] :
       {std::pair{0.0, 1.0}, {40.0, 0.7407}, {50.0, 0.2593}, {61.0, 0.0}}) {
    LitScene lit;
    Rainbow rainbow = bow({{1, 1, 1}, 0, 0});
    rainbow.direction = {0, -0.5, std::sqrt(0.75)};
    const double turn = degrees * std::numbers::pi / 180;
    const Vec3 top{0, std::sqrt(0.75), 0.5};
    rainbow.up = std::cos(turn) * top + std::sin(turn) * Vec3{1, 0, 0};
    rainbow.arc_angle = 120;
    rainbow.falloff_angle = 60;
    lit.scene.atmosphere.rainbows = {rainbow};
    EXPECT_NEAR(lit.render().g, share, 1e-3) << degrees;
  }
}

TEST(CameraNormal, BendsTheRaysAsIfTheyWereNormalsOnTheImage) {
  LitScene lit;
  lit.scene.camera = Camera{};
  lit.scene.camera.right = {2, 0, 0};
  lit.scene.camera.up = {0, 0.01, 0};
  lit.add(Box{{-1e3, -1e3, 10}, {0, 1e3, 11}}, {{1, 1, 1}}, finish_of(1, 0));
  // The ramp turns all rays by 0.0667 to the left: x = 0 is seen right of the centre.
  Pattern ramp{.data = Gradient{{1, 0, 0}}};
  lit.scene.camera.normal = append(lit.scene.normals, Normal{PatternNormal{ramp, {}, 0.5}});
  const std::uint32_t width = 401;
  const auto result = render_image(lit.scene, {}, {.width = width, .height = 1}, {});
  ASSERT_TRUE(result);
  std::uint32_t edge = width;
  while (edge > 0 && !(result->image.at(edge - 1, 0).g > 0)) --edge;
  const double x = 2 * (double{edge} / width - 0.5);
  EXPECT_NEAR(x / std::hypot(x, 1.0), 0.5 * 0.1 * 4 / 3, 0.006);
}

/// What of a light, two units across or as given, is seen from a wall past a straight edge half
/// way, which hides all to the left of `edge` on the light.
double share_past_an_edge(LightShape shape, double edge, std::uint32_t samples, double size = 2) {
  LitScene lit;
  lit.look_at_wall_past_the_light();
  lit.scene.camera.location = {8, 0, -1};
  lit.scene.camera.direction = normalize(Vec3{-8, 0, 1});
  Light& light = lit.scene.lights.back();
  light.location = {0, 0, -10};
  light.is_area = true;
  light.area.axis1 = {size, 0, 0};
  light.area.axis2 = {0, size, 0};
  lit.add(Box{{-100, -100, -5.001}, {edge / 2, 100, -5}}, {{1, 1, 1}}, finish_of(0, 0));
  RenderOptions options{.width = 1, .height = 1};
  options.integrator_options.penumbra = {shape, samples};
  const auto result = render_image(lit.scene, {}, options, {});
  EXPECT_TRUE(result);
  return result->image.at(0, 0).g;
}

TEST(Penumbra, IsThePartOfTheLightThatIsSeen) {
  for (const double edge : {-0.5, 0.0, 0.3}) {
    const double segment = (std::acos(edge) - edge * std::sqrt(1 - edge * edge)) / std::numbers::pi;
    EXPECT_NEAR(share_past_an_edge(LightShape::kRectangle, edge, 10000), (1 - edge) / 2, 5e-3);
    EXPECT_NEAR(share_past_an_edge(LightShape::kDisc, edge, 10000), segment, 5e-3);
  }
  EXPECT_NEAR(share_past_an_edge(LightShape::kSphere, 0, 10000), 0.5, 5e-3);
  EXPECT_NEAR(share_past_an_edge(LightShape::kSphere, -1.1, 100), 1, 1e-6);
}

TEST(Penumbra, OfASmallLightIsTheShadowOfAPoint) {
  for (const LightShape shape : {LightShape::kRectangle, LightShape::kDisc, LightShape::kSphere}) {
    EXPECT_EQ(share_past_an_edge(shape, 0.01, 16, 1e-3), 0);
    EXPECT_NEAR(share_past_an_edge(shape, -0.01, 16, 1e-3), 1, 1e-6);
    EXPECT_NEAR(share_past_an_edge(shape, -0.01, 0, 1e-3), 1, 1e-6);
  }
}

TEST(Penumbra, GetsSmootherWithMoreSamples) {
  for (const LightShape shape : {LightShape::kRectangle, LightShape::kDisc, LightShape::kSphere}) {
    const double exact = share_past_an_edge(shape, 0.1, 40000);
    EXPECT_NEAR(share_past_an_edge(shape, 0.1, 16), exact, 0.13);
    EXPECT_NEAR(share_past_an_edge(shape, 0.1, 900), exact, 0.02);
  }
}

}  // namespace
}  // namespace dioptre
