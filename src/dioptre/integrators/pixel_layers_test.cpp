// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/pixel_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dioptre/integrators/render_image.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kWidth = 24, kHeight = 18;

TextureId texture(Scene& scene, PigmentColor color, const Finish& finish) {
  const PigmentId pigment = append(scene.pigments, Pigment{SolidPigment{color}, {}, false});
  return append(scene.textures, Texture{LayeredTexture{{{pigment, {}, finish, {}}}}, {}});
}

Finish glow(float ambient) {
  Finish finish;
  finish.diffuse = 0;
  finish.ambient = {ambient, ambient, ambient};
  return finish;
}

Finish mirror(float share) {
  Finish finish = glow(0);
  finish.reflection_min = finish.reflection_max = {share, share, share};
  return finish;
}

void add(Scene& scene, ShapeData shape, TextureId texture, InteriorId interior = {}) {
  Object object;
  object.geometry = std::move(shape);
  object.texture = texture;
  object.interior = interior;
  scene.roots.push_back(append(scene.objects, object));
}

Scene empty_scene() {
  Scene scene;
  scene.default_texture = texture(scene, {{1, 1, 1}}, {});
  scene.camera.location = {0, 1, -5};
  return scene;
}

/// Tinted glass, mirrors and highlights in a mist, under two lights.
Scene all_terms() {
  Scene scene = empty_scene();
  Finish shiny;
  shiny.phong = 0.5;
  shiny.reflection_min = shiny.reflection_max = {0.4f, 0.4f, 0.4f};
  add(scene, Sphere{{0, 1, 0}, 1}, texture(scene, {{1, 0.3f, 0.2f}, 0.5f, 0.2f}, shiny),
      append(scene.interiors, Interior{.ior = 1.5, .has_ior = true}));
  add(scene, Plane{{0, 1, 0}, 0}, texture(scene, {{0.7f, 0.8f, 1}}, shiny));
  scene.lights.push_back({.location = {4, 8, -5}});
  scene.lights.push_back({.location = {-4, 3, -2}});
  scene.atmosphere.background = {0.2f, 0.3f, 0.6f};
  scene.atmosphere.fogs.push_back({.distance = 20, .color = {{0.5f, 0.5f, 0.5f}}});
  return scene;
}

RenderOptions options_for(LayerSet layers, std::uint32_t antialias = 0, std::uint32_t threads = 2) {
  RenderOptions options;
  options.width = kWidth, options.height = kHeight;
  options.layers = layers;
  options.antialias.method = antialias;
  options.antialias.threshold = 0.1;
  options.threads = threads;
  return options;
}

RenderResult render(const Scene& scene, const RenderOptions& options) {
  auto result = render_image(scene, {}, options, {});
  EXPECT_TRUE(result) << result.error().message;
  return result ? std::move(*result) : RenderResult{};
}

const std::vector<float>& values(const RenderResult& result, LayerKind kind) {
  static const std::vector<float> kNone;
  const std::string_view name = layer_info(kind).name;
  const auto found = std::find_if(result.layers.begin(), result.layers.end(),
                                  [&](const ImageLayer& layer) { return layer.name == name; });
  EXPECT_NE(found, result.layers.end()) << name;
  return found == result.layers.end() ? kNone : found->values;
}

/// The terms of the pixel that a picture of one pixel is, red.
std::array<float, kTerms> terms_of(const Scene& scene, LengthAttenuation attenuation = {}) {
  RenderOptions options = options_for(LayerSet::terms());
  options.width = options.height = 1;
  options.integrator_options.attenuation = attenuation;
  const RenderResult result = render(scene, options);
  std::array<float, kTerms> terms{};
  for (std::size_t i = 0; i < kTerms; ++i) terms[i] = result.layers[i].values[0];
  return terms;
}

/// A ray straight ahead from the origin.
Scene one_ray() {
  Scene scene = empty_scene();
  scene.camera.location = {0, 0, 0};
  return scene;
}

void expect_sum(const RenderResult& result) {
  for (std::size_t at = 0; at < result.image.pixels.size(); ++at) {
    Color sum;
    for (std::size_t term = 0; term < kTerms; ++term) {
      const float* v = &result.layers[term].values[3 * at];
      sum += {v[0], v[1], v[2]};
    }
    const Color color = result.image.pixels[at];
    const float bound = 1e-6f * std::max(1.0f, max_component(abs(color)));
    EXPECT_LE(max_component(abs(sum - color)), bound) << "pixel " << at;
  }
}

