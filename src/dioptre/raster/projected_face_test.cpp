// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/projected_face.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dioptre/film/camera_rays.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kWidth = 40, kHeight = 30;

Camera camera_of(bool perspective) {
  Camera camera;
  camera.kind = perspective ? Camera::Kind::kPerspective : Camera::Kind::kOrthographic;
  camera.location = {1, 2, -4};
  camera.direction = {0.1, -0.2, 1.1};
  camera.right = {4, 0.1, 0};
  camera.up = {0, 3, 0.2};
  return camera;
}

ScreenView view_of(const Camera& camera) { return *ScreenView::prepare(camera, kWidth, kHeight); }

/// Moeller and Trumbore's test, as the other way to tell; the distance, or nothing.
std::optional<double> met(const Ray& ray, const std::array<Vec3, 3>& world) {
  const Vec3 u = world[1] - world[0], v = world[2] - world[0], s = ray.origin - world[0];
  const Vec3 p = cross(ray.direction, v), q = cross(s, u);
  const double det = dot(u, p);
  const double a = dot(s, p) / det, b = dot(ray.direction, q) / det, t = dot(v, q) / det;
  if (!(a >= 0 && b >= 0 && a + b <= 1 && t > 0)) return std::nullopt;
  return t;
}

std::array<Vec3, 3> in_view(const ScreenView& view, const std::array<Vec3, 3>& world) {
  return {view.to_view(world[0]), view.to_view(world[1]), view.to_view(world[2])};
}

/// The triangles of a law: small and huge ones, many of them through the plane of the eye.
std::array<Vec3, 3> random_triangle(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const double size = std::exp(6 * unit(random));
  const Vec3 about = Vec3{1, 2, -4} + 3 * Vec3{unit(random), unit(random), unit(random)};
  std::array<Vec3, 3> world;
  for (Vec3& corner : world) {
    corner = about + size * Vec3{unit(random), unit(random), unit(random)};
  }
  return world;
}

TEST(ProjectedFace, CoversWhatRaysMeetAtTheSameDepth) {
  std::mt19937 random(3);
  for (int n = 0; n < 2000; ++n) {
    const Camera camera = camera_of(n % 2 == 0);
    const ScreenView view = view_of(camera);
    const auto rays = CameraRays::prepare(camera);
    const std::array<Vec3, 3> world = random_triangle(random), corners = in_view(view, world);
    const auto face = ProjectedFace::prepare(view, corners, 0);
    ASSERT_TRUE(face);
    const PixelBox box = pixel_box(view, corners, 0);
    for (int i = 0; i < 30; ++i) {
      const auto column = static_cast<std::int64_t>(random() % kWidth);
      const auto row = static_cast<std::int64_t>(random() % kHeight);
      const Vec2 place{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
      const auto depth = face->depth(place);
      const auto t = met(*rays->ray(place.x, place.y, kWidth, kHeight), world);
      EXPECT_EQ(depth.has_value(), t.has_value());
      if (!depth || !t) continue;
      EXPECT_NEAR(*depth * length(view.forward(place)), *t, 1e-9 * (1 + *t));
      EXPECT_TRUE(box.first_column <= column && column < box.end_column);
      EXPECT_TRUE(box.first_row <= row && row < box.end_row);
    }
  }
}

TEST(ProjectedFace, AHugeTriangleThroughTheEyeIsSeenAheadOnly) {
  const Camera camera = camera_of(true);
  const ScreenView view = view_of(camera);
  // A floor under the eye and a ceiling of the same size, both far behind the eye and ahead of it.
  for (const double side : {-1.0, 1.0}) {
    const Vec3 eye = camera.location + Vec3{0, side, 0};
    const std::array<Vec3, 3> corners =
        in_view(view, {eye + Vec3{-1e6, 0, -1e6}, eye + Vec3{1e6, 0, -1e6}, eye + Vec3{0, 0, 1e6}});
    const auto face = ProjectedFace::prepare(view, corners, 0);
    ASSERT_TRUE(face);
    EXPECT_EQ(face->depth({kWidth / 2.0, 0.5}).has_value(), side > 0);
    EXPECT_EQ(face->depth({kWidth / 2.0, kHeight - 0.5}).has_value(), side < 0);
  }
  const std::array<Vec3, 3> behind =
      in_view(view, {Vec3{-9, -9, -9}, Vec3{9, -9, -9}, Vec3{0, 20, -9}});
  EXPECT_TRUE(pixel_box(view, behind, 0).empty());
}

TEST(ProjectedFace, NeighboursLeaveNoGap) {
  std::mt19937 random(4);
  for (int n = 0; n < 500; ++n) {
    const ScreenView view = view_of(camera_of(n % 2 == 0));
    // Four corners of a quadrilateral, one in each quadrant around a pixel's centre.
    const Vec2 center{20.5, 15.5};
    std::uniform_real_distribution<double> unit(0.01, 3);
    std::array<Vec3, 4> c;
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = unit(random), y = unit(random);
      const Vec2 offset{i == 0 || i == 3 ? x : -x, i < 2 ? y : -y};
      c[i] = view.at(center + offset, 1 + unit(random));
    }
    const auto covers = [&](std::size_t a, std::size_t b, std::size_t d) {
      const auto face = ProjectedFace::prepare(view, {c[a], c[b], c[d]}, 0);
      return face && face->depth(center).has_value();
    };
    EXPECT_TRUE(covers(0, 1, 2) || covers(0, 2, 3));
  }
}

TEST(ProjectedFace, DegenerateTrianglesCoverNothing) {
  const double nan = std::nan("");
  const ScreenView view = view_of(camera_of(true));
  const std::array<std::array<Vec3, 3>, 5> all{{{Vec3{20, 15, 1}, Vec3{20, 15, 1}, Vec3{20, 15, 1}},
                                                {Vec3{0, 0, 1}, Vec3{20, 15, 1}, Vec3{40, 30, 1}},
                                                {Vec3{20, 15, 1}, Vec3{40, 30, 2}, Vec3{60, 45, 3}},
                                                {Vec3{nan, 0, 1}, Vec3{40, 0, 1}, Vec3{0, 30, 1}},
                                                {Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{0, 30, 1}}}};
  for (const auto& corners : all) {
    const auto face = ProjectedFace::prepare(view, corners, 0);
    for (std::uint32_t y = 0; y < kHeight && face; ++y) {
      for (std::uint32_t x = 0; x < kWidth; ++x) EXPECT_FALSE(face->depth({x + 0.5, y + 0.5}));
    }
  }
  EXPECT_TRUE(pixel_box(view, all[3], 0).empty());
}

TEST(ProjectedFace, AMarginWidensItByThatMuch) {
  Camera camera;
  const ScreenView view = view_of(camera);
  const std::array<Vec3, 3> corners{view.at({10, 5}, 2), view.at({10, 25}, 2),
                                    view.at({30, 15}, 3)};
  const auto narrow = ProjectedFace::prepare(view, corners, 0);
  const auto wide = ProjectedFace::prepare(view, corners, 1.5);
  EXPECT_FALSE(narrow->depth({9.9, 15}));
  EXPECT_TRUE(wide->depth({8.6, 15}));
  EXPECT_FALSE(wide->depth({8.4, 15}));
  for (double y = 0.5; y < kHeight; ++y) {
    for (double x = 0.5; x < kWidth; ++x) {
      const auto a = narrow->depth({x, y}), b = wide->depth({x, y});
      EXPECT_TRUE(!a || a == b);
      EXPECT_TRUE(!b || (*b >= 2 && *b <= 3));
    }
  }
}

}  // namespace
}  // namespace dioptre
