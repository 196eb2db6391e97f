// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/convex_core.h"

#include <gtest/gtest.h>

#include "dioptre/csg/test_shapes.h"
#include "dioptre/geometry/shapes.h"

namespace dioptre::csg {
namespace {

/// A shape of which nothing is known: it is no convex solid.
class Plain final : public Shape {
 public:
  explicit Plain(const Shape& shape) : shape_(shape) {}
  Bounds bounds() const override { return shape_.bounds(); }
  bool contains(Vec3 p) const override { return shape_.contains(p); }
  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    return shape_.crossings(ray, range, out);
  }
  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    return shape_.surface(ray, crossing);
  }

 private:
  const Shape& shape_;
};

/// What random solids are made of.
struct Recipe {
  int least, most;     ///< leaves
  double complements;  ///< their share
  bool torus = false;  ///< the first leaf is one, which is not convex
};

/// A random intersection of convex solids and of their complements, built twice: knowing that they
/// are convex, and not. Coordinates are few, so that faces often coincide.
struct Twins {
  Twins(Random& random, bool clip, const Recipe& recipe) {
    const int count =
        recipe.least + static_cast<int>(random.between(0, recipe.most - recipe.least + 1));
    Description known, plain;
    known.nodes.resize(1);
    known.nodes[0].operation = clip ? Operation::kClip : Operation::kIntersection;
    for (int i = 0; i < count; ++i) {
      shapes.push_back(std::move(*prepare(recipe.torus && i == 0 ? Torus{2, 0.8} : any(random))));
      plains.push_back(std::make_unique<Plain>(*shapes.back()));
      const Affine placement = then(rotation({0, 90 * step(random), 45 * step(random)}),
                                    translation({step(random), 0, 0}));
      known.leaves.push_back({shapes.back().get(),
                              {placement, *inverse(placement)},
                              random.between(0, 1) < recipe.complements});
      known.nodes[0].children.push_back(~i);
    }
    plain = known;
    for (std::size_t i = 0; i < plains.size(); ++i) plain.leaves[i].shape = plains[i].get();
    first = build(known);
    second = build(plain);
  }

  static double step(Random& random) { return std::floor(random.between(-2, 3)) / 2; }
  static Vec3 steps(Random& random) { return {step(random), step(random), step(random)}; }
  static ShapeData any(Random& random) {
    const double kind = random.between(0, 5);
    if (kind < 2) return Plane{{step(random), 2 + step(random), step(random)}, step(random)};
    if (kind < 3) return Box{steps(random), steps(random) + Vec3{1, 2, 3}};
    if (kind < 4) return Sphere{steps(random), 1};
    return Cone{steps(random), 1, steps(random) + Vec3{0, 3, 0}, 0.5, random.between(0, 1) < 0.5};
  }

  std::vector<ShapePtr> shapes, plains;
  ShapePtr first, second;
};

/// Whoever knows that leaves are convex finds what others find, on rays that start anywhere.
/// At least so many rays must meet something.
void expect_twins_agree(int trials, const Recipe& recipe, Vec3 lean, std::size_t least_hits) {
  Random random(7);
  std::size_t hits = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Twins twins(random, trial % 3 == 0, recipe);
    for (int i = 0; i < 100; ++i) {
      Ray ray = random.ray(4);
      // Parallel to the axes but for `lean`, and not within a face.
      if (i % 4 == 0) {
        ray = {Twins::steps(random) + Vec3{0.123, 0.217, 0},
               Vec3{0, 0, i % 8 == 0 ? 1.0 : -1.0} + lean};
      }
      const Interval range{i % 3 == 0 ? -kInfinity : 0, i % 5 == 0 ? 3 : kInfinity};
      Crossing a, b;
      const bool found = twins.first->nearest(ray, range, a);
      ASSERT_EQ(found, twins.second->nearest(ray, range, b)) << trial << " " << i;
      Crossings all, others;
      EXPECT_EQ(twins.first->crossings(ray, range, all),
                twins.second->crossings(ray, range, others))
          << trial << " " << i;
      ASSERT_EQ(all.size(), others.size()) << trial << " " << i;
      for (std::size_t k = 0; k < all.size(); ++k) {
        EXPECT_NEAR(all[k].t, others[k].t, 1e-9 * std::max(1.0, std::fabs(all[k].t)))
            << trial << " " << i;
        EXPECT_EQ(all[k].leaf, others[k].leaf) << trial << " " << i;
      }
      if (!found) continue;
      ++hits;
      EXPECT_NEAR(a.t, b.t, 1e-9 * std::max(1.0, std::fabs(a.t))) << trial << " " << i;
      EXPECT_EQ(a.leaf, b.leaf) << trial << " " << i;
      EXPECT_EQ(a.entering, b.entering) << trial << " " << i;
    }
    const Vec3 p = random.ray(2).origin;
    EXPECT_EQ(twins.first->contains(p), twins.second->contains(p));
  }
  EXPECT_GT(hits, least_hits);
}

TEST(ConvexCore, ChangesNothing) { expect_twins_agree(300, {2, 6, 0.3}, {}, 1000); }

// Planes that are all but parallel to a ray differ by rounding.
constexpr Vec3 kLean{0.01, 0.02, 0};

TEST(Carving, ChangesNothing) { expect_twins_agree(300, {3, 8, 0.7}, kLean, 1000); }

TEST(Carving, ChangesNothingWithAStructureOverTheBites) {
  expect_twins_agree(60, {20, 40, 0.95}, kLean, 200);
}

TEST(Carving, ChangesNothingWithALeafThatIsNotConvex) {
  expect_twins_agree(300, {2, 6, 0.5, true}, kLean, 1000);
  expect_twins_agree(60, {20, 40, 0.95, true}, kLean, 200);
}

TEST(ConvexCore, NoEndAtInfinityIsReported) {
  const auto plane = prepare(Plane{{0, 1, 0}, 1});
  Description two;
  two.nodes.resize(1);
  two.nodes[0].operation = Operation::kIntersection;
  for (int i = 0; i < 2; ++i) {
    two.leaves.push_back({plane->get(), {}, false});
    two.nodes[0].children.push_back(~i);
  }
  const ShapePtr solid = build(two);
  for (const double slope : {0.0, -0.0, 1e-320, -1e-320}) {
    for (const double height : {0.5, 1.5}) {
      Crossings out;
      const Ray ray{{0, height, 0}, {1, slope, 0}};
      EXPECT_EQ(solid->crossings(ray, Interval::all(), out), height < 1);
      EXPECT_TRUE(out.empty());
    }
  }
}

}  // namespace
}  // namespace dioptre::csg
