// SPDX-License-Identifier: Apache-2.0
#include "dioptre/lights/light_source.h"

#include <gtest/gtest.h>

namespace dioptre {
namespace {

Light light_at(Vec3 location) {
  Light light;
  light.location = location;
  return light;
}

double strength(const Light& light, Vec3 point) {
  const auto found = LightSource(light).illuminate(point);
  return found ? found->intensity.g : 0;
}

TEST(LightSource, APointLightShinesAllAroundWithoutLoss) {
  const Light light = light_at({0, 2, 0});
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{5, 2, 0}, Vec3{0, 100, 3}}) {
    const auto found = LightSource(light).illuminate(p);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->intensity, (Color{1, 1, 1}));
    EXPECT_NEAR(length(p + found->distance * found->to_light - light.location), 0, 1e-12);
  }
}

TEST(LightSource, FadingIsOneAtTheFadeDistance) {
  for (const double power : {1.0, 2.0, 3.0}) {
    Light light = light_at({});
    light.fade_distance = 3;
    light.fade_power = power;
    EXPECT_NEAR(strength(light, {3, 0, 0}), 1, 1e-6);
    EXPECT_NEAR(strength(light, {6, 0, 0}), 2 / (1 + std::pow(2, power)), 1e-6);
  }
}

TEST(LightSource, ASpotIsFullInsideItsRadiusAndEndsAtItsFalloff) {
  Light light = light_at({0, 0, 0});
  light.kind = Light::Kind::kSpotlight;
  light.point_at = {0, 0, 1};
  light.radius = 20;
  light.falloff = 40;
  const auto at_angle = [&](double degrees) {
    const double a = degrees * 3.14159265358979 / 180;
    return strength(light, {std::sin(a), 0, std::cos(a)});
  };
  EXPECT_EQ(at_angle(0), 1);
  EXPECT_NEAR(at_angle(19.99), 1, 1e-6);
  EXPECT_EQ(at_angle(40.01), 0);
  EXPECT_EQ(at_angle(180), 0);
  // Half way in the cosine the edge is at one half.
  const double middle =
      (std::cos(20 * 3.14159265358979 / 180) + std::cos(40 * 3.14159265358979 / 180)) / 2;
  EXPECT_NEAR(at_angle(std::acos(middle) * 180 / 3.14159265358979), 0.5, 1e-5);
  for (double a = 0; a < 45; a += 0.5) EXPECT_GE(at_angle(a), at_angle(a + 0.5));
}

TEST(LightSource, ACylinderLightHasParallelRays) {
  Light light = light_at({0, 10, 0});
  light.kind = Light::Kind::kCylinder;
  light.point_at = {0, 0, 0};
  light.radius = 1;
  light.falloff = 2;
  for (const double x : {0.0, 0.5, 1.5}) {
    const auto found = LightSource(light).illuminate({x, 0, 0});
    ASSERT_TRUE(found);
    EXPECT_NEAR(length(found->to_light - Vec3{0, 1, 0}), 0, 1e-12);
  }
  EXPECT_FALSE(LightSource(light).illuminate({2.1, 0, 0}));
  EXPECT_FALSE(LightSource(light).illuminate({0, 11, 0}));
}

TEST(LightSource, AreaSamplesReachBothEndsOfTheAxes) {
  Light light = light_at({1, 2, 3});
  light.is_area = true;
  light.area.axis1 = {4, 0, 0};
  light.area.axis2 = {0, 0, 2};
  light.area.size1 = 5;
  light.area.size2 = 3;
  const LightSource source(light);
  EXPECT_EQ(source.sample(0, 0, {}), (Vec3{-1, 2, 2}));
  EXPECT_EQ(source.sample(4, 2, {}), (Vec3{3, 2, 4}));
  EXPECT_EQ(source.sample(2, 1, {}), light.location);
}

TEST(LightSource, ACircularAreaStaysInItsDisc) {
  Light light = light_at({});
  light.is_area = true;
  light.area.circular = true;
  light.area.axis1 = {2, 0, 0};
  light.area.axis2 = {0, 2, 0};
  light.area.size1 = light.area.size2 = 9;
  const LightSource source(light);
  for (std::uint32_t i = 0; i < 9; ++i) {
    for (std::uint32_t j = 0; j < 9; ++j) EXPECT_LE(length(source.sample(i, j, {})), 1 + 1e-12);
  }
}

TEST(LightSource, AnOrientedAreaFacesThePoint) {
  Light light = light_at({0, 5, 0});
  light.is_area = true;
  light.area.orient = true;
  light.area.size1 = light.area.size2 = 3;
  const LightSource source(light);
  for (const Vec3 p : {Vec3{3, 1, 2}, Vec3{0, 0, 0}, Vec3{-4, 9, 1}}) {
    const Vec3 towards = p - light.location;
    EXPECT_NEAR(dot(source.sample(0, 1, p) - light.location, towards), 0, 1e-12);
    EXPECT_NEAR(dot(source.sample(2, 0, p) - light.location, towards), 0, 1e-12);
  }
}

}  // namespace
}  // namespace dioptre
