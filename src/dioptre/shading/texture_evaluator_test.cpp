// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/texture_evaluator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dioptre {
namespace {

Pattern with(PatternData data) {
  Pattern pattern;
  pattern.data = std::move(data);
  return pattern;
}

PigmentId solid(Scene& scene, PigmentColor color) {
  Pigment pigment;
  pigment.data = SolidPigment{color};
  return append(scene.pigments, pigment);
}

/// Black to white by a pattern.
PigmentId ramp(Scene& scene, Pattern pattern) {
  Pigment pigment;
  pigment.data = ColorMapPigment{std::move(pattern), {{0, {}}, {1, {{1, 1, 1}}}}, false};
  return append(scene.pigments, pigment);
}

TextureId layered(Scene& scene, std::vector<TextureLayer> layers) {
  return append(scene.textures, Texture{LayeredTexture{std::move(layers)}, {}});
}

std::unique_ptr<const TextureEvaluator> compiled(const Scene& scene) {
  auto result = TextureEvaluator::compile(scene, {});
  EXPECT_TRUE(result.has_value());
  return std::move(*result);
}

constexpr TexturePoint kPoint{{0.3, 0, 0.2}, {0, 1, 0}, {0, -1, 0}, {0.25, 0.75}};

TEST(PigmentMap, MovesItsEntriesWithAllItsWarps) {
  // Values printed by POV-Ray 3.7.0.10 for gradient x with two entries of gradient y.
  const Vec3 p{0.7033, -1.1427, -0.7622};
  const auto value = [&](std::vector<Warp> warps) {
    Scene scene;
    const PigmentId child = ramp(scene, with(Gradient{{0, 1, 0}}));
    Pattern pattern = with(Gradient{{1, 0, 0}});
    pattern.warps = std::move(warps);
    Pigment map;
    map.data = PigmentMapPigment{pattern, {{0, child}, {1, child}}, false};
    const PigmentId id = append(scene.pigments, map);
    return compiled(scene)->pigment(id, p).color.r;
  };
  const TransformWarp twice{scaling({2, 2, 2})};
  const RepeatWarp repeat{1, 0.4, {}, {1, 1, 1}};
  EXPECT_NEAR(value({}), 0.85731, 1e-5);
  EXPECT_NEAR(value({twice}), 0.42865, 1e-5);
  EXPECT_NEAR(value({Turbulence{{0.5, 0.5, 0.5}}}), 0.83089, 1e-5);
  EXPECT_NEAR(value({repeat}), 0.0573, 1e-5);
  EXPECT_NEAR(value({repeat, twice}), 0.22865, 1e-5);
  EXPECT_NEAR(value({twice, repeat}), 0.02865, 1e-5);
}

TEST(ColorMap, LooksUpBetweenTheFirstEntryThatReachesTheValueAndTheOneBefore) {
  const auto value = [](std::vector<ColorEntry> entries, double x) {
    Scene scene;
    Pigment pigment;
    pigment.data = ColorMapPigment{with(Gradient{{1, 0, 0}}), std::move(entries), false};
    const PigmentId id = append(scene.pigments, pigment);
    return compiled(scene)->pigment(id, {x, 0, 0}).color.r;
  };
  const auto grey = [](float v) { return PigmentColor{{v, v, v}}; };
  const std::vector<ColorEntry> step{{0.3, grey(1)}, {0.3, grey(0)}};
  EXPECT_EQ(value(step, 0.3), 1);
  EXPECT_EQ(value(step, 0.30001), 0);
  const std::vector<ColorEntry> double_entry{
      {0.2, grey(1)}, {0.6, grey(0)}, {0.6, grey(0.5f)}, {0.8, grey(0.7f)}};
  EXPECT_NEAR(value(double_entry, 0.25), 0.875, 1e-6);
  EXPECT_NEAR(value(double_entry, 0.6), 0, 1e-6);
  EXPECT_NEAR(value(double_entry, 0.65), 0.55, 1e-6);
  const std::vector<ColorEntry> unsorted{{0.6, grey(1)}, {0.2, grey(0)}, {0.9, grey(0.3f)}};
  EXPECT_NEAR(value(unsorted, 0.5), 1, 1e-6);
  EXPECT_NEAR(value(unsorted, 0.65), 0.1929, 1e-4);
  EXPECT_NEAR(value(unsorted, 0.95), 0.3, 1e-6);
}

TEST(AveragePigment, WeighsItsEntries) {
  Scene scene;
  const PigmentId a = solid(scene, {{1, 0, 0}, 0, 1}), b = solid(scene, {{0, 1, 0}, 0, 0});
  Pigment average;
  average.data = AveragePigment{{{1, a}, {3, b}}, {}};
  const PigmentId id = append(scene.pigments, average);
  const PigmentColor color = compiled(scene)->pigment(id, {});
  EXPECT_FLOAT_EQ(color.color.r, 0.25f);
  EXPECT_FLOAT_EQ(color.color.g, 0.75f);
  EXPECT_FLOAT_EQ(color.transmit, 0.25f);
}

TEST(Texture, ShowsTheTopLayerFirstAndFiltersThroughAll) {
  Scene scene;
  const PigmentId below = solid(scene, {{1, 0.5f, 1}, 0.5f, 0});
  const PigmentId above = solid(scene, {{0, 0, 1}, 0, 0.5f});
  const TextureId id = layered(scene, {{below, {}, {}, {}}, {above, {}, {}, {}}});
  const auto textures = compiled(scene);
  TextureSample sample;
  textures->evaluate(id, kPoint, sample);
  ASSERT_EQ(sample.stacks.size(), 1u);
  ASSERT_EQ(sample.layers.size(), 2u);
  EXPECT_EQ(sample.layers[0].pigment.color, (Color{0, 0, 1}));
  EXPECT_EQ(sample.layers[0].normal, kPoint.normal);
  EXPECT_FALSE(textures->opaque(id));
  const Color through = textures->transmittance(id, kPoint);
  EXPECT_FLOAT_EQ(through.r, 0.25f);
  EXPECT_FLOAT_EQ(through.g, 0.125f);
  EXPECT_FLOAT_EQ(through.b, 0.25f);
}

TEST(Texture, IsOpaqueIfAnyLayerIs) {
  Scene scene;
  const PigmentId clear = solid(scene, {{}, 0, 1}), full = solid(scene, {{1, 1, 1}});
  const TextureId id = layered(scene, {{full, {}, {}, {}}, {clear, {}, {}, {}}});
  const TextureId glass = layered(scene, {{clear, {}, {}, {}}});
  const TextureId map =
      append(scene.textures, Texture{TextureMap{with(Checker{}), {{0, id}, {1, glass}}, true}, {}});
  const auto textures = compiled(scene);
  EXPECT_TRUE(textures->opaque(id));
  EXPECT_FALSE(textures->opaque(glass));
  EXPECT_FALSE(textures->opaque(map));
  EXPECT_TRUE(is_black(textures->transmittance(id, kPoint)));
}

TEST(TextureMap, MixesStacksWhoseWeightsSumToOne) {
  Scene scene;
  const TextureId a = layered(scene, {{solid(scene, {{1, 0, 0}}), {}, {}, {}}});
  const TextureId b = layered(scene, {{solid(scene, {{0, 1, 0}}), {}, {}, {}}});
  const TextureId map = append(
      scene.textures, Texture{TextureMap{with(Gradient{{1, 0, 0}}), {{0, a}, {1, b}}, false}, {}});
  const TextureId average = append(scene.textures, Texture{AverageTexture{{{2, map}, {1, a}}}, {}});
  const auto textures = compiled(scene);
  TextureSample sample;
  for (const TextureId id : {map, average}) {
    textures->evaluate(id, kPoint, sample);
    float sum = 0;
    for (const TextureSample::Stack& stack : sample.stacks) sum += stack.weight;
    EXPECT_NEAR(sum, 1, 1e-6);
  }
  EXPECT_EQ(sample.stacks.size(), 3u);
  EXPECT_NEAR(sample.stacks[0].weight, 0.7 * 2 / 3, 1e-6);
}

/// A normal as POV-Ray 3.7.0.10 renders it on the plane y = 0 at (0.3, 0, 0.2).
struct KnownNormal {
  const char* name;
  Normal normal;
  Vec3 expected;
};

Normal bumps(PatternData data, std::vector<Warp> warps = {}) {
  Pattern pattern = with(std::move(data));
  pattern.warps = std::move(warps);
  Normal normal;
  normal.data = PatternNormal{std::move(pattern), {}, 0.5};
  return normal;
}
Normal strong(Normal normal) {
  normal.bump_size = 2;
  normal.has_bump_size = true;
  return normal;
}
Normal unscaled(Normal normal) {
  normal.no_bump_scale = true;
  return normal;
}
Normal accurate(Normal normal, double accuracy) {
  normal.accuracy = accuracy;
  return normal;
}
Normal profiled(Normal normal) {
  std::get<PatternNormal>(normal.data).slope_map = {{0, 0, 1}, {0.5, 0.3, 0.5}, {1, 0, -1}};
  return normal;
}
Normal waving(Normal normal) {
  Pattern& pattern = std::get<PatternNormal>(normal.data).pattern;
  pattern.frequency = 3;
  pattern.phase = 0.1;
  return normal;
}

std::vector<KnownNormal> known_normals() {
  const auto scaled = [](double x, double y, double z) {
    return std::vector<Warp>{TransformWarp{scaling({x, y, z})}};
  };
  const std::vector<Warp> turbulent{Turbulence{{0.5, 0.5, 0.5}}};
  const std::vector<Warp> turned{TransformWarp{rotation({0, 90, 0})}};
  return {
      {"bumps", bumps(Bumps{}), {-0.06914, 0.98681, -0.14635}},
      {"bumps scale 2", bumps(Bumps{}, scaled(2, 2, 2)), {-0.11341, 0.97552, -0.18846}},
      {"no_bump_scale", unscaled(bumps(Bumps{}, scaled(2, 2, 2))), {-0.05964, 0.99328, -0.09912}},
      {"scale <1,3,5>", bumps(Bumps{}, scaled(1, 3, 5)), {-0.33359, 1, -0.09183}},
      {"no_bump_scale <1,3,5>", unscaled(bumps(Bumps{}, scaled(1, 3, 5))), {-0.11262, 1, -0.031}},
      {"rotate y*90", bumps(Bumps{}, turned), {-0.23535, 0.96476, 0.11767}},
      {"bump_size 2", strong(bumps(Bumps{})), {-0.29431, 0.72483, -0.6229}},
      {"quilted", bumps(Quilted{}), {-0.14456, 0.96544, -0.21685}},
      {"quilted controls", bumps(Quilted{0.3, 0.7}), {-0.08647, 0.98777, -0.12969}},
      {"ripples", bumps(Ripples{}), {0.1468, 0.97467, 0.16869}},
      {"ripples frequency", waving(bumps(Ripples{})), {0.06624, 0.9977, 0.01462}},
      {"waves", bumps(Waves{}), {0.02916, 0.93305, 0.35857}},
      {"waves frequency", waving(bumps(Waves{})), {-0.02903, 0.97189, -0.23366}},
      {"onion", bumps(Onion{}), {-0.05501, 0.99777, -0.0377}},
      {"onion scale 2", bumps(Onion{}, scaled(2, 2, 2)), {-0.05463, 0.99776, -0.03846}},
      {"onion scale <2,1,1>", bumps(Onion{}, scaled(2, 1, 1)), {-0.02015, 0.99831, -0.05444}},
      {"onion turbulence", bumps(Onion{}, turbulent), {-0.02395, 0.99954, -0.01874}},
      {"onion accuracy", accurate(bumps(Onion{}), 0.1), {-0.05321, 0.99777, -0.04037}},
      {"onion bump_size 2", strong(bumps(Onion{})), {-0.21345, 0.96595, -0.14627}},
      {"onion slope_map", profiled(bumps(Onion{})), {-0.01109, 0.99992, -0.00657}},
      {"checker near an edge", bumps(Checker{}), {0, 1, 0}},
  };
}

TEST(Normal, AgreesWithRenderedValues) {
  for (const KnownNormal& known : known_normals()) {
    Scene scene;
    const NormalId id = append(scene.normals, known.normal);
    const Vec3 found = compiled(scene)->perturb(id, {0.3, 0, 0.2}, {0, 1, 0});
    EXPECT_NEAR(length(found), 1, 1e-12) << known.name;
    EXPECT_LT(length(found - normalize(known.expected)), 6e-5) << known.name;
  }
}

TEST(Normal, MapsAndAveragesMixUnitNormals) {
  Scene scene;
  const NormalId onion = append(scene.normals, bumps(Onion{}));
  const NormalId noisy = append(scene.normals, bumps(Bumps{}));
  const auto map = [&](std::vector<Warp> warps) {
    Pattern pattern = with(Gradient{{1, 0, 0}});
    pattern.warps = std::move(warps);
    Normal normal;
    normal.data = NormalMapNormal{pattern, {{0, onion}, {1, noisy}}, false};
    return append(scene.normals, normal);
  };
  Normal average;
  average.data = AverageNormal{{{1, onion}, {2, noisy}}, {}};
  const NormalId plain = map({}), scaled = map({TransformWarp{scaling({2, 2, 2})}});
  const NormalId mean = append(scene.normals, average);
  const auto textures = compiled(scene);
  const auto near = [&](NormalId id, Vec3 expected) {
    EXPECT_LT(length(textures->perturb(id, {0.3, 0, 0.2}, {0, 1, 0}) - normalize(expected)), 6e-5);
  };
  near(plain, {-0.05933, 0.99575, -0.0704});
  near(scaled, {-0.06356, 0.99612, -0.06107});
  near(mean, {-0.06453, 0.9918, -0.11028});
}

TEST(Texture, BringsNormalsOutOfItsSpaces) {
  Scene scene;
  const PigmentId white = solid(scene, {{1, 1, 1}});
  const NormalId noisy = append(scene.normals, bumps(Bumps{}));
  const Affine twice = scaling({2, 2, 2});
  const TextureId by_layer = layered(scene, {{white, noisy, {}, twice}});
  const TextureId plain = layered(scene, {{white, noisy, {}, {}}});
  Texture moved = scene.textures[plain.index];
  moved.transform = twice;
  const TextureId by_texture = append(scene.textures, moved);
  Pattern pattern = with(Gradient{{1, 0, 0}});
  pattern.warps = {TransformWarp{twice}};
  const TextureId by_map =
      append(scene.textures, Texture{TextureMap{pattern, {{0, plain}, {1, plain}}, false}, {}});
  const auto textures = compiled(scene);
  for (const TextureId id : {by_layer, by_texture, by_map}) {
    TextureSample sample;
    textures->evaluate(id, kPoint, sample);
    ASSERT_EQ(sample.layers.size(), 1u);
    EXPECT_LT(length(sample.layers[0].normal - normalize({-0.11341, 0.97552, -0.18846})), 6e-5);
  }
}

TEST(TextureEvaluator, SurvivesOddPointsAndEmptyDescriptions) {
  Scene scene;
  for (int kind = 0; kind < 6; ++kind) {
    Pigment pigment;
    if (kind == 1) pigment.data = ColorMapPigment{};
    if (kind == 2) pigment.data = PigmentMapPigment{};
    if (kind == 3) pigment.data = AveragePigment{};
    if (kind == 4) pigment.data = ImagePigment{};
    if (kind == 5) pigment.data = UvPigment{};
    const PigmentId id = append(scene.pigments, pigment);
    Normal normal;
    if (kind == 1) normal.data = NormalMapNormal{};
    if (kind == 2) normal.data = AverageNormal{};
    if (kind == 3) normal.data = BumpMapNormal{};
    if (kind == 4) normal.data = UvNormal{};
    layered(scene, {{id, append(scene.normals, normal), {}, {}}});
    Texture texture;
    if (kind == 1) texture.data = TextureMap{};
    if (kind == 2) texture.data = AverageTexture{};
    if (kind == 3) texture.data = MaterialMap{};
    if (kind == 4) texture.data = UvTexture{};
    append(scene.textures, texture);
  }
  const auto textures = compiled(scene);
  TextureSample sample;
  const double odd[] = {0, 1e300, -1e300, std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()};
  for (std::uint32_t i = 0; i < scene.textures.size(); ++i) {
    for (const double v : odd) {
      TexturePoint point = kPoint;
      point.position = {v, v, v};
      textures->evaluate({i}, point, sample);
      textures->transmittance({i}, point);
      for (const SurfaceLayer& layer : sample.layers) EXPECT_NEAR(length(layer.normal), 1, 1e-9);
    }
  }
  textures->evaluate({}, kPoint, sample);
  EXPECT_TRUE(sample.stacks.empty());
  EXPECT_EQ(textures->call({}, {}), 0);
}

TEST(TextureEvaluator, BoundsTheDepthOfChains) {
  Scene scene;
  PigmentId id = solid(scene, {{1, 1, 1}});
  for (int i = 0; i < 20000; ++i) {
    Pigment average;
    average.data = AveragePigment{{{1, id}}, {}};
    id = append(scene.pigments, average);
  }
  compiled(scene)->pigment(id, {});
}

}  // namespace
}  // namespace dioptre
