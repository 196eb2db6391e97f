// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/raster_scenes_test.h"

#include <cmath>
#include <numbers>

namespace dioptre {
namespace {

const Affine kTurned = rotation({25, 35, 10});

ObjectId add(Scene& scene, Object object) {
  const ObjectId id = append(scene.objects, std::move(object));
  scene.roots.push_back(id);
  return id;
}

Scene of(ShapeData shape, const Affine& transform = kTurned) {
  Scene scene = empty_scene();
  Object object = object_of(std::move(shape));
  object.transform = transform;
  add(scene, object);
  return scene;
}

Scene of_csg(CsgOperation operation, std::vector<Object> parts) {
  Scene scene = empty_scene();
  Csg csg{operation, {}};
  for (Object& part : parts) csg.children.push_back(append(scene.objects, std::move(part)));
  Object whole;
  whole.geometry = csg;
  whole.transform = kTurned;
  add(scene, whole);
  return scene;
}

Mesh octahedron(bool solid) {
  MeshData data;
  data.corners = {{1.5, 0, 0}, {-1.5, 0, 0}, {0, 1.5, 0}, {0, -1.5, 0}, {0, 0, 1.5}, {0, 0, -1.5}};
  for (std::uint32_t x = 0; x < 2; ++x) {
    for (std::uint32_t y = 2; y < 4; ++y) {
      for (std::uint32_t z = 4; z < 6; ++z) data.faces.push_back({{x, y, z}});
    }
  }
  Mesh mesh;
  mesh.data = data;
  if (solid) mesh.inside_vector = {0.1, 1, 0.2};
  return mesh;
}

/// A five-pointed star whose sides cross each other, with a square hole.
Polygon star() {
  Polygon polygon;
  std::vector<Vec3> points;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4 * std::numbers::pi * i / 5;
    points.push_back({2 * std::sin(angle), 2 * std::cos(angle), 0});
  }
  polygon.outlines = {points, {{1, 0.4, 0}, {1.4, 0.4, 0}, {1.4, 0.7, 0}, {1, 0.7, 0}}};
  return polygon;
}

HeightField hills() {
  HeightGrid grid{17, 17, {}};
  for (int z = 0; z < 17; ++z) {
    for (int x = 0; x < 17; ++x) {
      grid.heights.push_back(
          static_cast<float>(0.3 + 0.15 * std::sin(x * 0.9) + 0.15 * std::cos(z * 0.7)));
    }
  }
  HeightField field;
  field.grid = grid;
  return field;
}

Blob two_drops() {
  Blob blob;
  blob.threshold = 0.4;
  blob.components = {{{-0.8, 0, 0}, {}, false, 1.5, 1}, {{0.8, 0.3, 0}, {}, false, 1.3, 1}};
  return blob;
}

Scene room() {
  Scene scene = empty_scene();
  MeshData data;
  for (int i = 0; i < 8; ++i) {
    data.corners.push_back({i & 1 ? 20.0 : -20.0, i & 2 ? 12.0 : -8.0, i & 4 ? 30.0 : -30.0});
  }
  data.faces = {{{0, 1, 3}}, {{0, 3, 2}}, {{4, 5, 7}}, {{4, 7, 6}}, {{0, 1, 5}}, {{0, 5, 4}},
                {{2, 3, 7}}, {{2, 7, 6}}, {{0, 2, 6}}, {{0, 6, 4}}, {{1, 3, 7}}, {{1, 7, 5}}};
  Mesh mesh;
  mesh.data = data;
  Object walls = object_of(mesh);
  walls.transform = rotation({3, 20, 5});
  add(scene, walls);
  add(scene, object_of(Sphere{{0, 0, 2}, 1}));
  return scene;
}

Scene crowd() {
  Scene scene = empty_scene();
  for (int i = 0; i < 200; ++i) {
    const double angle = 2.4 * i, radius = 0.18 * std::sqrt(i);
    const Vec3 center{radius * std::cos(angle), radius * std::sin(angle), 0.02 * (i % 37)};
    add(scene, object_of(Sphere{center, 0.05 + 0.002 * (i % 50)}));
  }
  return scene;
}

Scene orthographic(Scene scene) {
  scene.camera.kind = Camera::Kind::kOrthographic;
  scene.camera.right = {5.3, 0, 0};
  scene.camera.up = {0, 4, 0};
  return scene;
}

/// Items of unions in unions, each with a place of its own; one is not seen.
Scene nested_unions() {
  Scene scene = empty_scene();
  Object ball = object_of(Sphere{{-1, 0, 0}, 0.7}), hidden = object_of(Sphere{{0, 0, -2}, 1});
  hidden.no_image = true;
  Object ring = object_of(Torus{0.8, 0.2}), block = object_of(Box{{0, 0, 0}, {1, 1, 1}});
  Object inner, outer, hollowed;
  hollowed.geometry =
      Csg{CsgOperation::kDifference, {append(scene.objects, block), append(scene.objects, ball)}};
  hollowed.transform = translation({0.2, 0.7, 0});
  inner.geometry = Csg{CsgOperation::kUnion,
                       {append(scene.objects, hidden), append(scene.objects, ball),
                        append(scene.objects, hollowed), append(scene.objects, ring)}};
  inner.transform = then(rotation({40, 20, 0}), translation({0.5, -0.5, 0}));
  outer.geometry =
      Csg{CsgOperation::kUnion, {append(scene.objects, inner), append(scene.objects, block)}};
  outer.transform = scaling({1.2, 1, 0.8});
  add(scene, outer);
  return scene;
}

Scene clipped_sphere() {
  Scene scene = empty_scene();
  const ObjectId clip = append(scene.objects, object_of(Plane{{1, 1, -1}, 0.2}));
  Object ball = object_of(Sphere{{}, 1.8});
  ball.clipped_by = {clip};
  add(scene, ball);
  return scene;
}

Scene on_a_floor(Scene scene) {
  add(scene, object_of(Plane{{0, 1, 0}, -1.5}));
  return scene;
}

}  // namespace

