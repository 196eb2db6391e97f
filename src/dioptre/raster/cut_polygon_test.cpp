// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/cut_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dioptre {
namespace {

/// How many of the triangles hold a point of their plane z = 0.
int count_around(const std::vector<Vec3>& corners, Vec2 p) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    bool left = true, right = true;
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 a = corners[i + j], b = corners[i + (j + 1) % 3];
      const double side = cross(Vec2{b.x - a.x, b.y - a.y}, Vec2{p.x - a.x, p.y - a.y});
      left = left && side > 0;
      right = right && side < 0;
    }
    count += left || right;
  }
  return count;
}

TEST(CutPolygon, ItsTrianglesAreThePolygonOnce) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 100; ++n) {
    Polygon polygon;
    for (int outline = 0; outline < 1 + n % 3; ++outline) {
      polygon.outlines.emplace_back();
      for (int i = 0; i < 3 + n % 9; ++i) {
        polygon.outlines.back().push_back({unit(random), unit(random), 0});
      }
    }
    const auto corners = cut_into_triangles(polygon);
    ASSERT_TRUE(corners);
    const auto shape = prepare(polygon);
    ASSERT_TRUE(shape);
    for (int i = 0; i < 100; ++i) {
      const Vec2 p{unit(random), unit(random)};
      Crossing crossing;
      const bool inside = (*shape)->nearest({{p.x, p.y, -1}, {0, 0, 1}}, {0, kInfinity}, crossing);
      EXPECT_EQ(count_around(*corners, p), inside ? 1 : 0) << n << ": " << p.x << ", " << p.y;
    }
  }
}

TEST(CutPolygon, OneWithoutAreaHasNoTriangles) {
  Polygon line;
  line.outlines = {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
  const auto corners = cut_into_triangles(line);
  ASSERT_TRUE(corners);
  EXPECT_TRUE(corners->empty());
}

TEST(CutPolygon, OneOfVeryManySidesIsLeftToOthers) {
  Polygon round;
  round.outlines.emplace_back();
  for (int i = 0; i < 1000; ++i) {
    round.outlines[0].push_back({std::cos(0.006283 * i), std::sin(0.006283 * i), 0});
  }
  EXPECT_FALSE(cut_into_triangles(round));
}

}  // namespace
}  // namespace dioptre
