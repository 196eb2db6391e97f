// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "dioptre/csg/compiled.h"
#include "dioptre/csg/evaluation.h"
#include "dioptre/csg/test_shapes.h"

namespace dioptre::csg {
namespace {

/// A random solid: round shapes anywhere, or blocks on a lattice, whose faces often coincide.
std::int32_t random_leaf(Writer& writer, Random& random, bool lattice) {
  const auto corner = [&] { return 1.0 * random.below(5) - 2; };
  if (lattice) {
    const Vec3 min{corner(), corner(), corner()};
    return writer.block(min, min + Vec3{1.0 + random.below(2), 1.0 + random.below(2), 1});
  }
  const Affine place = then(then(scaling({random.between(0.3, 1.5), random.between(0.3, 1.5), 1}),
                                 rotation(random.point(180))),
                            translation(random.point(1.5)));
  switch (random.below(5)) {
    case 0:
      return writer.leaf(Block(), place);
    case 1:
      return writer.leaf(Tube(), place);
    case 2:
      return writer.leaf(Block({-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, 0}),
                         place);
    default:
      return writer.leaf(Ball(), place);
  }
}

std::int32_t random_solid(Writer& writer, Random& random, int depth, bool lattice, bool unions) {
  if (depth == 0 || random.below(6) == 0) {
    const std::int32_t leaf = random_leaf(writer, random, lattice);
    return random.below(4) == 0 ? writer.inverted(leaf) : leaf;
  }
  std::vector<std::int32_t> children;
  const int count = 1 + random.below(4);
  for (int i = 0; i < count; ++i) {
    children.push_back(random_solid(writer, random, depth - 1, lattice, unions));
  }
  const Operation operations[] = {Operation::kMerge, Operation::kIntersection, Operation::kClip,
                                  Operation::kUnion};
  return writer.node(operations[random.below(unions ? 4 : 3)], children);
}

/// The definition: whether p is inside, by recursion over the description.
bool is_inside(const Description& d, std::int32_t entry, Vec3 p) {
  if (entry < 0) {
    const Leaf& leaf = d.leaves[static_cast<std::size_t>(~entry)];
    return leaf.shape->contains(leaf.placement.to_object.point(p)) != leaf.complement;
  }
  const Node& node = d.nodes[static_cast<std::size_t>(entry)];
  const bool any = node.operation == Operation::kUnion || node.operation == Operation::kMerge;
  for (const std::int32_t child : node.children) {
    if (is_inside(d, child, p) == any) return any;
  }
  return !any;
}

/// Where the truth changes along a ray, by the definition at the midpoints between all crossings of
/// all leaves that can be told apart.
std::vector<double> changes(const Description& d, const Ray& ray, bool& inside_at_start) {
  Crossings all;
  for (const Leaf& leaf : d.leaves) {
    leaf.shape->crossings(leaf.placement.to_object.ray(ray), {0, kInfinity}, all);
  }
  std::vector<double> t{0};
  for (const Crossing& crossing : all) t.push_back(crossing.t);
  std::sort(t.begin(), t.end());
  t.erase(std::unique(t.begin(), t.end(), [](double a, double b) { return b - a < 1e-10; }),
          t.end());
  t.push_back(t.back() + 2);
  std::vector<double> found;
  bool inside = inside_at_start = is_inside(d, d.root, ray.at(0.5 * (t[0] + t[1])));
  for (std::size_t i = 1; i + 1 < t.size(); ++i) {
    const bool next = is_inside(d, d.root, ray.at(0.5 * (t[i] + t[i + 1])));
    if (next != inside) found.push_back(t[i]);
    inside = next;
  }
  return found;
}

Ray random_ray(Random& random, bool lattice) {
  if (!lattice) return random.ray(4);
  // Off the faces that run along the ray.
  Ray ray{random.point(4), {}};
  ray.direction[static_cast<std::size_t>(random.below(3))] = random.below(2) ? 1 : -1;
  if (random.below(2)) ray.direction = normalize(random.point(1));
  return ray;
}

class RandomSolids : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(RoundAndLattice, RandomSolids, testing::Bool());

TEST_P(RandomSolids, CrossingsAreWhereMembershipChanges) {
  Random random{1};
  for (int trial = 0; trial < 300; ++trial) {
    Writer writer;
    const ShapePtr solid = writer.solid(random_solid(writer, random, 4, GetParam(), false));
    for (int i = 0; i < 40; ++i) {
      const Ray ray = random_ray(random, GetParam());
      bool inside = false;
      const std::vector<double> expected = changes(writer.description, ray, inside);
      Crossings found;
      EXPECT_EQ(solid->crossings(ray, {0, kInfinity}, found), inside);
      ASSERT_EQ(found.size(), expected.size()) << "trial " << trial << " ray " << i;
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k].t, expected[k], 1e-9);
        EXPECT_EQ(found[k].entering, inside == (k % 2 == 1));
      }
      const Vec3 p = random.point(3);
      EXPECT_EQ(solid->contains(p), is_inside(writer.description, writer.description.root, p));
    }
  }
}

