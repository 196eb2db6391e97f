// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <ostream>
#include <string>

#include "dioptre/accel/accelerator.h"
#include "dioptre/core/rng.h"

namespace dioptre {
namespace {

/// Random numbers for tests.
struct Random {
  std::uint64_t state;
  double unit() { return to_unit(mix_bits(state++)); }
  double between(double a, double b) { return a + (b - a) * unit(); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(unit() * double(n)); }
  Vec3 point(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
};

/// Boxes of one kind, and how far rays start from the origin.
struct BoxKind {
  std::string_view name;
  Bounds (*make)(Random& random, std::size_t index);
  double reach;
};
void PrintTo(const BoxKind& kind, std::ostream* out) { *out << kind.name; }

Bounds around(Vec3 center, Vec3 half) { return {center - half, center + half}; }
Bounds cube(Vec3 center, double half) { return around(center, {half, half, half}); }

constexpr std::array kKinds{
    BoxKind{"uniform", [](Random& r, std::size_t) { return cube(r.point(10), r.between(0, 1)); },
            15},
    BoxKind{"teapot_in_a_stadium",
            [](Random& r, std::size_t i) {
              return i < 8 ? cube(r.point(1e4), 1e3)
                           : cube(Vec3{3, 1, 7} + r.point(0.1), r.between(0, 0.01));
            },
            12},
    BoxKind{"flat",
            [](Random& r, std::size_t) {
              return around(r.point(10) * Vec3{1, 0, 1}, {r.unit(), 0, r.unit()});
            },
            15},
    BoxKind{"points_on_a_line",
            [](Random& r, std::size_t) {
              return cube({0, 0, std::floor(r.between(-9, 9))}, 0);
            },
            12},
    BoxKind{"huge_and_tiny",
            [](Random& r, std::size_t i) {
              return cube(r.point(i % 2 ? 1e9 : 1), r.unit() * (i % 2 ? 1e8 : 1e-9));
            },
            3},
    BoxKind{"coincident",
            [](Random&, std::size_t) {
              return cube({1, 2, 3}, 0.5);
            },
            6},
    BoxKind{"on_a_lattice",
            [](Random&, std::size_t i) {
              const Vec3 low{double(i % 5), double(i / 5 % 5), double(i / 25 % 5)};
              return Bounds{low, low + Vec3{1, 1, 1}};
            },
            8},
    BoxKind{"half_infinite",
            [](Random& r, std::size_t i) {
              Bounds b = cube(r.point(10), r.unit());
              if (i % 7 == 0) b.min[r.below(3)] = -kInfinity;
              if (i % 11 == 0) b.max[r.below(3)] = kInfinity;
              return i % 40 == 39 ? Bounds::all() : b;
            },
            15},
    BoxKind{"long_sticks",
            [](Random& r, std::size_t i) {
              Vec3 half{0.01, 0.01, 0.01};
              half[i % 3] = 10;
              return around(r.point(10), half);
            },
            15},
    BoxKind{"far_from_the_origin",
            [](Random& r, std::size_t) {
              return cube(Vec3{1e7, 0, -1e7} + r.point(5), r.unit());
            },
            2e7},
};

std::vector<Bounds> boxes_of(const BoxKind& kind, std::size_t count) {
  Random random{std::bit_cast<std::uint64_t>(kind.reach)};
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(kind.make(random, i));
  return boxes;
}

/// Where camera rays start: in the middle of a box, at the corner of one, or nowhere special.
Vec3 eye_of(double reach, const std::vector<Bounds>& boxes) {
  if (boxes.empty() || !boxes[0].finite() || boxes.size() > 300) return {reach, -0.5, 0.25};
  return boxes.size() % 2 == 0 ? boxes[0].max : boxes[0].center();
}

/// Rays at random, from the eye, along axes, along edges and within faces of boxes, from within
/// boxes, towards their corners and with a direction of -0.
Ray random_ray(Random& random, double reach, const std::vector<Bounds>& boxes) {
  Ray ray{random.point(reach), random.point(1)};
  if (boxes.empty()) return ray;
  const Bounds& box = boxes[random.below(boxes.size())];
  if (!box.finite()) return ray;
  const Vec3 corner = random.below(2) ? box.min : box.max;
  switch (random.below(9)) {
    case 0:
      ray.direction = corner - ray.origin;
      break;
    case 1:
      ray.direction = box.center() - ray.origin;
      break;
    case 2:
      ray.origin = corner;
      break;
    case 3:
      ray.origin = box.center();
      break;
    case 4:
      ray.origin[random.below(3)] = corner[random.below(3)];
      [[fallthrough]];
    case 5: {
      const double sign = random.below(2) ? 1 : -1;
      ray.direction = sign * Vec3{0, 0, 0};
      ray.direction[random.below(3)] = random.below(2) ? 1 : -1;
      const std::size_t axis = random.below(3);
      if (random.below(2)) ray.origin[axis] = corner[axis];
      break;
    }
    case 6:
      ray.origin = eye_of(reach, boxes);
      if (random.below(2)) ray.direction = random.between(0.1, 10) * (corner - ray.origin);
      break;
    case 7: {
      // Through the corner, to the last bit.
      const Vec3 step = random.point(8);
      ray.direction = 0x1p-10 * Vec3{std::floor(step.x), std::floor(step.y), std::floor(step.z)};
      ray.origin = corner - ray.direction;
      break;
    }
    default:
      break;
  }
  return ray;
}

Interval random_range(Random& random, double reach) {
  switch (random.below(4)) {
    case 0:
      return {-kInfinity, kInfinity};
    case 1:
      return {0, reach * random.unit()};
    case 2:
      return {reach * random.unit(), 2 * reach};
    default:
      return {0, kInfinity};
  }
}

/// The first box along a ray; of several the one of the least number.
class First final : public LeafVisitor {
 public:
  First(const std::vector<Bounds>& boxes, const Ray& ray, Interval range)
      : boxes_(boxes), ray_(ray), range_(range) {}

