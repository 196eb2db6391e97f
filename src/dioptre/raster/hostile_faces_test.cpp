// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "dioptre/raster/raster_scenes_test.h"
#include "dioptre/raster/render_picture.h"

namespace dioptre {
namespace {

constexpr double kExtremes[] = {0, 1e-300, -1e-9, 1, 1e9, -1e150, 1e300};

/// Shapes of every kind of faces, of an extreme size or at an extreme place.
std::vector<ShapeData> extreme_shapes(double e) {
  Mesh mesh;
  mesh.data = MeshData{{{0, 0, 0}, {e, 0, 0}, {0, e, e}}, {}, {}, {{{0, 1, 2}}, {{0, 0, 1}}}};
  Polygon polygon;
  polygon.outlines = {{{-e, -1, 0}, {e, -e, 0}, {0, e, 1}, {1, 1, e}}};
  return {Sphere{{0, 0, 0}, e},
          Sphere{{e, 0, e}, 1},
          Box{{-e, -1, -e}, {1, e, 1}},
          Plane{{0, 1, e}, e},
          Cylinder{{0, 0, 0}, {0, e, 1}, 1},
          Cone{{0, 0, 0}, e, {0, 1, 0}, 1},
          Torus{e, 1},
          Torus{1, e},
          Disc{{e, 0, 0}, {0, 1, 1}, 1, e},
          Triangle{{e, 0, 0}, {0, e, 0}, {0, 0, e}},
          Quadric{{1, -1, e}, {e, 0, 0}, {}, e},
          Superellipsoid{1, e},
          Ovus{1, e},
          mesh,
          polygon};
}

RenderOptions small() { return {.width = 24, .height = 18, .integrator = "zbuffer", .threads = 1}; }

TEST(HostileFaces, ExtremeShapesAreRenderedOrRefused) {
  for (const double e : kExtremes) {
    for (const ShapeData& shape : extreme_shapes(e)) {
      Scene scene = empty_scene();
      for (const Affine& transform : {Affine{}, scaling({1, 1e-6, 1e6})}) {
        Object object = object_of(shape);
        object.transform = transform;
        scene.roots.push_back(append(scene.objects, object));
      }
      // The same in a solid, which is cut up cell by cell.
      Object clipped = object_of(shape);
      clipped.clipped_by = {append(scene.objects, object_of(Box{{-1, -1, -1}, {1, 1, 1}}))};
      scene.roots.push_back(append(scene.objects, clipped));
      const auto result = render_picture(scene, {}, small(), {});
      EXPECT_TRUE(!result || result->image.pixels.size() == 24u * 18u);
    }
  }
}

TEST(HostileFaces, ExtremeCamerasRenderOrAreRefused) {
  for (const double e : kExtremes) {
    for (const auto kind : {Camera::Kind::kPerspective, Camera::Kind::kOrthographic}) {
      for (int part = 0; part < 4; ++part) {
        Scene scene = empty_scene();
        scene.camera.kind = kind;
        if (part == 0) scene.camera.location = {e, e, -e};
        if (part == 1) scene.camera.direction = {0, 0, e};
        if (part == 2) scene.camera.right = {e, 0, 0};
        if (part == 3) scene.camera.up = {0, e, 0};
        for (const RasterScene& each : raster_scenes()) {
          if (each.name != "Torus" && each.name != "RodsMerged" && each.name != "Room") continue;
          Scene other = each.scene;
          other.camera = scene.camera;
          const auto result = render_picture(other, {}, small(), {});
          EXPECT_TRUE(result || !result.error().message.empty());
        }
      }
    }
  }
}

TEST(HostileFaces, ACancelledRenderSaysSo) {
  const std::atomic<bool> cancel{true};
  const RenderContext context{.cancel = &cancel};
  const auto result = render_picture(raster_scenes().front().scene, {}, small(), context);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->cancelled);
}

}  // namespace
}  // namespace dioptre