TEST_P(RandomSolids, NearestIsTheFirstVisibleCrossing) {
  Random random{2};
  for (int trial = 0; trial < 300; ++trial) {
    Writer writer;
    const ShapePtr solid = writer.solid(random_solid(writer, random, 4, GetParam(), true));
    for (int i = 0; i < 40; ++i) {
      const Ray ray = random_ray(random, GetParam());
      const Interval range{0, random.between(0, 8)};
      Crossings all;
      solid->crossings(ray, range, all);
      EXPECT_TRUE(std::is_sorted(all.begin(), all.end(),
                                 [](const auto& a, const auto& b) { return a.t < b.t; }));
      const auto first = std::find_if(all.begin(), all.end(), [](auto& c) { return c.visible; });
      Crossing nearest;
      ASSERT_EQ(solid->nearest(ray, range, nearest), first != all.end());
      if (first == all.end()) continue;
      EXPECT_EQ(nearest.t, first->t);
      EXPECT_EQ(nearest.leaf, first->leaf);
      const Surface surface = solid->surface(ray, nearest);
      EXPECT_EQ(dot(surface.normal, ray.direction) < 0, nearest.entering);
      EXPECT_LT(length(surface.position - ray.at(nearest.t)), 1e-9);
    }
  }
}

TEST_P(RandomSolids, NoStructureOverTheLeavesChangesAnything) {
  Random random{3};
  for (const std::string_view name : accelerator_names()) {
    for (int trial = 0; trial < 60; ++trial) {
      Writer writer;
      writer.description.root = random_solid(writer, random, 4, GetParam(), true);
      const Compiled few = compile(writer.description, 1000);
      const Compiled many = compile(writer.description, 0, name);
      if (few.only_leaf != kNone) continue;
      for (int i = 0; i < 40; ++i) {
        const Ray ray = random_ray(random, GetParam());
        const SlabRay slabs(ray);
        Scratch one, two;
        const Interval range{random.between(-2, 2), 8};
        ASSERT_EQ(Sweep(few, one, ray, slabs, range, range).run(true),
                  Sweep(many, two, ray, slabs, range, range).run(true));
        ASSERT_EQ(one.passed.size(), two.passed.size()) << name << ", trial " << trial;
        for (std::size_t k = 0; k < one.passed.size(); ++k) {
          EXPECT_EQ(one.passed[k].t, two.passed[k].t) << name;
          EXPECT_EQ(one.passed[k].leaf, two.passed[k].leaf) << name;
        }
      }
    }
  }
}

TEST_P(RandomSolids, DeMorgan) {
  Random random{4};
  for (int trial = 0; trial < 200; ++trial) {
    Writer a, b;
    Random again = random;
    const auto solid = a.solid(random_solid(a, random, 3, GetParam(), false));
    const auto root = random_solid(b, again, 3, GetParam(), false);
    complement(b.description, root);
    complement(b.description, root);
    const auto twice = b.solid(root);
    complement(b.description, root);
    const auto inverse = b.solid(root);
    for (int i = 0; i < 40; ++i) {
      const Ray ray = random_ray(random, GetParam());
      EXPECT_EQ(times(*twice, ray), times(*solid, ray));
      EXPECT_EQ(times(*inverse, ray), times(*solid, ray));
      Crossings ours, theirs;
      EXPECT_NE(inverse->crossings(ray, {0, 9}, ours), solid->crossings(ray, {0, 9}, theirs));
    }
  }
}

TEST_P(RandomSolids, LessItselfIsEmpty) {
  Random random{5};
  for (int trial = 0; trial < 200; ++trial) {
    Writer writer;
    Random again = random;
    const auto a = random_solid(writer, random, 3, GetParam(), true);
    const auto b = random_solid(writer, again, 3, GetParam(), true);
    const ShapePtr nothing = writer.solid(writer.difference(a, b));
    for (int i = 0; i < 40; ++i) {
      EXPECT_TRUE(times(*nothing, random_ray(random, GetParam())).empty());
    }
  }
}

