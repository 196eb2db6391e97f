// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dioptre/core/parallel.h"
#include "dioptre/csg/test_shapes.h"

namespace dioptre::csg {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// How many of n x n parallel rays down the z axis, over [-size, size]^2, hit.
int hits(const Shape& shape, const Affine& place, int n, double size) {
  int count = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Vec3 p{size * (2 * (i + 0.5) / n - 1), size * (2 * (k + 0.5) / n - 1), -10};
      const Ray ray{place.point(p), place.vector({0, 0, 1})};
      Crossing crossing;
      if (shape.nearest(ray, {0, kInfinity}, crossing)) ++count;
    }
  }
  return count;
}

/// The volume of a solid within [-size, size]^2 x R, by n x n parallel rays.
double volume(const Shape& shape, int n, double size) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Vec3 p{size * (2 * (i + 0.5) / n - 1), size * (2 * (k + 0.5) / n - 1), -10};
      sum += length_inside(shape, {p, {0, 0, 1}});
    }
  }
  return sum * (2 * size / n) * (2 * size / n);
}

TEST(KnownAnswers, ADrillFlushWithBothFacesMakesACleanHole) {
  for (const Vec3 turn : {Vec3{0, 0, 0}, Vec3{10, 20, 30}}) {
    Writer writer;
    const Affine place = rotation(turn);
    const auto solid = writer.solid(writer.difference(
        writer.leaf(Block(), place), writer.leaf(Block({-.5, -.5, -1}, {.5, .5, 1}), place)));
    EXPECT_EQ(hits(*solid, place, 200, 2), 10000 - 2500);
  }
}

TEST(KnownAnswers, SolidsThatOnlyTouchHaveNothingInCommon) {
  Writer writer;
  const auto face = writer.solid(
      writer.common(writer.block({-1, -1, -1}, {1, 1, 0}), writer.block({-1, -1, 0}, {1, 1, 1})));
  EXPECT_EQ(hits(*face, {}, 100, 2), 0);
}

TEST(KnownAnswers, AMergeLosesTheSharedFaceAndAUnionKeepsIt) {
  const Ray ray{{0.1, 0.2, -5}, {0, 0, 1}};
  for (const Operation operation : {Operation::kMerge, Operation::kUnion}) {
    Writer writer;
    const auto solid = writer.solid(writer.node(
        operation, {writer.block({-1, -1, -1}, {1, 1, 0}), writer.block({-1, -1, 0}, {1, 1, 1})}));
    if (operation == Operation::kMerge) {
      EXPECT_THAT(times(*solid, ray), ElementsAre(4, 6));
      EXPECT_EQ(length_inside(*solid, ray), 2);
    } else {
      EXPECT_THAT(times(*solid, ray), ElementsAre(4, 5, 5, 6));
    }
  }
}

TEST(KnownAnswers, CrossedCylindersHaveNoSeam) {
  Writer writer;
  const auto solid = writer.solid(writer.common(writer.leaf(Tube(), rotation({0, 90, 0})),
                                                writer.leaf(Tube(), rotation({90, 0, 0}))));
  EXPECT_NEAR(times(*solid, {{0.5, 0.5, -5}, {0, 0, 1}}).at(0), 5 - std::sqrt(0.75), 1e-14);
  EXPECT_EQ(hits(*solid, {}, 101, 2), 51 * 51);
  for (int i = -99; i < 100; ++i) {
    for (const double sign : {-1.0, 1.0}) {
      Crossing crossing;
      EXPECT_TRUE(solid->nearest({{i / 100.0, sign * i / 100.0, -5}, {0, 0, 1}}, {0, 9}, crossing));
    }
  }
}

TEST(KnownAnswers, ACameraInsideASolidOrACavitySeesItsWall) {
  Writer writer;
  const auto block = writer.block({-2, -2, -2}, {2, 2, 2});
  const auto solid = writer.solid(writer.difference(block, writer.ball({0, 0, 0}, 1)));
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  Crossing crossing;
  ASSERT_TRUE(solid->nearest(ray, {0, kInfinity}, crossing));
  EXPECT_EQ(crossing.t, 1);
  EXPECT_EQ(crossing.leaf, 1u);
  EXPECT_TRUE(crossing.entering);
  EXPECT_EQ(solid->surface(ray, crossing).normal, (Vec3{-0.0, -0.0, -1}));
  EXPECT_FALSE(solid->contains({0, 0, 0}));
  EXPECT_TRUE(solid->contains({0, 0, 1.5}));
  Crossings rest;
  EXPECT_TRUE(solid->crossings({{0, 0, 1.5}, {0, 0, 1}}, {0, kInfinity}, rest));
  EXPECT_EQ(rest.size(), 1u);
}