Object object_of(ShapeData shape) {
  Object object;
  object.geometry = std::move(shape);
  return object;
}

Scene empty_scene() {
  Scene scene;
  const PigmentId pigment =
      append(scene.pigments, Pigment{SolidPigment{{{0.8f, 0.6f, 0.4f}}}, {}, false});
  scene.default_texture =
      append(scene.textures, Texture{LayeredTexture{{{pigment, {}, {}, {}}}}, {}});
  scene.camera.location = {0, 1, -6};
  scene.camera.direction = {0, 0, 1.3};
  scene.lights.push_back({.location = {-5, 8, -6}});
  scene.atmosphere.background = {0.1f, 0.2f, 0.4f};
  return scene;
}

std::vector<RasterScene> raster_scenes() {
  const auto placed = [](ShapeData shape, Vec3 by) {
    Object object = object_of(std::move(shape));
    object.transform = translation(by);
    return object;
  };
  const Cylinder rod{{-2, 0, 0}, {2, 0, 0}, 0.6};
  const Cylinder post{{0, -2, 0}, {0, 2, 0}, 0.6};
  return {
      {"Triangle", of(Triangle{{-2, -1, 0}, {2, -0.5, 1}, {0, 2, -1}})},
      {"MeshSheet", of(octahedron(false))},
      {"MeshSolid", of(octahedron(true))},
      {"PolygonStar", of(star())},
      {"Box", of(Box{{-1, -1.5, -1}, {1, 1.2, 1}})},
      {"DiscWithHole", of(Disc{{}, {0.3, 0.2, -1}, 2, 0.7})},
      {"Plane", of(Plane{{0.1, 1, 0.2}, -1})},
      {"Sphere", of(Sphere{{0.3, 0.2, 0}, 1.7})},
      {"Ellipsoid", of(Sphere{{}, 1}, then(scaling({2, 0.4, 1}), kTurned))},
      {"OpenCylinder", of(Cylinder{{-1.3, -1, 0}, {1, 1, 0}, 0.9, true})},
      {"Cone", of(Cone{{0, -1.5, 0}, 1.4, {0, 1.6, 0}, 0.3})},
      {"ThinCylinder", of(Cylinder{{-2, -1.5, 0}, {2, 1.7, 1}, 0.06})},
      {"Torus", of(Torus{1.4, 0.5})},
      {"Hyperboloid", of(Quadric{{1, -1, 1}, {}, {}, -0.3})},
      {"Superellipsoid", of(Superellipsoid{0.3, 0.4})},
      {"Blob", of(two_drops())},
      {"Prism", of(Prism{.height1 = -0.7,
                         .height2 = 0.7,
                         .outlines = {{{-1.5, -1}, {1.5, -1}, {0.3, 0}, {1.5, 1}, {-1.5, 1}}}})},
      {"Lathe", of(Lathe{.points = {{0.2, -1.5}, {1.4, -1}, {0.5, 0}, {1.1, 1.3}, {0, 1.5}}})},
      {"SurfaceOfRevolution",
       of(Sor{
           .points = {{0.2, -1.8}, {0.5, -1.5}, {1.2, -0.3}, {0.4, 0.8}, {0.7, 1.5}, {0.9, 2}}})},
      {"SphereSweep",
       of(SphereSweep{
           .spheres = {{{-1.7, -1, 0}, 0.5}, {{0, 1.3, 0}, 0.3}, {{1.6, -0.8, 0.4}, 0.7}}})},
      {"Ovus", of(Ovus{1.1, 0.6})},
      {"HeightField", of(hills(), then(translation({-0.5, 0, -0.5}), scaling({5, 3, 5})))},
      {"BoxWithoutSphere",
       of_csg(CsgOperation::kDifference,
              {object_of(Box{{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}}), object_of(Sphere{{}, 1.5})})},
      {"RodsIntersected", of_csg(CsgOperation::kIntersection, {object_of(rod), object_of(post)})},
      {"RodsMerged", of_csg(CsgOperation::kMerge, {object_of(rod), object_of(post)})},
      {"MeshWithoutBox",
       of_csg(CsgOperation::kDifference,
              {object_of(octahedron(true)), placed(Box{{-1, -1, -1}, {1, 1, 1}}, {1, 0.5, -1})})},
      {"FloorWithoutRod", of_csg(CsgOperation::kDifference,
                                 {object_of(Plane{{0, 1, 0}, -0.8}), placed(post, {0.5, 0, 0.5})})},
      {"ClippedSphere", clipped_sphere()},
      {"NestedUnions", nested_unions()},
      {"InsideASphere", of(Sphere{{1, 2, -3}, 30})},
      {"InsideABox", of(Box{{-3, -2, -9}, {4, 5, 12}}, rotation({0, 10, 4}))},
      {"Room", room()},
      {"Crowd", crowd()},
      {"OrthographicTorus", orthographic(on_a_floor(of(Torus{1.4, 0.5})))},
      {"OrthographicBox", orthographic(of(Box{{-1, -1, -1}, {1, 1, 1}}))},
      {"SphereOnAFloor", on_a_floor(of(Sphere{{}, 1.5}))},
  };
}

}  // namespace dioptre
