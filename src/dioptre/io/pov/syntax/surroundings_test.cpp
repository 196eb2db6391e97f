// SPDX-License-Identifier: Apache-2.0
// Light groups and rainbows as they are read.
#include "dioptre/io/pov/syntax/syntax_test_support.h"

namespace dioptre::pov {
namespace {

TEST(LightGroup, ItsLightsAndObjectsShareANumberOfTheirOwn) {
  const Scene scene = scene_of(
      "light_source { y, 1 } light_group { light_source { y, 1 } sphere { 0, 1 } } "
      "light_group { light_source { y, 1 } sphere { x, 1 } global_lights on }");
  ASSERT_EQ(scene.lights.size(), 3u);
  ASSERT_EQ(scene.roots.size(), 2u);
  const Object first = at(scene.objects, scene.roots[0]),
               second = at(scene.objects, scene.roots[1]);
  EXPECT_EQ(scene.lights[0].group, 0u);
  EXPECT_NE(first.light_group, 0u);
  EXPECT_NE(first.light_group, second.light_group);
  EXPECT_EQ(scene.lights[1].group, first.light_group);
  EXPECT_EQ(scene.lights[2].group, second.light_group);
  EXPECT_FALSE(first.global_lights);
  EXPECT_TRUE(second.global_lights);
}

TEST(LightGroup, AGroupWithinAGroupKeepsItsOwnLights) {
  const Scene scene = scene_of(
      "light_group { light_source { y, 1 } sphere { 0, 1 } "
      "light_group { light_source { z, 1 } sphere { x, 1 } } }");
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_NE(scene.lights[0].group, scene.lights[1].group);
}

TEST(LightGroup, WithoutObjectsLightsNothing) {
  EXPECT_TRUE(scene_of("light_group { light_source { y, 1 } }").lights.empty());
}

TEST(Rainbow, AllItsPropertiesAreRead) {
  const Scene scene = scene_of(
      "rainbow { angle 40 width 5 distance 1e7 direction x up z jitter 0.01 arc_angle 120 "
      "falloff_angle 60 color_map { [0 rgb x] [1 rgbf <0, 0, 1, 0.5>] } rotate 90*y }");
  ASSERT_EQ(scene.atmosphere.rainbows.size(), 1u);
  const Rainbow& rainbow = scene.atmosphere.rainbows[0];
  EXPECT_EQ(rainbow.angle, 40);
  EXPECT_EQ(rainbow.width, 5);
  EXPECT_EQ(rainbow.distance, 1e7);
  EXPECT_EQ(rainbow.jitter, 0.01);
  EXPECT_EQ(rainbow.arc_angle, 120);
  EXPECT_EQ(rainbow.falloff_angle, 60);
  EXPECT_NEAR(length(rainbow.direction - Vec3{0, 0, -1}), 0, 1e-12);
  EXPECT_NEAR(length(rainbow.up - Vec3{1, 0, 0}), 0, 1e-12);
  ASSERT_EQ(rainbow.colors.size(), 2u);
  EXPECT_EQ(rainbow.colors[1].color.filter, 0.5f);
}

TEST(Rainbow, ADeclaredOneIsCopied) {
  const Scene scene = scene_of(
      "#declare Bow = rainbow { angle 40 width 5 distance 10 color_map { [0 rgb 1] [1 rgb 0] } } "
      "rainbow { Bow } rainbow { Bow width 7 }");
  ASSERT_EQ(scene.atmosphere.rainbows.size(), 2u);
  EXPECT_EQ(scene.atmosphere.rainbows[0].width, 5);
  EXPECT_EQ(scene.atmosphere.rainbows[1].width, 7);
  EXPECT_EQ(scene.atmosphere.rainbows[1].colors.size(), 2u);
}

}  // namespace
}  // namespace dioptre::pov