TEST(PixelLayers, TheTermsSumToThePictureWhateverIsAveraged) {
  Scene scene = all_terms();
  for (const double aperture : {0.0, 0.3}) {
    scene.camera.aperture = aperture;
    scene.camera.focal_distance = 5;
    for (const std::uint32_t antialias : {0u, 1u, 2u}) {
      const RenderResult result = render(scene, options_for(LayerSet::terms(), antialias));
      ASSERT_EQ(result.layers.size(), kTerms);
      expect_sum(result);
      for (const ImageLayer& term : result.layers) {
        EXPECT_GT(*std::max_element(term.values.begin(), term.values.end()), 0) << term.name;
      }
    }
  }
}

TEST(PixelLayers, ThePictureIsTheSameWithThem) {
  const Scene scene = all_terms();
  for (const std::uint32_t antialias : {0u, 1u, 2u}) {
    const RenderResult plain = render(scene, options_for({}, antialias));
    EXPECT_TRUE(plain.layers.empty());
    for (const LayerSet layers : {LayerSet::terms(), LayerSet::costs(), LayerSet::all()}) {
      const RenderResult result = render(scene, options_for(layers, antialias));
      EXPECT_EQ(result.image.pixels, plain.image.pixels);
      EXPECT_EQ(result.image.alpha, plain.image.alpha);
      EXPECT_EQ(result.rays.total(), plain.rays.total());
    }
  }
}

TEST(PixelLayers, ThreadsChangeNothingButTheTime) {
  const Scene scene = all_terms();
  for (const std::uint32_t antialias : {0u, 1u, 2u}) {
    const RenderResult one = render(scene, options_for(LayerSet::all(), antialias, 1));
    const RenderResult four = render(scene, options_for(LayerSet::all(), antialias, 4));
    ASSERT_EQ(one.layers.size(), kLayerKinds);
    for (std::size_t i = 0; i < kLayerKinds; ++i) {
      if (one.layers[i].name != "time") {
        EXPECT_EQ(one.layers[i].values, four.layers[i].values) << one.layers[i].name;
      }
    }
  }
}

TEST(PixelLayers, OnlyWhatIsWantedIsMadeAndIsTheSameAlone) {
  const RenderResult whole = render(all_terms(), options_for(LayerSet::all(), 1));
  for (const LayerInfo& info : layer_infos()) {
    LayerSet wanted;
    wanted.add(info.kind);
    const RenderResult result = render(all_terms(), options_for(wanted, 1));
    ASSERT_EQ(result.layers.size(), 1u);
    EXPECT_EQ(result.layers[0].name, info.name);
    EXPECT_EQ(result.layers[0].values.size(), kWidth * kHeight * info.channels.size());
    if (info.kind == LayerKind::kTime) continue;
    EXPECT_EQ(result.layers[0].values, values(whole, info.kind)) << info.name;
  }
}

TEST(PixelLayers, TheRaysOfAllPixelsAreThoseOfThePicture) {
  for (const std::uint32_t antialias : {0u, 1u, 2u}) {
    const RenderResult result = render(all_terms(), options_for(LayerSet::costs(), antialias));
    const auto& rays = values(result, LayerKind::kRays);
    EXPECT_EQ(std::accumulate(rays.begin(), rays.end(), 0.0),
              static_cast<double>(result.rays.total()));
    const auto& times = values(result, LayerKind::kTime);
    EXPECT_GE(*std::min_element(times.begin(), times.end()), 0);
    EXPECT_GT(std::accumulate(times.begin(), times.end(), 0.0), 0);
  }
}

TEST(PixelLayers, DepthIsTheDistanceToTheFirstSurface) {
  Scene scene = one_ray();
  scene.camera.right = {1, 0, 0};
  RenderOptions options = options_for(LayerSet::costs());
  options.height = kWidth;
  const RenderResult empty = render(scene, options);
  for (const float depth : values(empty, LayerKind::kDepth)) {
    EXPECT_EQ(depth, std::numeric_limits<float>::infinity());
  }
  const TextureId glass = texture(scene, {{1, 1, 1}, 0, 0.9f}, {});
  add(scene, Plane{{0, 0, -1}, -7}, glass);
  add(scene, Plane{{0, 0, -1}, -9}, glass);
  const RenderResult result = render(scene, options);
  const auto& depths = values(result, LayerKind::kDepth);
  for (std::uint32_t at = 0; at < depths.size(); ++at) {
    const double x = (at % kWidth + 0.5) / kWidth - 0.5, y = (at / kWidth + 0.5) / kWidth - 0.5;
    EXPECT_NEAR(depths[at], 7 * std::sqrt(1 + x * x + y * y), 1e-5);
  }
}

