// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/sor/sor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre {
namespace {

Sor vase() {
  return {{{0, 0},
           {0.118143, 0},
           {0.620253, 0.540084},
           {0.210970, 0.827004},
           {0.194093, 0.962025},
           {0.286920, 1},
           {0.468354, 1.033755}}};
}

// Reference values: the same vase in POV-Ray 3.7, by its trace() function.
TEST(Sor, SquaredRadiusIsThatOfPovRay) {
  const ShapePtr shape = prepare(vase()).value();
  const auto first_x = [&](double y, double z) {
    const Ray ray{{10, y, z}, {-1, 0, 0}};
    Crossing hit;
    return shape->nearest(ray, {0, kInfinity}, hit) ? ray.at(hit.t).x : std::nan("");
  };
  EXPECT_NEAR(first_x(0.3, 0.1), 0.475215559, 1e-9);
  EXPECT_NEAR(first_x(0.7, 0), 0.454584780, 1e-9);
  EXPECT_NEAR(first_x(0.9, 0), 0.176126345, 1e-9);
  EXPECT_NEAR(first_x(0.98, 0), 0.221881923, 1e-9);
}

TEST(Sor, DiscsAreSeenUnlessOpen) {
  for (const bool open : {false, true}) {
    Sor sor = vase();
    sor.open = open;
    const ShapePtr shape = prepare(sor).value();
    const Ray down{{0.2, 5, 0.1}, {0, -1, 0}};
    Crossings all;
    shape->crossings(down, {0, kInfinity}, all);
    ASSERT_GE(all.size(), 2u);
    EXPECT_NEAR(all[0].t, 4, 1e-12);
    EXPECT_EQ(all[0].visible, !open);
    EXPECT_EQ(shape->surface(down, all[0]).normal, (Vec3{0, 1, 0}));
    EXPECT_TRUE(shape->contains({0.1, 0.5, 0.1}));
  }
}

TEST(Sor, LevelAndNearlyLevelRaysMeetTheSameSurface) {
  const ShapePtr shape = prepare(vase()).value();
  for (int i = 0; i < 200; ++i) {
    const double y = 0.005 * i + 0.0012, z = 0.5 * std::sin(i);
    Crossings level, tilted;
    shape->crossings({{3, y, z}, {-1, 0, 0}}, {0, kInfinity}, level);
    shape->crossings({{3, y, z}, {-1, 1e-12, 0}}, {0, kInfinity}, tilted);
    ASSERT_EQ(level.size(), tilted.size());
    for (std::size_t k = 0; k < level.size(); ++k) EXPECT_NEAR(level[k].t, tilted[k].t, 1e-8);
  }
}

TEST(Sor, OddParametersGiveAnErrorOrAShape) {
  EXPECT_FALSE(prepare(Sor{}));
  EXPECT_FALSE(prepare(Sor{{{0, 0}, {0, 0}, {0, 0}, {0, 0}}}));
  EXPECT_FALSE(prepare(Sor{{{1, 0}, {1, 2}, {1, 1}, {1, 3}}}));
  EXPECT_FALSE(prepare(Sor{{{1, 0}, {-1, 1}, {1, 2}, {1, 3}}}));
  EXPECT_FALSE(prepare(Sor{{{1, kInfinity}, {1, 1}, {1, 2}, {1, 3}}}));
  for (const double size : {1e-290, 1e-30, 1e30, 1e300}) {
    const Result<ShapePtr> shape =
        prepare(Sor{{{size, 0}, {size, 0.1 * size}, {0, 0.2 * size}, {size, size}}});
    ASSERT_TRUE(shape);
    Crossings out;
    (*shape)->crossings({{size, 0.15 * size, size}, {-1, 0.1, -1}}, Interval::all(), out);
  }
}

}  // namespace
}  // namespace dioptre
