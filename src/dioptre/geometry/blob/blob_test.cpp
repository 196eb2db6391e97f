// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/blob/blob.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre {
namespace {

BlobComponent ball(Vec3 center, double radius, double strength) {
  BlobComponent c;
  c.a = center;
  c.radius = radius;
  c.strength = strength;
  return c;
}

BlobComponent rod(Vec3 a, Vec3 b, double radius, double strength) {
  BlobComponent c = ball(a, radius, strength);
  c.b = b;
  c.cylinder = true;
  return c;
}

// Reference values: the same blob in POV-Ray 3.7, by its trace() function.
TEST(Blob, IsThatOfPovRay) {
  Blob blob;
  blob.threshold = 0.3;
  blob.components = {ball({}, 1, 1), rod({}, {2, 0, 0}, 0.5, 1), ball({0, 1, 0}, 0.8, -0.3)};
  blob.components[2].transform = scaling({1, 2, 1});
  const ShapePtr shape = prepare(blob).value();
  const struct {
    Ray ray;
    Vec3 point, normal;
  } cases[] = {
      {{{0.2, 0.3, -3}, {0, 0, 1}}, {0.2, 0.3, -0.567694850}, {0.297391, 0.446086, -0.844136}},
      {{{0.8, 0.1, 3}, {0, 0, -1}}, {0.8, 0.1, 0.340843288}, {0.231300, 0.273889, 0.933533}},
      {{{5, 0.1, 0.1}, {-1, 0, 0}}, {2.305072714, 0.1, 0.1}, {0.907258, 0.297391, 0.297391}},
      {{{-5, 0.1, 0.1}, {1, 0, 0}}, {-0.657478093, 0.1, 0.1}, {-0.977640, 0.148695, 0.148695}},
      {{{1.2, 0.1, -5}, {0, 0, 1}}, {1.2, 0.1, -0.321044172}, {0, 0.297391, -0.954756}},
  };
  for (const auto& each : cases) {
    Crossing c;
    ASSERT_TRUE(shape->nearest(each.ray, {0, kInfinity}, c));
    EXPECT_NEAR(length(each.ray.at(c.t) - each.point), 0, 2e-8);
    EXPECT_NEAR(length(shape->surface(each.ray, c).normal - each.normal), 0, 2e-6);
  }
}

TEST(Blob, OneBallIsASphereAtAnyScaleAndDistance) {
  const double radius = std::sqrt(1 - std::sqrt(0.25));
  for (int k = -12; k <= 12; ++k) {
    const double s = std::pow(10, k);
    Blob blob;
    blob.threshold = 0.25;
    blob.components = {ball({}, s, 1)};
    const ShapePtr shape = prepare(blob).value();
    for (double distance : {2.0, 1e3, 1e6, 1e9}) {
      Crossings out;
      shape->crossings({{0, 0, -distance * s}, {0, 0, 1}}, Interval::all(), out);
      ASSERT_EQ(out.size(), 2u);
      EXPECT_NEAR(out[0].t / s, distance - radius, 4e-16 * distance + 1e-13);
      EXPECT_NEAR(out[1].t / s, distance + radius, 4e-16 * distance + 1e-13);
      EXPECT_GE(out[0].error, std::fabs(out[0].t / s - (distance - radius)) * s * 0.5);
    }
  }
}

TEST(Blob, TheFaceIsTheStrongestComponent) {
  Blob blob;
  blob.threshold = 0.2;
  for (int i = 0; i < 10; ++i) blob.components.push_back(ball({1.0 * i, 0, 0}, 1, 1));
  const ShapePtr shape = prepare(blob).value();
  for (std::uint32_t i = 0; i < 10; ++i) {
    Crossing c;
    ASSERT_TRUE(shape->nearest({{i + 0.1, 5, 0}, {0, -1, 0}}, {0, kInfinity}, c));
    EXPECT_EQ(c.face, i);
  }
}

TEST(Blob, NegativeComponentsDoNotWidenTheBounds) {
  Blob blob;
  blob.threshold = 0.2;
  blob.components = {ball({}, 1, 1), ball({5, 0, 0}, 3, -1)};
  EXPECT_NEAR(prepare(blob).value()->bounds().max.x, 1, 1e-9);
  blob.components = {ball({}, 0, 1), ball({5, 0, 0}, 3, -1)};
  EXPECT_TRUE(prepare(blob).value()->bounds().empty());
}

TEST(Blob, WrongParametersAreRefused) {
  Blob blob;
  EXPECT_EQ(prepare(blob).error().message, "blob needs at least one component");
  blob.components = {rod({}, {}, 1, 1)};
  EXPECT_EQ(prepare(blob).error().message, "blob component is a cylinder without length");
  blob.components = {ball({}, std::nan(""), 1)};
  EXPECT_EQ(prepare(blob).error().message, "blob component is not finite");
  blob.components = {ball({}, 1, 1)};
  blob.components[0].transform = scaling({1, 0, 1});
  EXPECT_EQ(prepare(blob).error().message, "blob component has a singular transform");
}

}  // namespace
}  // namespace dioptre
