// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/height_field/height_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dioptre {
namespace {

HeightGrid grid_of(std::uint32_t width, std::uint32_t depth, std::vector<float> heights) {
  return {width, depth, std::move(heights)};
}

/// What a ray straight down sees.
Surface seen_at(const HeightField& field, double x, double z) {
  const ShapePtr shape = prepare(field).value();
  const Ray down{{x, 9, z}, {0, -1, 0}};
  Crossing hit;
  EXPECT_TRUE(shape->nearest(down, {0, kInfinity}, hit));
  return shape->surface(down, hit);
}

TEST(HeightField, CellsAreSplitFromTheirXToTheirZCorner) {
  const HeightField field{grid_of(2, 2, {1, 0.5f, 0.25f, 1})};
  EXPECT_DOUBLE_EQ(seen_at(field, 0.5, 0.5).position.y, 0.375);
}

TEST(HeightField, OnlyLandAboveTheWaterIsSeen) {
  const HeightField field{grid_of(2, 2, {0, 1, 0, 1}), 0.5};
  const ShapePtr shape = prepare(field).value();
  Crossing hit;
  EXPECT_FALSE(shape->nearest({{0.25, 9, 0.5}, {0, -1, 0}}, {0, kInfinity}, hit));
  EXPECT_TRUE(shape->nearest({{0.75, 9, 0.5}, {0, -1, 0}}, {0, kInfinity}, hit));
  EXPECT_TRUE(shape->contains({0.25, 0.4, 0.5}));
}

TEST(HeightField, ThePlainIsSmoothAndFlatAtAnyScale) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    HeightField field{
        grid_of(3, 3, {0, 0x1p-7f, 0x1p-6f, 0, 0x1p-7f, 0x1p-6f, 0, 0x1p-7f, 0x1p-6f}), 0, true};
    field.smooth_scale = {1, scale, 1};
    const Surface s = seen_at(field, 0.3, 0.7);
    // Steep land has few steps of normals: see Land.
    EXPECT_NEAR(dot(s.shading_normal, s.normal), 1, 0.1);
    EXPECT_NEAR(length(s.shading_normal), 1, 1e-12);
  }
}

TEST(HeightField, OddParametersAreErrors) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(prepare(HeightField{}));
  EXPECT_FALSE(prepare(HeightField{grid_of(1, 2, {0, 0})}));
  EXPECT_FALSE(prepare(HeightField{grid_of(2, 2, {0, 0, 0})}));
  EXPECT_FALSE(prepare(HeightField{grid_of(2, 2, {0, 0, 0, nan})}));
  EXPECT_FALSE(prepare(HeightField{grid_of(0xffffffff, 0xffffffff, {})}));
  EXPECT_FALSE(prepare(HeightField{grid_of(2, 2, {0, 0, 0, 0}), kInfinity}));
  HeightField flattened{grid_of(2, 2, {0, 0, 0, 0}), 0, true};
  flattened.smooth_scale.y = 0;
  EXPECT_FALSE(prepare(flattened));
}

}  // namespace
}  // namespace dioptre
