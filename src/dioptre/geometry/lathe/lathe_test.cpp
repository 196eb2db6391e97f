// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/lathe/lathe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dioptre {
namespace {

/// Where a ray along -x at a height first meets the lathe.
double first_x(const Lathe& lathe, double y) {
  const ShapePtr shape = prepare(lathe).value();
  Crossing hit;
  const Ray ray{{10, y, 0}, {-1, 0, 0}};
  return shape->nearest(ray, {0, kInfinity}, hit) ? ray.at(hit.t).x : std::nan("");
}

// Reference values: the same lathes in POV-Ray 3.7, by its trace() function.
TEST(Lathe, SplinesAreThoseOfPovRay) {
  const std::vector<Vec2> points{{0.3, -1.2}, {1, -1}, {1.4, 0}, {0.7, 0.5}, {1.2, 1}, {2, 2}};
  const Lathe quadratic{OutlineSpline::kQuadratic, points}, cubic{OutlineSpline::kCubic, points};
  EXPECT_NEAR(first_x(quadratic, 0.2), 1.307487033, 1e-7);
  EXPECT_NEAR(first_x(quadratic, 0.8), 0.856, 1e-7);
  EXPECT_NEAR(first_x(quadratic, 1.5), 1.612310579, 1e-7);
  EXPECT_NEAR(first_x(cubic, -0.5), 1.295464749, 1e-7);
  EXPECT_NEAR(first_x(cubic, 0.2), 1.210315252, 1e-7);
  EXPECT_NEAR(first_x(cubic, 0.8), 0.971840637, 1e-7);
  const Lathe bezier{OutlineSpline::kBezier,
                     {{1, 0}, {2, 0.3}, {2, 0.7}, {1, 1}, {1, 1}, {0.5, 1.3}, {0.5, 1.7}, {1, 2}}};
  EXPECT_NEAR(first_x(bezier, 0.4), 1.722694521, 1e-7);
  EXPECT_NEAR(first_x(bezier, 1.4), 0.638652739, 1e-7);
}

TEST(Lathe, InsideIsWhereAnOddNumberOfCurvesIsFartherOut) {
  const auto inside = [](const Lathe& lathe, double r, double y) {
    return prepare(lathe).value()->contains({r, y, 0});
  };
  const Lathe cone{OutlineSpline::kLinear, {{2, 0}, {1, 2}}};
  EXPECT_TRUE(inside(cone, 1.25, 0.2));
  EXPECT_FALSE(inside(cone, 1.25, 1.7));
  EXPECT_FALSE(inside(cone, 0.75, 0.2));
  const Lathe outside_open{OutlineSpline::kLinear, {{2, 0}, {1, 0}, {1, 2}, {2, 2}}};
  EXPECT_FALSE(inside(outside_open, 1.5, 1));
  const Lathe overlap{
      OutlineSpline::kLinear,
      {{1, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 0}, {1.5, 0}, {3, 0}, {3, 2}, {1.5, 2}, {1.5, 0}}};
  EXPECT_TRUE(inside(overlap, 1.25, 1));
  EXPECT_FALSE(inside(overlap, 1.75, 1));
  EXPECT_TRUE(inside(overlap, 2.25, 1));
}

TEST(Lathe, ClosingFacesAreNotSeen) {
  const ShapePtr cup = prepare(Lathe{OutlineSpline::kLinear, {{0.5, 0}, {1, 2}}}).value();
  Crossing hit;
  EXPECT_FALSE(cup->nearest({{0.7, 5, 0}, {0, -1, 0}}, {0, 4}, hit));
  Crossings all;
  cup->crossings({{0.7, 5, 0}, {0, -1, 0}}, {0, kInfinity}, all);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_FALSE(all[0].visible);
  EXPECT_TRUE(all[1].visible);
}

TEST(Lathe, LevelAndNearlyLevelRaysMeetTheSameSurface) {
  const ShapePtr shape = prepare(Lathe{OutlineSpline::kCubic,
                                       {{2, 1},
                                        {2, -1},
                                        {3, -1},
                                        {3.4, -2},
                                        {4, -1.1},
                                        {3.6, 0},
                                        {3, 1},
                                        {2, 1},
                                        {2, -1},
                                        {3, -1}}})
                             .value();
  std::mt19937_64 random{3};
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 origin{5 * uniform(random), uniform(random), 5 * uniform(random)};
    const Vec3 level{uniform(random), 0, uniform(random)};
    Crossings flat;
    const bool inside = shape->crossings({origin, level}, {0, kInfinity}, flat);
    for (const double climb : {1e-12, 1e-9, 1e-7, 1e-6, -1e-7, -1e-9}) {
      Crossings out;
      const Ray ray{origin, level + climb * Vec3{0, 1, 0}};
      EXPECT_EQ(shape->crossings(ray, {0, kInfinity}, out), inside);
      ASSERT_EQ(out.size(), flat.size());
      for (std::size_t k = 0; k < out.size(); ++k) {
        if (flat[k].error < 1e-10) {
          EXPECT_NEAR(out[k].t, flat[k].t, 1e4 * std::fabs(climb) + 1e-9);
        }
        const double step = 2 * out[k].error + 1e-12;
        if (k + 1 < out.size() && out[k + 1].t - out[k].t < 1e-3) continue;
        if (out[k].error < 1e-8) {
          EXPECT_EQ(shape->contains(ray.at(out[k].t + step)), out[k].entering);
        }
      }
    }
  }
}

TEST(Lathe, OddParametersGiveAnErrorOrAShape) {
  EXPECT_FALSE(prepare(Lathe{}));
  EXPECT_FALSE(prepare(Lathe{OutlineSpline::kLinear, {{1, 0}, {1, 0}}}));
  EXPECT_FALSE(prepare(Lathe{OutlineSpline::kLinear, {{0, 0}, {0, 0}}}));
  EXPECT_FALSE(prepare(Lathe{OutlineSpline::kLinear, {{-1, 0}, {1, 0}}}));
  EXPECT_FALSE(prepare(Lathe{OutlineSpline::kBezier, {{1, 0}, {1, 0}, {2, 1}, {1, 3}, {2, 2}}}));
  EXPECT_FALSE(prepare(Lathe{OutlineSpline::kLinear, {{std::nan(""), 0}, {1, 0}}}));
  for (const double size : {1e-290, 1e-30, 1e30, 1e300}) {
    const Result<ShapePtr> shape =
        prepare(Lathe{OutlineSpline::kQuadratic, {{0, 0}, {0, 0}, {size, 0}, {size, size}}});
    ASSERT_TRUE(shape);
    Crossings out;
    (*shape)->crossings({{size, 0.5 * size, size}, {-1, 0.1, -1}}, Interval::all(), out);
  }
}

}  // namespace
}  // namespace dioptre
