// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/prism/prism.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre {
namespace {

/// Where a ray along x at height 0.5 and the given z first meets the prism.
double first_x(const Prism& prism, double from, double z) {
  const ShapePtr shape = prepare(prism).value();
  const Ray ray{{from, 0.5, z}, {from < 0 ? 1.0 : -1.0, 0, 0}};
  Crossings out;
  shape->crossings(ray, {0, kInfinity}, out);
  return out.empty() ? std::nan("") : ray.at(out[0].t).x;
}

// Reference values: the same prisms in POV-Ray 3.7, by its trace() function.
TEST(Prism, QuadraticSplineIsThatOfPovRay) {
  Prism p;
  p.spline = OutlineSpline::kQuadratic;
  p.outlines = {{{0.3, -1.2}, {1, -1}, {1.4, 1}, {-1, 1.2}, {-1, -1}, {1, -1}}};
  EXPECT_NEAR(first_x(p, -10, -0.9), -1.034608112, 1e-9);
  EXPECT_NEAR(first_x(p, -10, 0.6), -1.288957264, 1e-9);
  EXPECT_NEAR(first_x(p, 10, 0.3), 1.323935349, 1e-9);
  EXPECT_NEAR(first_x(p, 10, 0.9), 1.391102745, 1e-9);
}

TEST(Prism, CubicSplineIsThatOfPovRay) {
  Prism p;
  p.spline = OutlineSpline::kCubic;
  p.outlines = {{{0.3, -1.2}, {1, -1}, {1.4, 1}, {0, 0.3}, {-1, 1.2}, {-1, -1}, {1, -1}, {2, 2}}};
  EXPECT_NEAR(first_x(p, -10, -0.9), -1.065567625, 1e-9);
  EXPECT_NEAR(first_x(p, -10, 0.9), -1.100961199, 1e-9);
  EXPECT_NEAR(first_x(p, 10, 0), 1.318128690, 1e-9);
  EXPECT_NEAR(first_x(p, 10, 0.9), 1.434433039, 1e-9);
}

TEST(Prism, BezierSplineIsThatOfPovRay) {
  Prism p;
  p.spline = OutlineSpline::kBezier;
  p.outlines = {{{0, 0}, {0, 1}, {1, 2}, {2, 2}, {2, 2}, {3, 1}, {2, 0}, {0, 0}}};
  EXPECT_NEAR(first_x(p, -10, 1), 0.319955209, 1e-9);
  EXPECT_NEAR(first_x(p, 10, 1), 2.360089581, 1e-9);
}

TEST(Prism, ConicSweepIsMirroredBelowTheOrigin) {
  Prism p;
  p.conic = true;
  p.height1 = 2;
  p.height2 = -1;
  p.outlines = {{{1, 1}, {-1, 1}, {-1, -1}, {0.5, -1}, {1, 1}}};
  const ShapePtr shape = prepare(p).value();
  EXPECT_TRUE(shape->contains({-0.49, 0.5, 0.1}));
  EXPECT_FALSE(shape->contains({-0.51, 0.5, 0.1}));
  EXPECT_TRUE(shape->contains({0.49, -0.5, 0.1}));
  EXPECT_FALSE(shape->contains({0.51, -0.5, 0.1}));
}

TEST(Prism, HolesAreEvenOddAndOpenHidesTheCaps) {
  Prism p;
  p.outlines = {{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}},
                {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
  p.open = true;
  const ShapePtr shape = prepare(p).value();
  Crossings out;
  shape->crossings({{-5, 0.5, 0.3}, {1, 0, 0}}, Interval::all(), out);
  ASSERT_EQ(out.size(), 4u);
  EXPECT_EQ(out[0].t, 3);
  EXPECT_EQ(out[1].t, 4);
  EXPECT_EQ(out[2].t, 6);
  EXPECT_EQ(out[3].t, 7);
  EXPECT_TRUE(out[0].visible);
  out.clear();
  shape->crossings({{1.5, 5, 0}, {0, -1, 0}}, Interval::all(), out);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_FALSE(out[0].visible);
  EXPECT_EQ(out[0].t, 4);
  EXPECT_EQ(out[1].t, 5);
}

TEST(Prism, RaysThroughCornersAndAlongSidesHaveAnEvenNumberOfCrossings) {
  Prism p;
  p.outlines = {{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {0, 2}}};
  const ShapePtr shape = prepare(p).value();
  for (const Vec2 corner : p.outlines[0]) {
    for (int k = 0; k < 360; k += 15) {
      const double angle = k * std::acos(-1) / 180;
      const Vec3 d{k % 90 == 0 ? std::round(std::cos(angle)) : std::cos(angle), 0,
                   k % 90 == 0 ? std::round(std::sin(angle)) : std::sin(angle)};
      Crossings out;
      shape->crossings({Vec3{corner.x, 0.5, corner.y} - 3 * d, d}, Interval::all(), out);
      EXPECT_EQ(out.size() % 2, 0u);
    }
  }
}

TEST(Prism, ScaleDoesNotMatter) {
  for (int k = -12; k <= 12; ++k) {
    const double s = std::pow(10, k);
    Prism p;
    p.spline = OutlineSpline::kCubic;
    p.height2 = s;
    p.outlines = {{{0.3, -1.2}, {1, -1}, {1.4, 1}, {0, 0.3}, {-1, 1.2}, {-1, -1}, {1, -1}, {2, 2}}};
    for (Vec2& v : p.outlines[0]) v = s * v;
    Crossing c;
    ASSERT_TRUE(prepare(p).value()->nearest({{10 * s, 0.5 * s, 0}, {-1, 0, 0}}, {0, kInfinity}, c));
    EXPECT_NEAR(c.t / s, 10 - 1.318128690, 1e-9);
    EXPECT_LT(c.error, 1e-13 * s);
  }
}

TEST(Prism, WrongParametersAreRefused) {
  Prism p;
  EXPECT_EQ(prepare(p).error().message, "prism needs an outline");
  p.outlines = {{{0, 0}, {1, 0}}};
  EXPECT_EQ(prepare(p).error().message,
            "prism needs at least 3 points for a linear spline, found 2");
  p.outlines = {{{0, 0}, {1, 0}, {0, std::nan("")}}};
  EXPECT_EQ(prepare(p).error().message, "prism point is not finite");
  p.spline = OutlineSpline::kBezier;
  p.outlines = {{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 0}}};
  EXPECT_EQ(prepare(p).error().message,
            "prism needs four points for each bezier segment, found 5 points");
}

}  // namespace
}  // namespace dioptre
