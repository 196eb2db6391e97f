// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/ovus/ovus.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre {
namespace {

// Reference values: the same ovus in POV-Ray 3.7, by its trace() function.
TEST(Ovus, SideIsThatOfPovRay) {
  const ShapePtr shape = prepare(Ovus{1, 0.5}).value();
  const double measured[][4] = {{0, 1, 1, 0},
                                {0.3, 0.962165391, 0.977161067, 0.2125},
                                {0.5, 0.907678778, 0.949917760, 0.3125},
                                {1, 0.661437828, 0.826797285, 0.5625},
                                {1.2, 0.505967085, 0.749061913, 0.6625}};
  for (const auto& m : measured) {
    const Ray ray{{5, m[0], 0}, {-1, 0, 0}};
    Crossing hit;
    ASSERT_TRUE(shape->nearest(ray, {0, kInfinity}, hit));
    const Surface s = shape->surface(ray, hit);
    EXPECT_NEAR(s.position.x, m[1], 1e-9);
    EXPECT_NEAR(s.normal.x, m[2], 1e-9);
    EXPECT_NEAR(s.normal.y, m[3], 1e-9);
  }
}

TEST(Ovus, ALargeTopIsASphereAlone) {
  const ShapePtr shape = prepare(Ovus{1, 2.5}).value();
  EXPECT_EQ(shape->bounds(), (Bounds{{-2.5, -1.5, -2.5}, {2.5, 3.5, 2.5}}));
  EXPECT_TRUE(shape->contains({0, 3.49, 0}));
  EXPECT_TRUE(shape->contains({2.49, 1, 0}));
  EXPECT_FALSE(shape->contains({0, -1.51, 0}));
}

TEST(Ovus, OddRadiiGiveAnErrorOrAShape) {
  EXPECT_FALSE(prepare(Ovus{0, 0}));
  EXPECT_FALSE(prepare(Ovus{std::nan(""), 1}));
  EXPECT_FALSE(prepare(Ovus{1, kInfinity}));
  for (const double r : {0.0, 1e-300, -1.0, 1e-9, 1e9, 1e300}) {
    const ShapePtr shape = prepare(Ovus{1, r}).value();
    Crossings out;
    shape->crossings({{0.1, 5, 0.1}, {0, -1, 0}}, Interval::all(), out);
    EXPECT_LE(out.size(), 2u);
  }
}

}  // namespace
}  // namespace dioptre
