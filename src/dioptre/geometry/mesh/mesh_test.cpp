// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/mesh/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/geometry/triangle/triangle.h"

namespace dioptre {
namespace {

/// A closed sphere of radius 2 with `bands` by 2 `bands` quads, as triangles.
MeshData globe(Vec3 center, std::uint32_t bands) {
  MeshData data;
  const double pi = std::acos(-1);
  const std::uint32_t around = 2 * bands;
  data.corners = {center + Vec3{0, 2, 0}, center + Vec3{0, -2, 0}};
  for (std::uint32_t i = 1; i < bands; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const double theta = pi * i / bands, phi = 2 * pi * k / around;
      data.corners.push_back(center + 2 * Vec3{std::sin(theta) * std::cos(phi), std::cos(theta),
                                               std::sin(theta) * std::sin(phi)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t k) {
    return i == 0 ? 0 : i == bands ? 1 : 2 + (i - 1) * around + k % around;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    MeshData::Face face;
    face.corners = {a, b, c};
    data.faces.push_back(face);
  };
  for (std::uint32_t i = 0; i < bands; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      add(at(i, k), at(i, k + 1), at(i + 1, k + 1));
      add(at(i, k), at(i + 1, k + 1), at(i + 1, k));
    }
  }
  return data;
}

Mesh solid(MeshData data) {
  Mesh mesh;
  mesh.data = std::move(data);
  mesh.inside_vector = {0, 1, 0};
  return mesh;
}

TEST(Mesh, RaysAtCornersAndEdgesOfAFarClosedMeshDoNotLeak) {
  const Vec3 center{148376, 1234, -223423};
  const MeshData data = globe(center, 24);
  const ShapePtr shape = prepare(solid(data)).value();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Vec3> targets = data.corners;
  for (const auto& face : data.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      targets.push_back(0.5 *
                        (data.corners[face.corners[i]] + data.corners[face.corners[(i + 1) % 3]]));
    }
  }
  for (const Vec3 target : targets) {
    for (int k = 0; k < 3; ++k) {
      const double x = u(random), y = u(random), z = u(random);
      const Vec3 from = k == 0 ? center : center + Vec3{x, y, z};
      Crossings out;
      EXPECT_TRUE(shape->crossings({from, target - from}, {0, kInfinity}, out));
      EXPECT_EQ(out.size(), 1u);
      out.clear();
      EXPECT_FALSE(shape->crossings({from, target - from}, Interval::all(), out));
      EXPECT_EQ(out.size(), 2u);
    }
  }
}

TEST(Mesh, RaysAlongTheAxesThroughCornersOfABoxHaveEvenParity) {
  MeshData data;
  for (int i = 0; i < 8; ++i) {
    data.corners.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
  }
  const std::uint32_t quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                     {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  for (const auto& q : quads) {
    for (const auto& corners : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
      MeshData::Face face;
      face.corners = corners;
      data.faces.push_back(face);
    }
  }
  const ShapePtr shape = prepare(solid(data)).value();
  int met = 0;
  for (int d = 1; d < 27; ++d) {
    const Vec3 direction{d % 3 - 1.0, d / 3 % 3 - 1.0, d / 9 - 1.0};
    if (direction == Vec3{}) continue;
    for (int p = 0; p < 27; ++p) {  // corners, middles of edges and of faces, the center
      const Vec3 target{p % 3 * 0.5, p / 3 % 3 * 0.5, p / 9 * 0.5};
      Crossings out;
      shape->crossings({target - 4 * direction, direction}, Interval::all(), out);
      EXPECT_EQ(out.size() % 2, 0u);
      met += !out.empty();
    }
  }
  EXPECT_GT(met, 300);
}

TEST(Mesh, NearestIsTheFirstCrossing) {
  for (bool as_solid : {false, true}) {
    Mesh mesh = solid(globe({}, 16));
    if (!as_solid) mesh.inside_vector = {};
    const ShapePtr shape = prepare(mesh).value();
    EXPECT_EQ(shape->solid(), as_solid);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(-3, 3);
    for (int i = 0; i < 3000; ++i) {
      const double x = u(random), y = u(random), z = u(random);
      const Ray ray{{x, y, z}, {u(random), u(random), u(random)}};
      Crossings out;
      shape->crossings(ray, {0, kInfinity}, out);
      Crossing first;
      ASSERT_EQ(shape->nearest(ray, {0, kInfinity}, first), !out.empty());
      if (out.empty()) continue;
      EXPECT_EQ(first.t, out[0].t);
      EXPECT_EQ(first.face, out[0].face);
      EXPECT_EQ(first.entering, out[0].entering);
      const Surface s = shape->surface(ray, first);
      EXPECT_NEAR(length(s.position - ray.at(first.t)), 0, 1e-12);
      if (as_solid) {
        EXPECT_GT(dot(s.normal, s.position), 0);
      }
    }
  }
}

// Reference values: the same triangles in POV-Ray 3.7, by its trace() function.
TEST(Triangle, NormalsAreThoseOfPovRay) {
  Triangle t;
  const Ray ray{{0.2, 0.3, -3}, {0, 0, 1}};
  Crossing c;
  ShapePtr shape = prepare(t).value();
  ASSERT_TRUE(shape->nearest(ray, {0, kInfinity}, c));
  EXPECT_EQ(c.t, 3);
  EXPECT_EQ(shape->surface(ray, c).normal, (Vec3{0, 0, -1}));
  t.normals = {{0, 0, -1}, {0, 3, -4}, {0, 0, -1}};
  shape = prepare(t).value();
  ASSERT_TRUE(shape->nearest(ray, {0, kInfinity}, c));
  const Vec3 smooth = shape->surface(ray, c).shading_normal;
  EXPECT_NEAR(length(smooth - Vec3{0, 0.124035, -0.992278}), 0, 1e-6);
}

TEST(Triangle, OnesWithoutAreaAreEmpty) {
  Triangle t;
  t.c = {2, 0, 0};
  const ShapePtr shape = prepare(t).value();
  EXPECT_TRUE(shape->bounds().empty());
  Crossing c;
  EXPECT_FALSE(shape->nearest({{0.5, 0, -1}, {0, 0, 1}}, {0, kInfinity}, c));
}

TEST(Mesh, TextureCoordinatesAndNormalsAreMixedByPlace) {
  MeshData data;
  data.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.normals = {{0, 0, -2}, {0, 4, 0}};
  data.uvs = {{0, 0}, {1, 0}, {1, 1}};
  MeshData::Face face;
  face.corners = {0, 1, 2};
  face.normals = {0, 1, 0};
  face.uvs = {0, 1, 2};
  data.faces = {face};
  Mesh mesh;
  mesh.data = data;
  const ShapePtr shape = prepare(mesh).value();
  const Ray ray{{0.2, 0.3, 3}, {0, 0, -2}};
  Crossing c;
  ASSERT_TRUE(shape->nearest(ray, {0, kInfinity}, c));
  EXPECT_NEAR(c.t, 1.5, 1e-15);
  const Surface s = shape->surface(ray, c);
  EXPECT_NEAR(shape->uv(ray, c).x, 0.5, 1e-15);
  EXPECT_NEAR(shape->uv(ray, c).y, 0.3, 1e-15);
  EXPECT_NEAR(length(s.shading_normal - Vec3{0, 0.242536, -0.970143}), 0, 1e-6);
}

TEST(Mesh, WrongIndicesAreRefused) {
  MeshData data;
  data.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  data.faces.resize(4);
  data.faces[3].corners = {0, 1, 9};
  EXPECT_EQ(prepare(solid(data)).error().message, "mesh face 3 refers to corner 9 of 4");
  data.faces[3].corners = {0, 1, 2};
  data.normals = {{0, 0, 1}};
  data.faces[2].normals = {0, 1, 0};
  EXPECT_EQ(prepare(solid(data)).error().message, "mesh face 2 refers to normal 1 of 1");
  data.corners[1].x = std::nan("");
  EXPECT_EQ(prepare(solid(data)).error().message, "mesh corner 1 is not finite");
  EXPECT_TRUE(prepare(Mesh{}).value()->bounds().empty());
}

TEST(Mesh, AnyStructureOverItsFacesGivesTheSameBits) {
  const Mesh mesh = solid(globe({1, 2, 3}, 10));
  const ShapePtr usual = prepare(mesh).value();
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Ray> rays;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin{1 + 4 * u(random), 2 + 4 * u(random), 3 + 4 * u(random)};
    rays.push_back({origin, Vec3{1 + u(random), 2 + u(random), 3 + u(random)} - origin});
  }
  for (const std::string_view name : accelerator_names()) {
    const ShapePtr other = prepare(mesh, {std::string(name)}).value();
    for (const Ray& ray : rays) {
      Crossing a, b;
      const bool hit = usual->nearest(ray, {0, kInfinity}, a);
      ASSERT_EQ(other->nearest(ray, {0, kInfinity}, b), hit) << name;
      if (hit) {
        EXPECT_TRUE(a.t == b.t && a.face == b.face && a.entering == b.entering) << name;
      }
      ASSERT_EQ(usual->contains(ray.origin), other->contains(ray.origin)) << name;
    }
  }
}

/// As POV-Ray 3.7 shades them.
TEST(Mesh, AFaceOfThreeEqualNormalsIsFlat) {
  MeshData data;
  data.corners = {{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}};
  const Vec3 tilted = normalize(Vec3{0.6, 0.2, -1});
  MeshData::Face face;
  face.corners = face.normals = {0, 1, 2};
  data.faces = {face};
  for (const double apart : {0.0, 1e-9}) {
    data.normals = {tilted, tilted + Vec3{apart, 0, 0}, tilted};
    Mesh mesh;
    mesh.data = data;
    const ShapePtr shape = prepare(mesh).value();
    const Ray ray{{0, 0, -5}, {0, 0, 1}};
    Crossing c;
    ASSERT_TRUE(shape->nearest(ray, {0, kInfinity}, c));
    const Vec3 expected = apart == 0 ? Vec3{0, 0, -1} : tilted;
    const Vec3 found = shape->surface(ray, c).shading_normal;
    EXPECT_NEAR(std::fabs(dot(found, expected)), 1, 1e-6) << apart;
  }
}

}  // namespace
}  // namespace dioptre
