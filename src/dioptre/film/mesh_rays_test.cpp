// SPDX-License-Identifier: Apache-2.0
// Which face a pixel belongs to was measured with POV-Ray 3.7.
#include "dioptre/film/mesh_rays.h"

#include <gtest/gtest.h>

#include <limits>

#include "dioptre/film/camera_rays.h"

namespace dioptre {
namespace {

using Distribution = MeshCamera::Distribution;

/// Triangles in a row along x, one unit apart; face k has its centroid at x = first + k.
CameraMesh row_of(std::uint32_t count, double first) {
  MeshData data;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double x = first + k;
    const std::uint32_t corner = 3 * k;
    data.corners.insert(data.corners.end(), {{x - 0.1, 0, 0}, {x + 0.2, 0, 0}, {x - 0.1, 1, 0}});
    data.faces.push_back({{corner, corner + 1, corner + 2}});
  }
  return {Shared<MeshData>(std::move(data)), {}};
}

/// One face over the lower left half of the texture square and of the square of x and y.
CameraMesh corner_face() {
  MeshData data;
  data.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.normals = {{0, 0, -1}, {3, 0, 0}, {0, 2, 0}};
  data.uvs = {{0, 0}, {1, 0}, {0, 1}};
  data.faces.push_back({{0, 1, 2}, {0, 1, 2}, {0, 1, 2}});
  return {Shared<MeshData>(std::move(data)), {}};
}

MeshCamera camera_of(Distribution distribution, std::vector<CameraMesh> meshes) {
  MeshCamera camera;
  camera.distribution = distribution;
  camera.meshes = std::move(meshes);
  return camera;
}

/// The centroid that the ray of a pixel leaves; -1 where there is no ray.
double place_of(const MeshRays& rays, std::uint32_t column, std::uint32_t row, std::uint32_t width,
                std::uint32_t height, std::uint32_t number = 0) {
  const auto ray = rays.ray(column + 0.5, row + 0.5, width, height, number);
  return ray ? ray->origin.x : -1;
}

TEST(MeshRays, PixelsCountAlongTheRowsTheFirstOfWhichIsSeenTwice) {
  const auto rays = MeshRays::prepare(camera_of(Distribution::kEach, {row_of(10, 0)}));
  for (std::uint32_t column = 0; column < 4; ++column) {
    EXPECT_NEAR(place_of(*rays, column, 0, 4, 4), column, 1e-12);
    EXPECT_NEAR(place_of(*rays, column, 1, 4, 4), column, 1e-12);
    EXPECT_NEAR(place_of(*rays, column, 2, 4, 4), 4 + column, 1e-12);
    EXPECT_NEAR(place_of(*rays, column, 3, 4, 4), column < 2 ? 8.0 + column : -1.0, 1e-12);
  }
}

TEST(MeshRays, EachRayOfAPixelLeavesItsOwnMesh) {
  MeshCamera camera = camera_of(Distribution::kEach, {row_of(4, 0), row_of(2, 30)});
  camera.rays_per_pixel = 2;
  const auto rays = MeshRays::prepare(camera);
  EXPECT_EQ(rays->rays_per_pixel(), 2u);
  EXPECT_NEAR(place_of(*rays, 1, 0, 2, 4, 1), 31, 1e-12);
  EXPECT_NEAR(place_of(*rays, 1, 2, 2, 4, 0), 3, 1e-12);
  EXPECT_EQ(place_of(*rays, 1, 2, 2, 4, 1), -1);
  camera.rays_per_pixel = 3;
  EXPECT_FALSE(MeshRays::prepare(camera));
}

TEST(MeshRays, ASumGoesOnWithTheFacesOfTheNextMesh) {
  const auto rays = MeshRays::prepare(camera_of(Distribution::kSum, {row_of(3, 0), row_of(3, 20)}));
  EXPECT_NEAR(place_of(*rays, 2, 0, 4, 4), 2, 1e-12);
  EXPECT_NEAR(place_of(*rays, 3, 0, 4, 4), 20, 1e-12);
  EXPECT_NEAR(place_of(*rays, 1, 2, 4, 4), 22, 1e-12);
  EXPECT_EQ(place_of(*rays, 2, 2, 4, 4), -1);
}

TEST(MeshRays, SideBySideEachMeshHasAShareOfTheWidth) {
  const auto rays = MeshRays::prepare(
      camera_of(Distribution::kSideBySide, {row_of(16, 0), row_of(16, 20), row_of(16, 40)}));
  const double expected[4][4] = {
      {0, 21, 22, 43}, {0, 21, 22, 43}, {1, 22, 23, 44}, {2, 23, 24, 45}};
  for (std::uint32_t row = 0; row < 4; ++row) {
    for (std::uint32_t column = 0; column < 4; ++column) {
      EXPECT_NEAR(place_of(*rays, column, row, 4, 4), expected[row][column], 1e-12);
    }
  }
}

TEST(MeshRays, TextureCoordinatesPlaceTheOriginAndSmoothTheDirection) {
  MeshCamera camera = camera_of(Distribution::kUv, {corner_face()});
  const auto flat = MeshRays::prepare(camera);
  const auto ray = flat->ray(1.5, 3.5, 4, 4, 0);
  ASSERT_TRUE(ray);
  EXPECT_NEAR(length(ray->origin - Vec3{0.25, 0.25, 0}), 0, 1e-12);
  EXPECT_NEAR(length(ray->direction - Vec3{0, 0, -1}), 0, 1e-12);
  EXPECT_FALSE(flat->ray(3.5, 0.5, 4, 4, 0));
  camera.smooth = true;
  const auto smooth = MeshRays::prepare(camera)->ray(1.5, 3.5, 4, 4, 0);
  EXPECT_NEAR(length(smooth->direction - normalize(Vec3{1, 1, -2})), 0, 1e-12);
}

TEST(MeshRays, TheOffsetRunsAlongTheNormalAndBackwardsTurnsTheRayOnly) {
  MeshCamera camera = camera_of(Distribution::kEach, {row_of(1, 0)});
  camera.offset = 2;
  const auto forwards = MeshRays::prepare(camera)->ray(0.5, 0.5, 1, 1, 0);
  camera.backwards = true;
  const auto backwards = MeshRays::prepare(camera)->ray(0.5, 0.5, 1, 1, 0);
  EXPECT_NEAR(forwards->origin.z, -2, 1e-12);
  EXPECT_NEAR(forwards->direction.z, -1, 1e-12);
  EXPECT_EQ(backwards->origin, forwards->origin);
  EXPECT_NEAR(backwards->direction.z, 1, 1e-12);
}

TEST(MeshRays, MeshesThatCannotBeReadAreRefused) {
  MeshData wrong = *row_of(2, 0).data;
  wrong.faces[1].corners[2] = 100;
  EXPECT_FALSE(MeshRays::prepare(camera_of(Distribution::kEach, {{Shared(wrong), {}}})));
  MeshData endless = *row_of(2, 0).data;
  endless.corners[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(MeshRays::prepare(camera_of(Distribution::kEach, {{Shared(endless), {}}})));
  EXPECT_FALSE(MeshRays::prepare(camera_of(Distribution::kEach, {})));
  Camera camera;
  camera.kind = Camera::Kind::kMesh;
  EXPECT_FALSE(CameraRays::prepare(camera));
}

TEST(MeshRays, HostileTextureCoordinatesFindNothing) {
  MeshData data = *corner_face().data;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {nan, 1e308, -1e308, std::numeric_limits<double>::infinity()}) {
    data.uvs = {{value, 0}, {0, value}, {value, value}};
    const auto rays = MeshRays::prepare(camera_of(Distribution::kUv, {{Shared(data), {}}}));
    ASSERT_TRUE(rays);
    rays->ray(1.5, 1.5, 4, 4, 0);
  }
}

}  // namespace
}  // namespace dioptre
