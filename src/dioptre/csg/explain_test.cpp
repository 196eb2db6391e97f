// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/explain.h"

#include <gtest/gtest.h>

#include <random>

#include "dioptre/csg/test_shapes.h"

namespace dioptre::csg {
namespace {

double length_of(const std::vector<Interval>& stretches) {
  double sum = 0;
  for (const Interval& each : stretches) sum += each.max - each.min;
  return sum;
}

TEST(Explain, TheRootIsWhatTheSolidIs) {
  // A box less a ball, joined with a ball, clipped by a large ball.
  Writer writer;
  const auto cut =
      writer.difference(writer.block({-1, -1, -1}, {1, 1, 1}), writer.ball({0.5, 0, -1}, 0.8));
  const auto joined = writer.node(Operation::kMerge, {cut, writer.ball({-0.8, 0.2, 0.3}, 0.7)});
  const auto shape = writer.solid(writer.node(Operation::kClip, {joined, writer.ball({}, 1.4)}));
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> u(-1.5, 1.5);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{{u(random), u(random), -4}, {0.2 * u(random), 0.2 * u(random), 1}};
    const Interval range{0, 100};
    const RayStretches told = explain(*shape, ray, range);
    Crossings crossings;
    EXPECT_FALSE(shape->crossings(ray, range, crossings));
    double inside = 0, seen_from = 0;
    for (const Crossing& c : crossings) {
      if (c.entering) seen_from = c.t;
      if (!c.entering) inside += c.t - seen_from;
    }
    ASSERT_FALSE(told.nodes.empty());
    EXPECT_NEAR(length_of(told.nodes[0].inside), inside, 1e-9);
    std::size_t seen = 0;
    for (const EventFate& event : told.events) {
      seen += event.seen ? 1 : 0;
      if (event.seen) continue;
      EXPECT_FALSE(told.nodes[event.stopped_at].is_leaf);
      EXPECT_EQ(told.nodes[event.because_of].parent, static_cast<std::int32_t>(event.stopped_at));
    }
    EXPECT_EQ(seen, crossings.size()) << i;
  }
}

TEST(Explain, AShapeThatIsNoTreeHasNothingToTell) {
  EXPECT_TRUE(explain(Block(), {{0, 0, -4}, {0, 0, 1}}, {0, 10}).nodes.empty());
}

}  // namespace
}  // namespace dioptre::csg
