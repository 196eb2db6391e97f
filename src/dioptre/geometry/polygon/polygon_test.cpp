// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/polygon/polygon.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace dioptre
