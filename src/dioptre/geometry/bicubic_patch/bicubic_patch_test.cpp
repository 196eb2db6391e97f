// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/bicubic_patch/bicubic_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dioptre/geometry/bicubic_patch/patch_pieces.h"

namespace dioptre {
namespace {

/// Over the unit square, z = 0 but for one control point.
BicubicPatch raised(std::size_t which, double height) {
  BicubicPatch patch;
  for (std::size_t i = 0; i < 16; ++i) {
    patch.points[i] = {static_cast<double>(i % 4) / 3, static_cast<double>(i / 4) / 3,
                       i == which ? height : 0};
  }
  return patch;
}

TEST(BicubicPatch, StepsHalveThePatchBetweenRowsAndBetweenColumns) {
  for (std::uint32_t u = 0; u < 4; ++u) {
    for (std::uint32_t v = 0; v < 4; ++v) {
      BicubicPatch patch = raised(5, 0.3);
      patch.u_steps = u, patch.v_steps = v;
      const auto pieces = patch_pieces(patch, 1000).value();
      ASSERT_EQ(pieces.size(), std::size_t{1} << (u + v));
      double area = 0;
      for (const PatchPiece& piece : pieces) {
        EXPECT_EQ(piece.rows, std::ldexp(1.0f, -static_cast<int>(u)));
        EXPECT_EQ(piece.columns, std::ldexp(1.0f, -static_cast<int>(v)));
        area += piece.rows * piece.columns;
        for (std::size_t i = 0; i < 4; ++i) {
          EXPECT_EQ(piece.corners[i].x, piece.place(i).x);
          EXPECT_EQ(piece.corners[i].y, piece.place(i).y);
        }
      }
      EXPECT_EQ(area, 1);
    }
  }
}

TEST(BicubicPatch, APieceIsFlatWhereAllPointsAreNearThePlaneOfItsFirstThreeCorners) {
  for (const std::size_t which : {1u, 5u, 11u, 15u}) {
    BicubicPatch patch = raised(which, 0.3);
    patch.u_steps = patch.v_steps = 1;
    patch.flatness = 0.2999;
    EXPECT_EQ(patch_pieces(patch, 1000)->size(), 4u);
    patch.flatness = 0.3001;
    EXPECT_EQ(patch_pieces(patch, 1000)->size(), 1u);
  }
}

TEST(BicubicPatch, APieceWithoutAPlaneIsNeverFlat) {
  BicubicPatch patch = raised(5, 0.01);
  patch.u_steps = patch.v_steps = 1;
  patch.flatness = 10;
  patch.points[12] = patch.points[0];
  EXPECT_EQ(patch_pieces(patch, 1000)->size(), 4u);
  patch = raised(5, 0.01);
  patch.u_steps = patch.v_steps = 1;
  patch.flatness = 10;
  patch.points[3] = patch.points[0];
  EXPECT_EQ(patch_pieces(patch, 1000)->size(), 1u) << "the last corner takes its place";
}

TEST(BicubicPatch, TheNormalIsThatOfTheExactSurfaceAndXWhereThereIsNone) {
  const BicubicPatch plane = raised(0, 0);
  EXPECT_EQ(patch_normal(plane, {0.3, 0.8}), (Vec3{0, 0, -1}));
  BicubicPatch point = plane;
  for (std::size_t i = 1; i < 4; ++i) point.points[i] = point.points[0];
  EXPECT_EQ(patch_normal(point, {0, 0}), (Vec3{1, 0, 0}));
  EXPECT_EQ(patch_normal(point, {0.5, 0.5}), (Vec3{0, 0, -1}));
}

TEST(BicubicPatch, TextureCoordinatesAreMixedBetweenTheCorners) {
  BicubicPatch patch = raised(0, 0);
  patch.u_steps = 2, patch.v_steps = 1;
  patch.uv_corners = {Vec2{0.1, 0.1}, Vec2{0.9, 0.2}, Vec2{0.7, 0.8}, Vec2{0.2, 0.6}};
  const ShapePtr shape = prepare(patch).value();
  for (const double x : {0.1, 0.45, 0.8}) {
    for (const double y : {0.2, 0.6, 0.7}) {
      const Ray ray{{x, y, -1}, {0, 0, 1}};
      Crossing hit;
      ASSERT_TRUE(shape->nearest(ray, {0, kInfinity}, hit));
      const Vec2 uv = shape->uv(ray, hit);
      EXPECT_NEAR(uv.x, (1 - y) * (0.1 + 0.8 * x) + y * (0.2 + 0.5 * x), 1e-12);
      EXPECT_NEAR(uv.y, (1 - y) * (0.1 + 0.1 * x) + y * (0.6 + 0.2 * x), 1e-12);
    }
  }
}

TEST(BicubicPatch, RefusesWhatItCannotDraw) {
  BicubicPatch patch = raised(5, 1);
  patch.u_steps = patch.v_steps = 4000000000u;
  EXPECT_FALSE(prepare(patch));
  patch.flatness = 0.1;
  EXPECT_TRUE(prepare(patch)) << "few pieces are needed";
  patch.flatness = std::nan("");
  EXPECT_FALSE(prepare(patch));
  patch = raised(5, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(prepare(patch));
}

}  // namespace
}  // namespace dioptre
