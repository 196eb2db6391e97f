// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/syntax/syntax_test_support.h"

namespace dioptre::pov {
namespace {

const LayeredTexture& layers_of(const Scene& scene) {
  const Object& object = at(scene.objects, scene.roots.at(0));
  return std::get<LayeredTexture>(at(scene.textures, object.texture).data);
}

Pigment pigment_of(const std::string& contents) {
  const Scene scene = scene_of("sphere { 0, 1 pigment { " + contents + " } }");
  return at(scene.pigments, layers_of(scene).layers.at(0).pigment);
}

Finish finish_of(const std::string& contents) {
  return layers_of(scene_of("sphere { 0, 1 finish { " + contents + " } }")).layers.at(0).finish;
}

TEST(Textures, OfAnObjectWithoutOneIsTheDefaultOfItsPlace) {
  const Scene scene = scene_of(
      "sphere { 0, 1 }\n#default { pigment { rgb y } finish { ambient 1 } }\nsphere { 0, 1 }");
  const auto color = [&](std::size_t root) {
    const Object& object = at(scene.objects, scene.roots.at(root));
    const auto& texture = std::get<LayeredTexture>(at(scene.textures, object.texture).data);
    return std::get<SolidPigment>(at(scene.pigments, texture.layers.at(0).pigment).data).color;
  };
  EXPECT_EQ(color(0).color, (Color{0, 0, 0}));
  EXPECT_EQ(color(1).color, (Color{0, 1, 0}));
}

TEST(Textures, EntriesOfANormalBeginWithTheDefaultNormal) {
  for (const std::string entries : {"gradient x normal_map { [0 marble] [1 gradient y] }",
                                    "checker normal { marble } normal { gradient y }"}) {
    const Scene scene = scene_of("#default { normal { bump_size 1.5 } }\nsphere { 0, 1 normal { " +
                                 entries + " } }");
    const Normal& normal = at(scene.normals, layers_of(scene).layers.at(0).normal);
    const auto& map = std::get<NormalMapNormal>(normal.data);
    ASSERT_EQ(map.entries.size(), 2u);
    for (const NormalEntry& entry : map.entries) {
      const Normal& inner = at(scene.normals, entry.normal);
      EXPECT_TRUE(inner.has_bump_size) << entries;
      EXPECT_EQ(inner.bump_size, 1.5) << entries;
    }
  }
}

TEST(Textures, SeveralAreLayersFromTheBottom) {
  const Scene scene = scene_of(
      "#declare A = sphere { 0, 1 texture { pigment { rgb x } } }\n"
      "object { A texture { pigment { rgbt <0, 0, 1, .5> } } }");
  const auto& layers = layers_of(scene).layers;
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(std::get<SolidPigment>(at(scene.pigments, layers[0].pigment).data).color.color.r, 1);
  EXPECT_EQ(std::get<SolidPigment>(at(scene.pigments, layers[1].pigment).data).color.transmit,
            0.5f);
}

TEST(Textures, ANewNormalStaysWhereThePigmentHasMoved) {
  const Scene scene =
      scene_of("sphere { 0, 1 texture { pigment { gradient x } scale 4 normal { bumps } } }");
  const TextureLayer& layer = layers_of(scene).layers.at(0);
  EXPECT_EQ(layer.transform, Affine{});
  const auto& pigment = std::get<ColorMapPigment>(at(scene.pigments, layer.pigment).data);
  ASSERT_EQ(pigment.pattern.warps.size(), 1u);
  EXPECT_EQ(std::get<TransformWarp>(pigment.pattern.warps[0]).transform, scaling({4, 4, 4}));
}

TEST(Textures, OfTilesTheSecondIsOnTheEvenCells) {
  const Scene scene = scene_of(
      "sphere { 0, 1 texture { tiles { texture { pigment { rgb x } } "
      "tile2 texture { pigment { rgb y } } } } }");
  const Object& object = at(scene.objects, scene.roots.at(0));
  const auto& map = std::get<TextureMap>(at(scene.textures, object.texture).data);
  ASSERT_TRUE(std::holds_alternative<Checker>(map.pattern.data));
  ASSERT_EQ(map.entries.size(), 2u);
  const auto& even = std::get<LayeredTexture>(at(scene.textures, map.entries[0].texture).data);
  EXPECT_EQ(std::get<SolidPigment>(at(scene.pigments, even.layers[0].pigment).data).color.color.g,
            1);
}

TEST(Pigments, TransformationsMergeAndTurbulenceComesFirst) {
  const auto pigment =
      std::get<ColorMapPigment>(pigment_of("wood scale 2 translate x turbulence 0.1").data);
  ASSERT_EQ(pigment.pattern.warps.size(), 2u);
  EXPECT_EQ(std::get<Turbulence>(pigment.pattern.warps[0]).amount, (Vec3{0.1, 0.1, 0.1}));
  EXPECT_EQ(std::get<TransformWarp>(pigment.pattern.warps[1]).transform,
            then(scaling({2, 2, 2}), translation({1, 0, 0})));
}

TEST(Pigments, AWarpOfTurbulenceKeepsItsPlace) {
  const auto pigment =
      std::get<ColorMapPigment>(pigment_of("bozo warp { turbulence 1 } turbulence 2").data);
  ASSERT_EQ(pigment.pattern.warps.size(), 3u);
  EXPECT_EQ(std::get<Turbulence>(pigment.pattern.warps[0]).amount.x, 2);
  EXPECT_EQ(std::get<Turbulence>(pigment.pattern.warps[2]).amount.x, 1);
}

TEST(Pigments, ShortListsAreFilledWithTheUsualColors) {
  for (const char* pattern : {"checker", "brick", "hexagon", "square", "triangular", "cubic"}) {
    const auto usual = std::get<ColorMapPigment>(pigment_of(pattern).data);
    const auto given =
        std::get<ColorMapPigment>(pigment_of(std::string(pattern) + " rgb 0.25").data);
    EXPECT_TRUE(usual.list && given.list) << pattern;
    ASSERT_EQ(usual.entries.size(), given.entries.size()) << pattern;
    EXPECT_EQ(given.entries[0].color.color, (Color{0.25f, 0.25f, 0.25f})) << pattern;
    for (std::size_t i = 1; i < usual.entries.size(); ++i) {
      EXPECT_EQ(usual.entries[i], given.entries[i]) << pattern;
    }
  }
}

TEST(Pigments, BothFormsOfColorMapsAreTheSame) {
  EXPECT_EQ(pigment_of("gradient x color_map { [0, 0.5 color rgb 0 color rgb 1] }"),
            pigment_of("gradient x color_map { [0 rgb 0] [0.5 rgb 1] }"));
}

TEST(Pigments, EveryPatternIsRead) {
  for (const char* pattern : {"agate agate_turb 2",
                              "aoi",
                              "boxed",
                              "bozo",
                              "bumps",
                              "cells",
                              "crackle form <1, 0, 0> metric 3 offset 0.1 solid",
                              "cylindrical",
                              "dents",
                              "facets coords 1",
                              "gradient <1, 1, 0>",
                              "granite",
                              "julia <0.3, 0.4>, 20 exponent 3",
                              "leopard",
                              "magnet 1 mandel 30",
                              "magnet 2 julia <1, 1>, 20",
                              "mandel 20 interior 1, 2",
                              "marble",
                              "onion",
                              "planar",
                              "quilted control0 0.5 control1 1",
                              "radial",
                              "ripples",
                              "slope { y, 0, 1 altitude y, 0, 2 }",
                              "spherical",
                              "spiral1 3",
                              "spiral2 3",
                              "spotted",
                              "tiling 5",
                              "waves",
                              "wood",
                              "wrinkles",
                              "function { x + y }",
                              "pigment_pattern { checker rgb 0 rgb 1 }"}) {
    const auto with = pigment_of(std::string(pattern) + " frequency 2 phase 0.5 sine_wave");
    const auto& map = std::get<ColorMapPigment>(with.data);
    EXPECT_FALSE(map.list) << pattern;
    EXPECT_EQ(map.pattern.frequency, 2) << pattern;
    EXPECT_EQ(map.pattern.wave, Wave::kSine) << pattern;
  }
}

TEST(Finishes, ReflectionIsOneValueOrARange) {
  EXPECT_EQ(finish_of("reflection 0.5").reflection_min.r, 0.5f);
  EXPECT_EQ(finish_of("reflection { 0.5 }").reflection_min.r, 0.5f);
  EXPECT_EQ(finish_of("reflection { 0.5 fresnel }").reflection_min.r, 0);
  EXPECT_EQ(finish_of("reflection { 0.5 fresnel }").reflection_max.r, 0.5f);
  const Finish range = finish_of("reflection { 0.2, 0.8 falloff 2 metallic exponent 0.5 }");
  EXPECT_EQ(range.reflection_min.r, 0.2f);
  EXPECT_EQ(range.reflection_max.r, 0.8f);
  EXPECT_EQ(range.reflection_falloff, 2);
  EXPECT_EQ(range.reflection_metallic, 1);
  EXPECT_EQ(range.reflection_exponent, 0.5);
}

TEST(Finishes, AlbedoIsKeptAsWritten) {
  const Finish finish = finish_of("diffuse albedo 0.7, 0.2 phong albedo 0.1 specular albedo 0.3");
  EXPECT_TRUE(finish.diffuse_albedo && finish.phong_albedo && finish.specular_albedo);
  EXPECT_EQ(finish.diffuse_back, 0.2);
}

}  // namespace
}  // namespace dioptre::pov
