// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "dioptre/compare/comparison.h"
#include "dioptre/compare/reports.h"
#include "dioptre/core/rng.h"

namespace dioptre {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint32_t kBalls = 150;

/// Balls at random before a wall, some of them mirrors and some of glass.
Scene balls() {
  Scene scene;
  const auto texture = [&scene](PigmentColor color, float reflection) {
    Finish finish;
    finish.reflection_min = finish.reflection_max = {reflection, reflection, reflection};
    const PigmentId pigment = append(scene.pigments, Pigment{SolidPigment{color}, {}, false});
    return append(scene.textures, Texture{LayeredTexture{{{pigment, {}, finish, {}}}}, {}});
  };
  const std::array looks{texture({{1, 0.5f, 0.2f}}, 0), texture({{0.2f, 0.2f, 0.2f}}, 0.6f),
                         texture({{1, 1, 1}, 0.8f}, 0)};
  scene.default_texture = looks[0];
  scene.camera.location = {0, 0, -6};
  scene.lights.push_back({.location = {5, 8, -9}});
  for (std::uint32_t i = 0; i < kBalls; ++i) {
    const auto random = [i](std::uint32_t k) { return 4 * random_at(i, 0, 0, k) - 2; };
    Object ball;
    ball.geometry = Sphere{{random(0), random(1), random(2)}, 0.3};
    ball.texture = looks[i % 3];
    scene.roots.push_back(append(scene.objects, ball));
  }
  return scene;
}

RenderOptions small() {
  RenderOptions options;
  options.width = 40, options.height = 30;
  return options;
}

const Comparison& compared() {
  static const Scene scene = balls();
  const CompareOptions options{.sample = 1'000'000, .measured_seconds = 1e-4};
  static const auto comparison = compare_accelerators(scene, {}, small(), options, {}).value();
  return comparison;
}

TEST(Comparison, AllStructuresGiveTheSameImageAndHits) {
  EXPECT_EQ(compared().structures.size(), accelerator_names().size());
  EXPECT_TRUE(compared().all_equal());
  EXPECT_EQ(compared().items, kBalls);
}

TEST(Comparison, WithoutAStructureEveryBoxIsTested) {
  const StructureResult& none = compared().structures.back();
  ASSERT_EQ(none.name, "none");
  for (const RaySort sort : {RaySort::kEye, RaySort::kReflected, RaySort::kTransmitted}) {
    EXPECT_TRUE(compared().has(sort));
    EXPECT_EQ(none.cost[static_cast<std::size_t>(sort)].boxes, kBalls);
  }
  const double shadow = none.cost[static_cast<std::size_t>(RaySort::kShadow)].boxes;
  EXPECT_EQ(compared().speed(none), 1);
  EXPECT_GT(shadow, 0);
}

TEST(Comparison, EveryStructureIsMeasured) {
  for (const StructureResult& each : compared().structures) {
    for (const RayCost& cost : each.cost) {
      EXPECT_GT(cost.nanoseconds, 0) << each.name;
      EXPECT_GT(cost.items, 0) << each.name;
    }
    EXPECT_GT(each.render_seconds, 0) << each.name;
    EXPECT_GT(each.size.bytes, 0u) << each.name;
  }
}

TEST(Comparison, AnUnknownNameListsTheNames) {
  const auto known = check_accelerators({"bvh", "tree"});
  ASSERT_FALSE(known);
  for (const std::string_view name : accelerator_names()) {
    EXPECT_THAT(known.error().message, HasSubstr(std::string(name)));
  }
}

TEST(RaySample, HoldsAllRaysWhereThereAreNoMore) {
  for (const RaySort sort : kAllRaySorts) {
    EXPECT_EQ(compared().sampled[static_cast<std::size_t>(sort)], compared().traced(sort));
  }
}

TEST(RaySample, FollowsFromThePictureAlone) {
  const Scene scene = balls();
  const auto compiled = RenderScene::compile(scene, {}).value();
  RenderOptions options = small();
  options.threads = 1;
  const auto one = sample_rays(*compiled, options, compared().rays, 300).value();
  options.threads = 4;
  const auto many = sample_rays(*compiled, options, compared().rays, 300).value();
  for (std::size_t sort = 0; sort < kRaySorts; ++sort) {
    EXPECT_NEAR(static_cast<double>(one[sort].size()), 300, 100);
    ASSERT_EQ(one[sort].size(), many[sort].size());
    for (std::size_t i = 0; i < one[sort].size(); ++i) {
      EXPECT_EQ(one[sort][i].ray.origin, many[sort][i].ray.origin);
      EXPECT_EQ(one[sort][i].ray.direction, many[sort][i].ray.direction);
    }
  }
}

TEST(Reports, EveryLineOfTheCsvHasAllFields) {
  const std::string csv = csv_report(compared());
  std::vector<std::ptrdiff_t> commas;
  for (std::size_t begin = 0, end; begin < csv.size(); begin = end + 1) {
    end = csv.find('\n', begin);
    ASSERT_NE(end, std::string::npos);
    commas.push_back(std::count(csv.begin() + static_cast<std::ptrdiff_t>(begin),
                                csv.begin() + static_cast<std::ptrdiff_t>(end), ','));
  }
  EXPECT_EQ(commas.size(), compared().structures.size() + 1);
  EXPECT_THAT(commas, ::testing::Each(commas.front()));
}

TEST(Reports, TheTableFitsATerminal) {
  const std::string table = table_report(compared());
  for (std::size_t begin = 0, end; begin < table.size(); begin = end + 1) {
    end = table.find('\n', begin);
    EXPECT_LE(end - begin, 80u) << table.substr(begin, end - begin);
  }
  for (const std::string_view name : accelerator_names()) {
    EXPECT_THAT(table, HasSubstr(std::string("\n").append(name)));
  }
}

TEST(Reports, TheJsonIsReadAndNamesAllStructures) {
  const auto json = nlohmann::json::parse(json_report(compared()));
  EXPECT_EQ(json["structures"].size(), accelerator_names().size());
  EXPECT_TRUE(json["all_equal"]);
}

TEST(Reports, ThePageStandsAlone) {
  Comparison hostile = compared();
  hostile.title = "</script><img src=x>\xff";
  const std::string page = html_report(hostile, "PNG!");
  EXPECT_THAT(page, Not(HasSubstr("</script><img")));
  EXPECT_THAT(page, Not(HasSubstr("http://")));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,UE5HIQ=="));
}

TEST(Reports, AStructureThatDiffersIsNamed) {
  Comparison differing = compared();
  differing.structures[2].same_image = false;
  EXPECT_FALSE(differing.all_equal());
  EXPECT_THAT(in_words(differing).front(), HasSubstr(differing.structures[2].name));
  EXPECT_THAT(in_words(differing).front(), HasSubstr("DIFFERS"));
  EXPECT_THAT(table_report(differing), HasSubstr("OTHER"));
}

}  // namespace
}  // namespace dioptre
