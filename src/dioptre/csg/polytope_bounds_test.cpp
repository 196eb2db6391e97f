// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/polytope_bounds.h"

#include <gtest/gtest.h>

#include "dioptre/csg/test_shapes.h"

namespace dioptre::csg {
namespace {

PlacedHalfSpace half_space(Vec3 normal, double distance) {
  return {normal, distance, abs(normal), std::fabs(distance)};
}

TEST(PolytopeBounds, OfATurnedBoxAreThoseOfItsCorners) {
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Affine turn = then(rotation({random.between(0, 360), random.between(0, 360), 0}),
                             translation({random.between(-5, 5), 0, 1}));
    const Bounds box{{-1, -2, -0.5}, {1, 3, 0.25}};
    std::vector<PlacedHalfSpace> sides;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        Vec3 normal;
        normal[axis] = sign;
        const Vec3 turned = turn.vector(normal);
        const double own = sign > 0 ? box.max[axis] : -box.min[axis];
        sides.push_back(half_space(2 * turned, 2 * (own + dot(turned, turn.o))));
      }
    }
    const Bounds found = polytope_bounds(sides), known = transform(box, turn);
    EXPECT_LT(max_component(abs(found.min - known.min)), 1e-7) << trial;
    EXPECT_LT(max_component(abs(found.max - known.max)), 1e-7) << trial;
  }
}

TEST(PolytopeBounds, HoldEveryPointInside) {
  Random random(5);
  int finite = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<PlacedHalfSpace> sides;
    const int count = 4 + static_cast<int>(random.between(0, 30));
    for (int i = 0; i < count; ++i) {
      sides.push_back(half_space(random.ray(1).direction, random.between(0.1, 2)));
    }
    const Bounds found = polytope_bounds(sides);
    if (!found.finite()) continue;
    ++finite;
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = random.ray(6).origin;
      bool inside = true;
      for (const PlacedHalfSpace& side : sides) inside &= dot(p, side.normal) <= side.distance;
      EXPECT_TRUE(!inside || found.contains(p)) << trial;
    }
  }
  EXPECT_GT(finite, 50);
}

TEST(PolytopeBounds, OfWhatIsOpenAreAllOfSpace) {
  std::vector<PlacedHalfSpace> prism;
  for (const Vec3 normal : {Vec3{1, 0, 0}, {-1, 0, 1}, {-1, 0, -1}, {0, 1, 0}}) {
    prism.push_back(half_space(normal, 1));
  }
  EXPECT_EQ(polytope_bounds(prism), Bounds::all());
  prism.push_back(half_space({0, -1, 0}, 1));
  EXPECT_TRUE(polytope_bounds(prism).finite());
}

}  // namespace
}  // namespace dioptre::csg