TEST(KnownAnswers, ANarrowGapIsSeenFromWithin) {
  for (int k = 2; k <= 12; ++k) {
    const double gap = std::pow(10.0, -k);
    Writer writer;
    const auto solid =
        writer.solid(writer.node(Operation::kUnion, {writer.block({-1, -1, -1}, {1, 1, -gap / 2}),
                                                     writer.block({-1, -1, gap / 2}, {1, 1, 1})}));
    Crossing crossing;
    ASSERT_TRUE(solid->nearest({{0.1, 0.1, 0}, {0, 0, 1}}, {0, kInfinity}, crossing));
    EXPECT_EQ(crossing.t, gap / 2);
  }
}

TEST(KnownAnswers, AThinShellHasFourWalls) {
  for (int k = 2; k <= 12; ++k) {
    const double thickness = std::pow(10.0, -k);
    Writer writer;
    const auto outer = writer.ball({}, 1);
    const auto solid = writer.solid(writer.difference(outer, writer.ball({}, 1 - thickness)));
    const Ray ray{{0, 0, -5}, {0, 0, 1}};
    EXPECT_EQ(times(*solid, ray).size(), 4u);
    EXPECT_NEAR(length_inside(*solid, ray) / (2 * thickness), 1, k < 12 ? 1e-3 : 2e-3);
  }
}

TEST(KnownAnswers, Volumes) {
  Writer writer;
  const auto x = Affine(rotation({0, 90, 0})), y = Affine(rotation({90, 0, 0}));
  const auto two = writer.solid(writer.common(writer.leaf(Tube(), x), writer.leaf(Tube(), y)));
  EXPECT_NEAR(volume(*two, 1000, 1), 16.0 / 3, 2e-4);
  const auto three = writer.solid(
      writer.node(Operation::kIntersection,
                  {writer.leaf(Tube(), x), writer.leaf(Tube(), y), writer.leaf(Tube())}));
  EXPECT_NEAR(volume(*three, 1000, 1), 4.6862915010, 2e-4);
  const auto drilled = writer.solid(writer.difference(
      writer.ball({}, 1), writer.leaf(Tube(), then(scaling({0.6, 0.6, 1}), rotation({0, 90, 0})))));
  EXPECT_NEAR(volume(*drilled, 1000, 1), 2.1446605849, 2e-4);
  const auto lens =
      writer.solid(writer.common(writer.ball({-.5, 0, 0}, 1), writer.ball({.5, 0, 0}, 1)));
  EXPECT_NEAR(volume(*lens, 1000, 1), 1.3089969390, 2e-4);
}

TEST(Tree, AClipCutsWithoutASurface) {
  Writer writer;
  const auto ball = writer.ball({}, 1);
  const auto front = writer.block({-2, -2, -2}, {2, 2, 0});
  const auto solid = writer.solid(writer.node(Operation::kClip, {ball, front}));
  Crossings found;
  solid->crossings({{0, 0, -5}, {0, 0, 1}}, {0, kInfinity}, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].visible);
  EXPECT_EQ(found[1].t, 5);
  EXPECT_FALSE(found[1].visible);
  Crossing nearest;
  ASSERT_TRUE(solid->nearest({{0, 0, 5}, {0, 0, -1}}, {0, kInfinity}, nearest));
  EXPECT_EQ(nearest.t, 6);
}

TEST(Tree, ASheetShowsWhereItsSiblingsAllowIt) {
  const Ray within{{0, 0, -5}, {0, 0, 1}}, beside{{1.5, 0, -5}, {0, 0, 1}};
  Writer writer;
  const auto both = writer.solid(writer.common(writer.leaf(Square()), writer.ball({}, 1)));
  EXPECT_THAT(times(*both, within), ElementsAre(5));
  EXPECT_THAT(times(*both, beside), IsEmpty());
  EXPECT_FALSE(both->contains({}));
  EXPECT_FALSE(both->solid());
  const auto either = writer.solid(writer.merge(writer.leaf(Square()), writer.ball({}, 1)));
  EXPECT_THAT(times(*either, within), ElementsAre(4, 6));
  EXPECT_THAT(times(*either, beside), ElementsAre(5));
  const auto less = writer.solid(writer.difference(writer.leaf(Square()), writer.ball({}, 1)));
  EXPECT_THAT(times(*less, within), IsEmpty());
  EXPECT_THAT(times(*less, beside), ElementsAre(5));
}

