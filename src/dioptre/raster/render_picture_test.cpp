// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/render_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dioptre/raster/raster_scenes_test.h"
#include "dioptre/raster/visible_surfaces.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kWidth = 80, kHeight = 60;

using Hits = std::vector<Hit>;  ///< for each pixel; without an item where nothing is seen

Hits by_rays(const RenderScene& scene) {
  const auto eye = EyeRays::prepare(scene, kWidth, kHeight);
  Hits hits(std::size_t{kWidth} * kHeight);
  for (std::uint32_t i = 0; i < hits.size(); ++i) {
    const auto ray = eye->ray(i % kWidth + 0.5, i / kWidth + 0.5);
    scene.nearest(*ray, {0, kInfinity}, RayPurpose::kCamera, hits[i]);
  }
  return hits;
}

Hits by_faces(const RenderScene& scene) {
  Hits hits(std::size_t{kWidth} * kHeight);
  const auto surfaces = VisibleSurfaces::prepare(scene, kWidth, kHeight, {}, 1, nullptr);
  EXPECT_TRUE(surfaces) << (surfaces ? "" : surfaces.error().message);
  if (!surfaces) return hits;
  for (std::uint32_t tile = 0; tile < surfaces->tile_count(); ++tile) {
    surfaces->draw_tile(tile, [&](const PixelHit& pixel) {
      if (pixel.hit) hits[std::size_t{pixel.row} * kWidth + pixel.column] = *pixel.hit;
    });
  }
  return hits;
}

/// Whether another item, or the background, is seen within a pixel of this one.
bool at_silhouette(const Hits& hits, int column, int row) {
  const auto item = [&](int x, int y) {
    return hits[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)].item;
  };
  for (int y = std::max(row - 1, 0); y <= std::min<int>(row + 1, kHeight - 1); ++y) {
    for (int x = std::max(column - 1, 0); x <= std::min<int>(column + 1, kWidth - 1); ++x) {
      if (item(x, y) != item(column, row)) return true;
    }
  }
  return false;
}

bool agree(const Hit& a, const Hit& b) {
  if (a.item != b.item) return false;
  return !a.item || std::fabs(a.crossing.t - b.crossing.t) <= 1e-9 * std::fabs(a.crossing.t);
}

class EveryRasterScene : public testing::TestWithParam<RasterScene> {};

TEST_P(EveryRasterScene, FacesShowWhatRaysShow) {
  const auto scene = RenderScene::compile(GetParam().scene, {});
  ASSERT_TRUE(scene) << scene.error().message;
  const Hits rays = by_rays(**scene), faces = by_faces(**scene);
  std::size_t seen = 0, differ = 0;
  for (int row = 0; row < static_cast<int>(kHeight); ++row) {
    for (int column = 0; column < static_cast<int>(kWidth); ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * kWidth + column;
      seen += rays[i].item != nullptr;
      if (agree(rays[i], faces[i])) continue;
      ++differ;
      EXPECT_TRUE(at_silhouette(rays, column, row)) << column << ", " << row;
    }
  }
  EXPECT_GT(seen, 0u);
  EXPECT_LE(differ, rays.size() / 50);
  RecordProperty("differ", static_cast<int>(differ));
}

TEST_P(EveryRasterScene, ThreadsChangeNothing) {
  const auto scene = RenderScene::compile(GetParam().scene, {});
  ASSERT_TRUE(scene) << scene.error().message;
  RenderOptions options{.width = kWidth, .height = kHeight, .threads = 1};
  const auto once = render_zbuffer(**scene, options, {});
  ASSERT_TRUE(once) << once.error().message;
  for (const std::uint32_t threads : {2u, 4u}) {
    options.threads = threads;
    const auto again = render_zbuffer(**scene, options, {});
    ASSERT_TRUE(again);
    EXPECT_EQ(again->image.pixels, once->image.pixels);
    EXPECT_EQ(again->image.alpha, once->image.alpha);
  }
}

INSTANTIATE_TEST_SUITE_P(Raster, EveryRasterScene, testing::ValuesIn(raster_scenes()),
                         [](const auto& info) { return info.param.name; });

Result<RenderResult> render(const Scene& scene, const std::string& integrator,
                            RenderOptions options = {}) {
  options.width = kWidth, options.height = kHeight;
  options.integrator = integrator;
  return render_picture(scene, {}, options, {});
}

TEST(RenderPicture, FacesAndRaysAreShadedAlike) {
  for (const RasterScene& each : raster_scenes()) {
    if (each.name != "Room" && each.name != "SphereOnAFloor") continue;
    for (const bool shadows : {false, true}) {
      RenderOptions options;
      options.integrator_options.appel_shadows = shadows;
      const auto faces = render(each.scene, "zbuffer", options);
      const auto rays = render(each.scene, "appel", options);
      ASSERT_TRUE(faces && rays);
      std::size_t differ = 0;
      for (std::size_t i = 0; i < rays->image.pixels.size(); ++i) {
        differ += !(faces->image.pixels[i] == rays->image.pixels[i]);
      }
      EXPECT_LE(differ, rays->image.pixels.size() / 100) << each.name;
    }
  }
}

TEST(RenderPicture, AnUnknownIntegratorListsAllNames) {
  const auto result = render(empty_scene(), "nonsense");
  ASSERT_FALSE(result);
  for (const std::string_view name : integrator_names()) {
    EXPECT_THAT(result.error().message, testing::HasSubstr(std::string(name)));
  }
  EXPECT_THAT(result.error().message, testing::HasSubstr("zbuffer"));
}

TEST(RenderPicture, TellsWhatZBufferCannotDo) {
  RenderOptions antialias, layers;
  antialias.antialias.method = 1;
  layers.layers = LayerSet::terms();
  EXPECT_FALSE(render(empty_scene(), "zbuffer", antialias));
  EXPECT_FALSE(render(empty_scene(), "zbuffer", layers));
  for (int kind = 0; kind <= static_cast<int>(Camera::Kind::kSpherical); ++kind) {
    Scene scene = empty_scene();
    scene.camera.kind = static_cast<Camera::Kind>(kind);
    const bool flat = scene.camera.kind == Camera::Kind::kPerspective ||
                      scene.camera.kind == Camera::Kind::kOrthographic;
    EXPECT_EQ(render(scene, "zbuffer").has_value(), flat) << kind;
  }
  Scene lens = empty_scene();
  lens.camera.aperture = 0.5;
  EXPECT_FALSE(render(lens, "zbuffer"));
}

TEST(RenderPicture, AnEmptySceneIsBackground) {
  const auto result = render(empty_scene(), "zbuffer");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->image.at(3, 4), empty_scene().atmosphere.background);
  EXPECT_EQ(result->image.alpha[0], 0);
}

TEST(RenderPicture, OnlyTheRegionIsDrawn) {
  Scene scene = empty_scene();
  scene.roots.push_back(append(scene.objects, object_of(Sphere{{0, 1, 0}, 3})));
  RenderOptions options;
  options.region = {30, 20, 50, 41};
  const auto whole = render(scene, "zbuffer"), part = render(scene, "zbuffer", options);
  ASSERT_TRUE(whole && part);
  for (std::uint32_t y = 0; y < kHeight; ++y) {
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const bool inside = x >= 30 && x < 50 && y >= 20 && y < 41;
      EXPECT_EQ(part->image.at(x, y), inside ? whole->image.at(x, y) : Color{});
    }
  }
}

}  // namespace
}  // namespace dioptre
