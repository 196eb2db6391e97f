// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "dioptre/accel/accelerator.h"
#include "dioptre/accel/bounding_volume_hierarchy.h"
#include "dioptre/accel/nearest_first.h"
#include "dioptre/core/rng.h"

namespace dioptre {
namespace {

/// Random numbers for tests.
struct Random {
  std::uint64_t state;
  double unit() { return to_unit(mix_bits(state++)); }
  double between(double a, double b) { return a + (b - a) * unit(); }
  int below(int n) { return static_cast<int>(unit() * n); }
  Vec3 point(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
};

/// Boxes of all sizes: flat, points, equal, nested, far away, half infinite, infinite, empty.
Bounds random_box(Random& random) {
  const Vec3 center = random.point(10);
  Vec3 half = 0.5 * (random.point(1) + Vec3{1, 1, 1});
  switch (random.below(10)) {
    case 0:
      half.x = 0;
      break;
    case 1:
      half = {};
      break;
    case 2:
      return {{-1, -1, -1}, {1, 1, 1}};
    case 3:
      return {{-half.x, -half.y, -half.z}, half};
    case 4:
      return random.below(8) == 0 ? Bounds::all() : Bounds{};
    case 5: {
      Bounds b{center - half, center + half};
      if (random.below(8) == 0) b.max[static_cast<std::size_t>(random.below(3))] = kInfinity;
      return b;
    }
    case 6: {
      const Vec3 far = 1e9 * center;
      return {far - half, far + half};
    }
    default:
      break;
  }
  return {center - half, center + half};
}

std::vector<Bounds> random_boxes(std::uint64_t seed, std::size_t count) {
  Random random{seed << 32};
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(random_box(random));
  return boxes;
}

/// Rays in general and parallel to axes, some of which run within a face or an edge.
Ray random_ray(Random& random, const std::vector<Bounds>& boxes) {
  Ray ray{random.point(15), random.point(1)};
  const int kind = random.below(4);
  if (kind > 0) {
    ray.direction = {};
    ray.direction[static_cast<std::size_t>(random.below(3))] = random.below(2) ? 1 : -1;
    if (random.below(2)) ray.direction = -ray.direction;
    if (!boxes.empty() && random.below(2)) {
      const Bounds& b = boxes[static_cast<std::size_t>(random.unit() * boxes.size())];
      if (b.finite() && !b.empty()) ray.origin = random.below(2) ? b.min : b.max;
    }
  }
  return ray;
}

/// Whether a ray meets a box, by sampling where it certainly does: the midpoint of the overlap of
/// the three slabs in long double, a little inside.
bool certainly_meets(const Bounds& b, const Ray& ray, Interval range) {
  long double near = range.min, far = range.max;
  for (int axis = 0; axis < 3; ++axis) {
    const long double origin = ray.origin[axis], direction = ray.direction[axis];
    if (direction == 0) {
      if (!(b.min[axis] <= origin && origin <= b.max[axis])) return false;
      continue;
    }
    const long double one = (b.min[axis] - origin) / direction;
    const long double two = (b.max[axis] - origin) / direction;
    near = std::max(near, std::min(one, two));
    far = std::min(far, std::max(one, two));
  }
  return !b.empty() && near <= far;
}

class Collect final : public LeafVisitor {
 public:
  bool visit(std::uint32_t item, Interval&) override {
    items.insert(item);
    return true;
  }
  std::set<std::uint32_t> items;
};

class EveryAccelerator : public testing::TestWithParam<std::string_view> {
 protected:
  AcceleratorPtr make(const std::vector<Bounds>& boxes) const {
    return std::move(*make_accelerator(GetParam(), boxes));
  }
};

TEST_P(EveryAccelerator, NeverMissesABoxThatARayMeets) {
  Random random{1};
  for (std::uint64_t set = 0; set < 50; ++set) {
    const auto boxes = random_boxes(set, set < 8 ? set : 40);
    const auto accelerator = make(boxes);
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = random_ray(random, boxes);
      const Interval range{random.below(2) ? 0 : -kInfinity, random.below(2) ? 20 : kInfinity};
      Collect met;
      accelerator->visit(ray, range, met);
      for (std::uint32_t b = 0; b < boxes.size(); ++b) {
        if (certainly_meets(boxes[b], ray, range)) {
          ASSERT_TRUE(met.items.count(b)) << "set " << set << " ray " << i << " box " << b;
        }
      }
    }
  }
}

TEST_P(EveryAccelerator, ReportsNoEmptyBox) {
  const std::vector<Bounds> boxes{{}, {{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {-1, 1, 1}}};
  Collect met;
  make(boxes)->visit({{0.5, 0.5, -5}, {0, 0, 1}}, {0, kInfinity}, met);
  EXPECT_EQ(met.items, std::set<std::uint32_t>{1});
}

TEST_P(EveryAccelerator, FindsTheNearestWhenTheRangeShrinks) {
  Random random{2};
  for (std::uint64_t set = 0; set < 20; ++set) {
    const auto boxes = random_boxes(set, 200);
    const auto accelerator = make(boxes);
    struct Nearest final : LeafVisitor {
      const std::vector<Bounds>& boxes;
      const Ray& ray;
      double entry = kInfinity;
      Nearest(const std::vector<Bounds>& b, const Ray& r) : boxes(b), ray(r) {}
      bool visit(std::uint32_t item, Interval& range) override {
        const Interval part = clip(boxes[item], ray, {0, kInfinity});
        if (!part.empty()) entry = std::min(entry, part.min);
        range.max = std::min(range.max, entry);
        return true;
      }
    };
    for (int i = 0; i < 200; ++i) {
      const Ray ray = random_ray(random, boxes);
      Nearest nearest(boxes, ray);
      accelerator->visit(ray, {0, kInfinity}, nearest);
      double expected = kInfinity;
      for (const Bounds& b : boxes) {
        const Interval part = b.empty() ? Interval{} : clip(b, ray, {0, kInfinity});
        if (!part.empty()) expected = std::min(expected, part.min);
      }
      ASSERT_EQ(nearest.entry, expected);
    }
  }
}

TEST_P(EveryAccelerator, FindsTheBoxesThatHoldAPoint) {
  Random random{3};
  const auto boxes = random_boxes(77, 300);
  const auto accelerator = make(boxes);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = random.point(12);
    std::vector<std::uint32_t> items;
    accelerator->items_at(p, items);
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
      if (boxes[b].contains(p)) {
        ASSERT_TRUE(std::count(items.begin(), items.end(), b));
      }
    }
  }
}

TEST_P(EveryAccelerator, StopsWhenTold) {
  struct Once final : LeafVisitor {
    int calls = 0;
    bool visit(std::uint32_t, Interval&) override { return ++calls < 1; }
  } once;
  make(std::vector<Bounds>(100, Bounds{{-1, -1, -1}, {1, 1, 1}}))
      ->visit({{0, 0, -5}, {0, 0, 1}}, {0, kInfinity}, once);
  EXPECT_EQ(once.calls, 1);
}

TEST_P(EveryAccelerator, TakesAnyNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Bounds> boxes(50, Bounds{{-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308}});
  boxes.push_back({{nan, 0, 0}, {1, 1, 1}});
  for (int i = 0; i < 100; ++i) boxes.push_back({{i * 5e-324, 0, 0}, {i * 5e-324, 1, 1}});
  const auto accelerator = make(boxes);
  for (const double v : {nan, kInfinity, -kInfinity, 0.0, 5e-324, 1e308}) {
    Collect met;
    accelerator->visit({{v, 0, 0}, {v, 1, v}}, {0, kInfinity}, met);
    accelerator->visit({{0, 0, 0}, {0, 0, v}}, {v, kInfinity}, met);
  }
}

std::string accelerator_name(const testing::TestParamInfo<std::string_view>& info) {
  std::string name(info.param);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(All, EveryAccelerator,
                         testing::ValuesIn(accelerator_names().begin(), accelerator_names().end()),
                         accelerator_name);

TEST(Accelerators, AWrongNameListsTheRightOnes) {
  const auto wrong = make_accelerator("kd", {});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message,
            "there is no accelerator 'kd'; there are: bvh bsp bsp-median octree grid2 grid boxes "
            "slabs spheres extents none");
}

TEST(NearestFirst, ReportsItemsInOrderOfTheirBounds) {
  Random random{4};
  const auto boxes = random_boxes(5, 300);
  const BoundingVolumeHierarchy tree(boxes, 1);
  std::vector<NearestFirst::Pending> storage;
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = random_ray(random, boxes);
    const SlabRay slabs(ray);
    NearestFirst walk(tree, slabs, {0, kInfinity}, storage);
    std::set<std::uint32_t> met;
    std::uint32_t item = 0;
    double bound = walk.bound();
    while (walk.next(item)) {
      met.insert(item);
      ASSERT_LE(bound, walk.bound());
      bound = walk.bound();
    }
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
      if (certainly_meets(boxes[b], ray, {0, kInfinity})) {
        ASSERT_TRUE(met.count(b));
      }
    }
  }
}

}  // namespace
}  // namespace dioptre
