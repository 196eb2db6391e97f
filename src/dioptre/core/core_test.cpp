// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "dioptre/core/affine.h"
#include "dioptre/core/bounds.h"
#include "dioptre/core/diagnostics.h"

namespace dioptre {
namespace {

TEST(Affine, RotationIsLeftHanded) {
  EXPECT_EQ(rotation({90, 0, 0}).vector({0, 1, 0}), (Vec3{0, 0, 1}));
  EXPECT_EQ(rotation({0, 90, 0}).vector({0, 0, 1}), (Vec3{1, 0, 0}));
  EXPECT_EQ(rotation({0, 0, 90}).vector({1, 0, 0}), (Vec3{0, 1, 0}));
}

TEST(Affine, AxisRotationAgreesWithRotation) {
  for (const double angle : {10.0, 77.0, -123.0}) {
    const Vec3 p{1, 2, 3};
    EXPECT_LT(length(axis_rotation({0, 3, 0}, angle).point(p) - rotation({0, angle, 0}).point(p)),
              1e-14);
    EXPECT_LT(length(axis_rotation({1, 0, 0}, angle).point(p) - rotation({angle, 0, 0}).point(p)),
              1e-14);
  }
}

TEST(Affine, InverseUndoesTheMap) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-2, 2);
  const auto vec = [&] { return Vec3{u(random), u(random), u(random)}; };
  for (int i = 0; i < 1000; ++i) {
    const Affine map{vec(), vec(), vec(), vec()};
    if (std::fabs(map.determinant()) < 0.01) continue;
    const Vec3 p = vec();
    const auto back = inverse(map);
    ASSERT_TRUE(back);
    EXPECT_LT(length(back->point(map.point(p)) - p), 1e-11);
  }
}

TEST(Affine, ASingularMapHasNoInverse) {
  EXPECT_FALSE(inverse(scaling({1, 0, 1})));
  EXPECT_FALSE(inverse(scaling({kInfinity, 1, 1})));
}

TEST(Bounds, TransformHoldsTheImagesOfAllPoints) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> u(-5, 5), s(0, 1);
  const auto vec = [&] { return Vec3{u(random), u(random), u(random)}; };
  for (int i = 0; i < 1000; ++i) {
    const Affine map{vec(), vec(), vec(), vec()};
    Bounds box = unite(Bounds{}, vec());
    box = unite(box, vec());
    const Vec3 e = box.extent();
    const Vec3 p = box.min + Vec3{e.x * s(random), e.y * s(random), e.z * s(random)};
    EXPECT_TRUE(transform(box, map).contains(map.point(p)));
  }
}

TEST(Bounds, AnInfiniteSideStaysInfiniteOnlyWhereItMust) {
  Bounds slab = Bounds::all();
  slab.min.y = 0;
  slab.max.y = 1;
  const Bounds scaled = transform(slab, scaling({2, 3, 2}));
  EXPECT_NEAR(scaled.max.y, 3, 1e-12);
  EXPECT_EQ(scaled.max.x, kInfinity);
  EXPECT_FALSE(transform(slab, rotation({30, 0, 0})).finite());
}

TEST(Bounds, ClipKeepsEveryInsidePointOfTheRay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-5, 5), s(0, 1);
  const auto vec = [&] { return Vec3{u(random), u(random), u(random)}; };
  for (int i = 0; i < 10000; ++i) {
    Bounds box = unite(unite(Bounds{}, vec()), vec());
    const Vec3 e = box.extent();
    const Vec3 p = box.min + Vec3{e.x * s(random), e.y * s(random), e.z * s(random)};
    const Vec3 d = vec();
    const Ray ray{p - 3.0 * d, d};
    const Interval hit = clip(box, ray, Interval::all());
    EXPECT_LE(hit.min, 3.0 + 1e-12);
    EXPECT_GE(hit.max, 3.0 - 1e-12);
  }
}

TEST(Diagnostics, TextShowsLineCaretAndNotes) {
  const Diagnostic d{Severity::kError,
                     "ring.pov",
                     12,
                     13,
                     "torus needs two numbers, found '}'",
                     "  torus {\t1 }",
                     {"write torus { MAJOR, MINOR }"}};
  EXPECT_EQ(to_text(d),
            "ring.pov:12:13: error: torus needs two numbers, found '}'\n"
            "  12 |   torus { 1 }\n"
            "     |             ^\n"
            "     = note: write torus { MAJOR, MINOR }\n");
}

TEST(Diagnostics, ALongLineIsCutAroundTheColumn) {
  const Diagnostic d{Severity::kWarning, "a", 1, 5000, "m", std::string(10000, 'x'), {}};
  const std::string text = to_text(d);
  EXPECT_LT(text.size(), 400u);
  EXPECT_NE(text.find('^'), std::string::npos);
}

}  // namespace
}  // namespace dioptre