TEST(PixelLayers, SpansAreTheCrossingsUpToWhereRaysEnd) {
  Scene scene = one_ray();
  RenderOptions options = options_for(LayerSet::costs());
  options.width = options.height = 1;
  const auto spans = [&] { return values(render(scene, options), LayerKind::kSpans)[0]; };
  const TextureId clear = texture(scene, {{1, 1, 1}, 0, 1}, {});
  EXPECT_EQ(spans(), 0);
  add(scene, Sphere{{0, 0, 5}, 1}, clear);
  EXPECT_EQ(spans(), 2);  // into it, and on
  add(scene, Sphere{{0, 0, 9}, 1}, clear);
  EXPECT_EQ(spans(), 4);
  add(scene, Sphere{{0, 0, 13}, 1}, texture(scene, {{1, 1, 1}}, {}));
  EXPECT_EQ(spans(), 5);  // its back is not looked for
}

TEST(PixelLayers, EachTermIsWhatItsNameSays) {
  Scene scene = one_ray();
  scene.atmosphere.background = {0.25f, 0, 0};
  EXPECT_EQ(terms_of(scene), (std::array<float, kTerms>{0.25f, 0, 0, 0, 0}));
  Scene wall = scene;
  add(wall, Plane{{0, 0, -1}, -5}, texture(wall, {{1, 1, 1}}, glow(0.5f)));
  EXPECT_EQ(terms_of(wall), (std::array<float, kTerms>{0.5f, 0, 0, 0, 0}));
  Scene silver = scene;
  add(silver, Plane{{0, 0, -1}, -5}, texture(silver, {{1, 1, 1}}, mirror(0.5f)));
  EXPECT_EQ(terms_of(silver), (std::array<float, kTerms>{0, 0, 0, 0.125f, 0}));
  Scene pane = scene;
  add(pane, Plane{{0, 0, -1}, -5}, texture(pane, {{1, 1, 1}, 0, 1}, glow(0.5f)));
  EXPECT_EQ(terms_of(pane), (std::array<float, kTerms>{0, 0, 0, 0, 0.25f}));
  Scene lit = scene;
  Finish phong = glow(0);
  phong.phong = 0.5;
  add(lit, Plane{{0, 0, -1}, -5}, texture(lit, {{0, 0, 0}}, phong));
  lit.lights.push_back({.location = {0, 0, -1}});
  EXPECT_EQ(terms_of(lit), (std::array<float, kTerms>{0, 0, 0.5f, 0, 0}));
  Scene matte = scene;
  Finish diffuse = glow(0);
  diffuse.diffuse = 0.5;
  add(matte, Plane{{0, 0, -1}, -5}, texture(matte, {{1, 1, 1}}, diffuse));
  matte.lights.push_back({.location = {0, 0, -1}});
  EXPECT_EQ(terms_of(matte), (std::array<float, kTerms>{0, 0.5f, 0, 0, 0}));
}

TEST(LengthAttenuation, MirroredAndTransmittedLightFallsWithTheLengthOfTheRay) {
  Scene scene = one_ray();
  add(scene, Plane{{0, 0, 1}, -4}, texture(scene, {{1, 1, 1}}, glow(0.8f)));  // behind the eye
  add(scene, Plane{{0, 0, -1}, -5}, texture(scene, {{1, 1, 1}, 0, 0.5f}, mirror(0.5f)));
  add(scene, Plane{{0, 0, -1}, -8}, texture(scene, {{1, 1, 1}}, glow(0.6f)));
  const auto plain = terms_of(scene);
  EXPECT_FLOAT_EQ(plain[3], 0.4f);
  EXPECT_FLOAT_EQ(plain[4], 0.3f);
  for (const double k : {0.0, 0.01, 0.1, 0.3}) {
    EXPECT_NEAR(terms_of(scene, {.reflected = k})[3], 0.4 * std::exp(-9 * k), 1e-6);
    EXPECT_EQ(terms_of(scene, {.reflected = k})[4], plain[4]);
    EXPECT_NEAR(terms_of(scene, {.transmitted = k})[4], 0.3 * std::exp(-3 * k), 1e-6);
    EXPECT_EQ(terms_of(scene, {.transmitted = k})[3], plain[3]);
  }
}

TEST(LengthAttenuation, TheTermsStillSumAndTheEyeAndTheSkyAreSpared) {
  const LengthAttenuation strong{1e300, 1e300};
  Scene scene = one_ray();
  scene.atmosphere.background = {0.25f, 0, 0};
  add(scene, Plane{{0, 0, -1}, -5}, texture(scene, {{1, 1, 1}}, mirror(0.5f)));
  EXPECT_EQ(terms_of(scene, strong), terms_of(scene));
  RenderOptions options = options_for(LayerSet::terms(), 1);
  for (const LengthAttenuation& each : {LengthAttenuation{0.1, 0.3}, strong}) {
    options.integrator_options.attenuation = each;
    expect_sum(render(all_terms(), options));
  }
}

}  // namespace
}  // namespace dioptre
