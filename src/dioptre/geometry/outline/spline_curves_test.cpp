// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/outline/spline_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre {
namespace {

constexpr OutlineSpline kSplines[] = {OutlineSpline::kLinear, OutlineSpline::kQuadratic,
                                      OutlineSpline::kCubic, OutlineSpline::kBezier};

/// Points on a spiral, no two the same.
std::vector<Vec2> spiral(std::size_t count) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = 0.7 * static_cast<double>(i);
    points.push_back({(1 + a) * std::cos(a), (1 + a) * std::sin(a)});
  }
  return points;
}

TEST(SplineCurves, TheLeastPointsMakeOneCurve) {
  for (const OutlineSpline spline : kSplines) {
    const std::size_t least = least_points(spline, false);
    EXPECT_EQ(spline_curves(spline, spiral(least)).size(), 1u);
    EXPECT_TRUE(spline_curves(spline, spiral(least - 1)).empty());
    EXPECT_TRUE(spline_curves(spline, {}).empty());
    EXPECT_TRUE(check_points("lathe", spline, spiral(least), false));
    EXPECT_FALSE(check_points("lathe", spline, spiral(least - 1), false));
    EXPECT_GE(least_points(spline, true), least);
  }
}

TEST(SplineCurves, GoThroughTheirPointsWithoutGaps) {
  const std::vector<Vec2> points = spiral(9);
  for (const OutlineSpline spline :
       {OutlineSpline::kLinear, OutlineSpline::kQuadratic, OutlineSpline::kCubic}) {
    const std::size_t first = spline == OutlineSpline::kLinear ? 0 : 1;
    const std::vector<Curve> curves = spline_curves(spline, points);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_EQ(curves[i].begin(), points[first + i]);
      EXPECT_EQ(curves[i].end(), points[first + i + 1]);
    }
  }
}

TEST(SplineCurves, PointsOnALineMakeThatLine) {
  for (const OutlineSpline spline : kSplines) {
    std::vector<Vec2> points;
    for (int i = 0; i < 8; ++i) points.push_back({1.0 + 2 * i, 3.0 - i});
    for (const Curve& curve : spline_curves(spline, points)) {
      for (const double s : {0.0, 0.3, 0.5, 1.0}) {
        const Vec2 p = curve.at(s);
        EXPECT_NEAR(p.x + 2 * p.y, 7, 1e-12);
      }
    }
  }
}

TEST(SplineCurves, PointsThatMakeNoCurveAreRefused) {
  EXPECT_EQ(check_points("lathe", OutlineSpline::kCubic, spiral(3), false).error().message,
            "lathe needs at least 4 points for a cubic spline, found 3");
  EXPECT_EQ(check_points("prism", OutlineSpline::kBezier, spiral(6), true).error().message,
            "prism needs four points for each bezier segment, found 6 points");
  for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (const OutlineSpline spline : kSplines) {
      std::vector<Vec2> points = spiral(8);
      points[5].y = wrong;
      EXPECT_EQ(check_points("prism", spline, points, true).error().message,
                "prism point is not finite");
    }
  }
}

}  // namespace
}  // namespace dioptre