TEST(Tree, UnboundedLeavesAreBoundedByWhatClipsThem) {
  Writer writer;
  const auto half = writer.block({-kInfinity, -kInfinity, -kInfinity}, {kInfinity, 0, kInfinity});
  const auto solid = writer.solid(writer.common(half, writer.ball({}, 1)));
  EXPECT_EQ(solid->bounds().max.y, 0);
  EXPECT_TRUE(solid->bounds().finite());
  EXPECT_TRUE(writer.solid(writer.inverted(writer.ball({}, 1)))->contains({9, 9, 9}));
}

TEST(Tree, DegenerateDescriptionsAreEmpty) {
  Description description;
  EXPECT_TRUE(build(description)->bounds().empty());
  description.nodes.push_back({Operation::kIntersection, {}});
  EXPECT_FALSE(build(description)->contains({}));
  description.nodes[0].children = {0, 5, -7, 0};
  EXPECT_THAT(times(*build(description), {{0, 0, 0}, {0, 0, 1}}), IsEmpty());
}

TEST(Tree, DepthIsUnlimited) {
  Writer chain, ladder;
  auto root = chain.block({-1, -1, -1}, {3001, 1, 1});
  for (int i = 0; i < 3000; ++i) root = chain.difference(root, chain.ball({i + 0.5, 0, 0}, 0.4));
  EXPECT_EQ(times(*chain.solid(root), {{-5, 0, 0}, {1, 0, 0}}).size(), 6002u);
  // Unions in differences in unions: nothing to flatten.
  root = ladder.ball({}, 1);
  for (int i = 1; i < 20000; ++i) {
    const auto ball = ladder.ball({3.0 * i, 0, 0}, 1);
    root = i % 2 ? ladder.merge(root, ball)
                 : ladder.node(Operation::kIntersection, {root, ladder.inverted(ball)});
  }
  EXPECT_EQ(times(*ladder.solid(root), {{-5, 0, 0}, {1, 0, 0}}, {0, 100}).size(), 34u);
}

TEST(Tree, ManyChildrenAreQuick) {
  Writer writer;
  std::vector<std::int32_t> balls;
  for (int i = 0; i < 100000; ++i) balls.push_back(writer.ball({2.5 * i, 0, 0}, 1));
  const auto solid = writer.solid(writer.node(Operation::kMerge, balls));
  for (int i = 0; i < 100000; i += 7) {
    Crossing crossing;
    ASSERT_TRUE(solid->nearest({{2.5 * i, 0, -5}, {0, 0, 1}}, {0, kInfinity}, crossing));
    ASSERT_EQ(crossing.leaf, static_cast<std::uint32_t>(i));
    ASSERT_EQ(crossing.t, 4);
  }
}

/// A ball that asks another tree while it is asked itself.
class Asking final : public Shape {
 public:
  explicit Asking(const Shape& other) : other_(other) {}
  Bounds bounds() const override { return ball_.bounds(); }
  bool contains(Vec3 p) const override { return ball_.contains(p); }
  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Crossing ignored;
    other_.nearest(ray, range, ignored);
    other_.contains(ray.origin);
    return ball_.crossings(ray, range, out);
  }
  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    return ball_.surface(ray, crossing);
  }

 private:
  const Shape& other_;
  Ball ball_;
};

TEST(Tree, MayBeAskedFromWithinAnotherAndByManyThreads) {
  Writer inner, outer;
  const auto other = inner.solid(inner.difference(inner.ball({}, 1), inner.ball({0.5, 0, 0}, 1)));
  const auto asking = outer.leaf(Asking(*other));
  const auto solid = outer.solid(outer.difference(asking, outer.ball({0.5, 0, 0}, 0.9)));
  std::vector<int> same(64);
  parallel_for(64, 4, nullptr, [&](std::uint32_t i) {
    Random random{i * 100000};
    Writer plain;
    const auto a = plain.ball({}, 1), b = plain.ball({0.5, 0, 0}, 0.9);
    const auto expected = plain.solid(plain.difference(a, b));
    same[i] = 1;
    for (int k = 0; k < 200; ++k) {
      const Ray ray = random.ray(2);
      if (times(*solid, ray) != times(*expected, ray)) same[i] = 0;
    }
  });
  EXPECT_THAT(same, testing::Each(1));
}

}  // namespace
}  // namespace dioptre::csg
