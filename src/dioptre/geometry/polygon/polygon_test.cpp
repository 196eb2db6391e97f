// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/polygon/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "dioptre/geometry/outline/outline.h"
#include "dioptre/geometry/polygon/angle_sum.h"

namespace dioptre {
namespace {

bool meets(const Shape& shape, Vec3 from, Vec3 direction) {
  Crossing c;
  return shape.nearest({from, direction}, {0, kInfinity}, c);
}

TEST(Polygon, HolesAndNotchesAreEvenOdd) {
  Polygon p;
  p.outlines = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {0, 4, 0}},
                {{1, 1, 0}, {1.5, 1, 0}, {1.5, 1.5, 0}, {1, 1.5, 0}, {1, 1, 0}}};
  const ShapePtr shape = prepare(p).value();
  EXPECT_FALSE(shape->solid());
  EXPECT_TRUE(meets(*shape, {0.5, 0.5, -1}, {0, 0, 1}));
  EXPECT_FALSE(meets(*shape, {1.2, 1.2, -1}, {0, 0, 1}));
  EXPECT_FALSE(meets(*shape, {2, 3, -1}, {0, 0, 1}));
  EXPECT_TRUE(meets(*shape, {3.5, 3, 1}, {0, 0, -0.1}));
  EXPECT_FALSE(meets(*shape, {3.5, 3, 1}, {0, 0, 1}));
  EXPECT_FALSE(meets(*shape, {3.5, 3, 0}, {1, 0, 0}));
}

TEST(Polygon, TilesShareTheirEdgesWithoutGapOrOverlap) {
  Polygon left, right;
  left.outlines = {{{0, 0, 0}, {0.7, 0, 0.1}, {0.3, 1, 0.2}, {0, 1, 0.1}}};
  right.outlines = {{{0.7, 0, 0.1}, {1, 0, 0}, {1, 1, 0.3}, {0.3, 1, 0.2}}};
  for (auto* p : {&left, &right}) {
    for (Vec3& v : p->outlines[0]) v.z = 0;
  }
  const ShapePtr a = prepare(left).value(), b = prepare(right).value();
  for (int i = 1; i < 1000; ++i) {
    const double y = i / 1000.0;
    const Vec3 from{0.7 - 0.4 * y, y, -1};
    EXPECT_NE(meets(*a, from, {0, 0, 1}), meets(*b, from, {0, 0, 1})) << y;
  }
}

// As POV-Ray 3.7 measures: the first three points that are not on one line make the plane.
TEST(Polygon, ThePlaneIsThatOfTheFirstPointsNotOnOneLine) {
  Polygon p;
  p.outlines = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 1}, {0, 1, 1}}};
  const ShapePtr shape = prepare(p).value();
  const Ray ray{{0.2, 0.3, -3}, {0, 0, 1}};
  Crossing c;
  ASSERT_TRUE(shape->nearest(ray, {0, kInfinity}, c));
  EXPECT_NEAR(c.t, 3.3, c.error);
  EXPECT_LT(c.error, 1e-14);
  EXPECT_NEAR(length(shape->surface(ray, c).normal - Vec3{0, -std::sqrt(0.5), std::sqrt(0.5)}), 0,
              1e-15);
}

TEST(Polygon, WrongParametersAreRefusedAndALineIsEmpty) {
  Polygon p;
  EXPECT_EQ(prepare(p).error().message, "polygon needs an outline");
  p.outlines = {{{0, 0, 0}, {1, 0, 0}}};
  EXPECT_EQ(prepare(p).error().message, "polygon needs at least three points, found 2");
  p.outlines = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}};
  EXPECT_TRUE(prepare(p).value()->bounds().empty());
  p.outlines[0][2].y = kInfinity;
  EXPECT_EQ(prepare(p).error().message, "polygon point is not finite");
}

/// A star-shaped outline around a center: simple, and as ragged as `jag` says.
std::vector<Vec2> star(std::mt19937_64& random, Vec2 center, double radius, double jag) {
  std::uniform_real_distribution<double> u(0, 1);
  const int corners = 3 + static_cast<int>(u(random) * 30);
  std::vector<Vec2> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.9 * u(random)) / corners;
    const double reach = radius * (1 - jag * u(random));
    outline.push_back(center + reach * Vec2{std::cos(angle), std::sin(angle)});
  }
  if (u(random) < 0.5) std::reverse(outline.begin(), outline.end());
  return outline;
}

TEST(Polygon, BothTestsAgreeOnAMillionPoints) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> u(-1.1, 1.1);
  int inside = 0;
  for (int k = 0; k < 200; ++k) {
    // Around a hole there is room for the outer outline; in the hole an island.
    const std::vector<std::vector<Vec2>> rings = {star(random, {}, 1, 0.5),
                                                  star(random, {}, 0.33, 0.6),
                                                  star(random, {0.01, 0.02}, 0.05, 0.3)};
    Outline outline;
    for (const std::vector<Vec2>& ring : rings) {
      outline.move_to(ring[0]);
      for (std::size_t i = 1; i < ring.size(); ++i) outline.add(line(ring[i - 1], ring[i]));
    }
    outline.close();
    for (int i = 0; i < 5000; ++i) {
      const Vec2 p{u(random), u(random)};
      const bool by_angles = inside_by_angles(rings, p);
      ASSERT_EQ(outline.contains_even_odd(p), by_angles) << k << ": " << p.x << ", " << p.y;
      inside += by_angles ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 100000);
}

// The products of such coordinates overflow: what is inside is unknown, that there is an answer
// not.
TEST(Polygon, BothTestsEndForPointsThatAreTooFarAway) {
  for (const double far : {1e155, 1e300, 1.7e308}) {
    Polygon polygon;
    polygon.outlines.assign(3, {{-far, -far, 0}, {far, -far, 0}, {far, far, 0}, {-far, far, 0}});
    for (const PolygonTest test : {PolygonTest::kCrossings, PolygonTest::kAngles}) {
      polygon.test = test;
      const ShapePtr shape = prepare(polygon).value();
      const Vec2 p{0.1 * far, 0.2 * far};
      meets(*shape, {p.x, p.y, -1}, {0, 0, 1});
      std::vector<Vec2> ring;
      for (const Vec3 corner : polygon.outlines[0]) ring.push_back({corner.x, corner.y});
      EXPECT_FALSE(inside_by_angles({ring, ring}, p));
    }
  }
}

TEST(Polygon, ThePictureDoesNotDependOnTheTest) {
  Polygon polygon;
  polygon.outlines = {{{-1, -1, 0}, {1, -1, 0}, {0.2, 0, 0}, {1, 1, 0}, {-1, 1, 0}},
                      {{-0.6, -0.4, 0}, {-0.1, -0.3, 0}, {-0.4, 0.5, 0}}};
  const ShapePtr one = prepare(polygon).value();
  polygon.test = PolygonTest::kAngles;
  const ShapePtr other = prepare(polygon).value();
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-1.2, 1.2);
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{{u(random), u(random), -2}, {0.3 * u(random), 0.3 * u(random), 1}};
    Crossing a, b;
    ASSERT_EQ(one->nearest(ray, {0, kInfinity}, a), other->nearest(ray, {0, kInfinity}, b));
  }
}

}  // namespace
}  // namespace dioptre