  bool visit(std::uint32_t item, Interval& range) override {
    const Interval inside = clip(boxes_[item], ray_, range_);
    if (inside.empty() || inside.min > entry) return true;
    if (inside.min == entry && item > first) return true;
    first = item;
    entry = range.max = inside.min;
    return true;
  }

  double entry = kInfinity;
  std::uint32_t first = 0xffffffff;

 private:
  const std::vector<Bounds>& boxes_;
  const Ray& ray_;
  Interval range_;
};

class Collect final : public LeafVisitor {
 public:
  bool visit(std::uint32_t item, Interval&) override {
    items.push_back(item);
    return true;
  }
  std::vector<std::uint32_t> items;
};

class EveryKindOfBox : public testing::TestWithParam<std::tuple<std::string_view, BoxKind>> {
 protected:
  const BoxKind& kind() const { return std::get<1>(GetParam()); }
  AcceleratorPtr make(const std::vector<Bounds>& boxes) const {
    return std::move(
        *make_accelerator(std::get<0>(GetParam()), boxes, {eye_of(kind().reach, boxes)}));
  }
};

TEST_P(EveryKindOfBox, GivesTheSameHitsAsNoStructure) {
  for (const std::size_t count : {0, 1, 2, 3, 150, 301}) {
    const auto boxes = boxes_of(kind(), count);
    const auto accelerator = make(boxes);
    const auto every = std::move(*make_accelerator("none", boxes));
    Random random{count};
    for (int i = 0; i < (count > 3 ? 3000 : 500); ++i) {
      const Ray ray = random_ray(random, kind().reach, boxes);
      const Interval range = random_range(random, kind().reach);
      First met(boxes, ray, range), expected(boxes, ray, range);
      accelerator->visit(ray, range, met);
      every->visit(ray, range, expected);
      ASSERT_EQ(std::bit_cast<std::uint64_t>(met.entry),
                std::bit_cast<std::uint64_t>(expected.entry))
          << count << " boxes, ray " << i;
      ASSERT_EQ(met.first, expected.first) << count << " boxes, ray " << i;
    }
  }
}

TEST_P(EveryKindOfBox, ReportsNoItemTwice) {
  const auto boxes = boxes_of(kind(), 400);
  const auto accelerator = make(boxes);
  Random random{5};
  for (int i = 0; i < 300; ++i) {
    Collect met;
    WalkCost cost;
    accelerator->visit(random_ray(random, kind().reach, boxes), Interval::all(), met, cost);
    EXPECT_EQ(cost.items, met.items.size());
    std::sort(met.items.begin(), met.items.end());
    ASSERT_EQ(std::adjacent_find(met.items.begin(), met.items.end()), met.items.end());
  }
}

TEST_P(EveryKindOfBox, FindsTheItemsAtAPoint) {
  const auto boxes = boxes_of(kind(), 300);
  const auto accelerator = make(boxes);
  Random random{6};
  for (int i = 0; i < 500; ++i) {
    const Bounds& box = boxes[random.below(boxes.size())];
    const bool somewhere = !box.finite() || random.below(3) == 0;
    const Vec3 p = somewhere ? random.point(kind().reach) : random.below(2) ? box.min : box.max;
    std::vector<std::uint32_t> items{7}, holding{7};
    accelerator->items_at(p, items);
    std::sort(items.begin() + 1, items.end());
    ASSERT_EQ(std::adjacent_find(items.begin() + 1, items.end()), items.end());
    std::erase_if(items, [&](std::uint32_t item) { return !boxes[item].contains(p); });
    std::erase_if(holding, [&](std::uint32_t item) { return !boxes[item].contains(p); });
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
      if (boxes[b].contains(p)) holding.push_back(b);
    }
    ASSERT_EQ(items, holding);
  }
}

TEST_P(EveryKindOfBox, IsBuiltTheSameEveryTime) {
  const auto boxes = boxes_of(kind(), 500);
  const auto one = make(boxes), two = make(boxes);
  EXPECT_EQ(one->statistics().nodes, two->statistics().nodes);
  EXPECT_EQ(one->statistics().bytes, two->statistics().bytes);
  Random random{7};
  for (int i = 0; i < 50; ++i) {
    const Ray ray = random_ray(random, kind().reach, boxes);
    Collect first, second;
    one->visit(ray, Interval::all(), first);
    two->visit(ray, Interval::all(), second);
    ASSERT_EQ(first.items, second.items);
  }
}

TEST_P(EveryKindOfBox, NeedsMemoryInProportion) {
  const std::size_t count = 20000;
  const auto size = make(boxes_of(kind(), count))->statistics();
  EXPECT_LE(size.references, 20 * count);
  EXPECT_LE(size.bytes, 600 * count);
}

std::string case_name(const testing::TestParamInfo<EveryKindOfBox::ParamType>& info) {
  std::string name(std::get<0>(info.param));
  name.append("_").append(std::get<1>(info.param).name);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

std::vector<std::string_view> names() {
  const auto all = accelerator_names();
  std::vector<std::string_view> names(all.begin(), all.end());
  names.insert(names.end(), {"slabs:3", "slabs:13", "extents:boxes", "extents:slabs:5"});
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, EveryKindOfBox,
                         testing::Combine(testing::ValuesIn(names()), testing::ValuesIn(kKinds)),
                         case_name);

TEST(Accelerators, SlabsTakeThreeToThirteenDirections) {
  for (const char* name : {"slabs:3", "slabs:4", "slabs:13", "extents:grid", "extents:slabs:7"})
    EXPECT_TRUE(make_accelerator(name, {}));
  for (const char* name :
       {"slabs:", "slabs:2", "slabs:14", "slabs:7x", "slabs:-3", "slabs:99999999999999999999",
        "slabs:+7", "extents:", "extents:x", "extents:extents:bvh"}) {
    EXPECT_FALSE(make_accelerator(name, {})) << name;
  }
}

}  // namespace
}  // namespace dioptre