TEST_P(RandomSolids, LengthsAddUp) {
  Random random{6};
  const Vec3 low{-3, -3, -3}, high{3, 3, 3};
  for (int trial = 0; trial < 200; ++trial) {
    Writer writer;
    const auto make = [&](Random& source) {
      const auto part = random_solid(writer, source, 2, GetParam(), false);
      return writer.common(part, writer.block(low, high));
    };
    // The same two solids, four times over.
    Random at_a{mix_bits(static_cast<std::uint64_t>(trial))}, at_b{at_a.state + 1000};
    const auto pair = [&](std::int32_t (Writer::*join)(std::int32_t, std::int32_t)) {
      Random first = at_a, second = at_b;
      const auto a = make(first), b = make(second);
      return writer.solid((writer.*join)(a, b));
    };
    Random first = at_a, second = at_b;
    const ShapePtr a = writer.solid(make(first)), b = writer.solid(make(second));
    const ShapePtr less = pair(&Writer::difference), both = pair(&Writer::common),
                   either = pair(&Writer::merge);
    for (int i = 0; i < 40; ++i) {
      const Ray ray = random_ray(random, GetParam());
      const double in_a = length_inside(*a, ray), in_b = length_inside(*b, ray);
      const double in_both = length_inside(*both, ray);
      EXPECT_NEAR(length_inside(*less, ray) + in_both, in_a, 1e-12);
      EXPECT_NEAR(length_inside(*either, ray) + in_both, in_a + in_b, 1e-12);
    }
  }
}

TEST_P(RandomSolids, OrderDoesNotMatter) {
  Random random{7};
  for (int trial = 0; trial < 200; ++trial) {
    Writer writer;
    writer.description.root = random_solid(writer, random, 4, GetParam(), true);
    const ShapePtr one = build(writer.description);
    for (Node& node : writer.description.nodes) {
      const auto first = node.children.begin() + (node.operation == Operation::kClip ? 1 : 0);
      std::reverse(first, node.children.end());
    }
    const ShapePtr two = build(writer.description);
    for (int i = 0; i < 40; ++i) {
      const Ray ray = random_ray(random, GetParam());
      EXPECT_EQ(times(*one, ray), times(*two, ray));
    }
  }
}

TEST_P(RandomSolids, BoundsHoldWhatIsInsideAndEveryCrossing) {
  Random random{8};
  for (int trial = 0; trial < 300; ++trial) {
    Writer writer;
    const ShapePtr solid = writer.solid(random_solid(writer, random, 3, GetParam(), true));
    Bounds box = solid->bounds();
    for (std::size_t axis = 0; axis < 3; ++axis) box.min[axis] -= 1e-9, box.max[axis] += 1e-9;
    for (int i = 0; i < 40; ++i) {
      const Ray ray = random_ray(random, GetParam());
      for (const double t : times(*solid, ray)) {
        EXPECT_TRUE(box.contains(ray.at(t)));
      }
      const Vec3 p = random.point(3);
      if (is_inside(writer.description, writer.description.root, p)) {
        EXPECT_TRUE(box.contains(p));
      }
    }
  }
}

TEST_P(RandomSolids, ScaleDoesNotMatter) {
  Random random{9};
  for (int trial = 0; trial < 200; ++trial) {
    Writer writer;
    const ShapePtr one = writer.solid(random_solid(writer, random, 4, GetParam(), true));
    const double scale = trial % 2 ? 0x1p40 : 0x1p-40;
    for (Leaf& leaf : writer.description.leaves) {
      leaf.placement = {then(leaf.placement.to_world, scaling(scale * Vec3{1, 1, 1})),
                        then(scaling(1 / scale * Vec3{1, 1, 1}), leaf.placement.to_object)};
    }
    const ShapePtr two = build(writer.description);
    for (int i = 0; i < 40; ++i) {
      const Ray ray = random_ray(random, GetParam());
      std::vector<double> scaled = times(*two, {scale * ray.origin, ray.direction});
      for (double& t : scaled) t /= scale;
      EXPECT_EQ(times(*one, ray), scaled);
    }
  }
}

TEST(ManyLeaves, AThousandBlocksLessAThousandBalls) {
  Random random{10};
  Writer writer;
  std::vector<std::int32_t> blocks, balls;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p{i % 10 - 5.0, i / 10 % 10 - 5.0, i / 100 - 5.0};
    blocks.push_back(writer.block(p, p + Vec3{0.8, 0.8, 0.8}));
    balls.push_back(writer.ball(p + random.point(0.4), 0.5));
  }
  writer.description.root = writer.difference(writer.node(Operation::kUnion, blocks),
                                              writer.node(Operation::kMerge, balls));
  const ShapePtr solid = build(writer.description);
  const Compiled few = compile(writer.description, 3000);
  for (int i = 0; i < 3000; ++i) {
    const Ray ray = random.ray(7);
    const SlabRay slabs(ray);
    Scratch scratch;
    const Interval range{0, kInfinity};
    Sweep(few, scratch, ray, slabs, range, range).run(true);
    Crossing nearest;
    ASSERT_EQ(solid->nearest(ray, {0, kInfinity}, nearest), !scratch.passed.empty());
    if (!scratch.passed.empty()) {
      EXPECT_EQ(nearest.t, scratch.passed[0].t);
    }
    std::vector<double> all;
    for (const Crossing& crossing : scratch.passed) all.push_back(crossing.t);
    EXPECT_EQ(times(*solid, ray, {0, kInfinity}), all);
  }
}

}  // namespace
}  // namespace dioptre::csg
