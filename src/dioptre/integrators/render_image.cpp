// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/render_image.h"

#include <algorithm>
#include <mutex>

#include "dioptre/core/parallel.h"
#include "dioptre/film/camera_rays.h"
#include "dioptre/film/lens_samples.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kTile = 16;

PixelRegion cut(PixelRegion region, std::uint32_t width, std::uint32_t height) {
  region.end_column = std::min(region.end_column, width);
  region.end_row = std::min(region.end_row, height);
  const bool empty = region.first_column >= region.end_column || region.first_row >= region.end_row;
  return empty ? PixelRegion{0, 0, width, height} : region;
}

/// One render: every pixel is a function of the scene and the options alone; threads only decide
/// when it is computed.
class Render {
 public:
  Render(const RayIntegrator& integrator, const CameraRays& camera, const RenderScene& scene,
         const RenderOptions& options, const RenderContext& context, RenderResult& result)
      : integrator_(integrator),
        camera_(camera),
        scene_(scene),
        lens_(scene.scene().camera),
        options_(options),
        context_(context),
        region_(cut(options.region, options.width, options.height)),
        result_(result) {
    result.image = Image(options.width, options.height);
    result.image.alpha.assign(result.image.pixels.size(), 0.0f);
  }

  void run() {
    const bool two_passes = options_.antialias.method == 1;
    const double share = two_passes ? 0.5 : 1;
    pass(0, share, [&](std::uint32_t x, std::uint32_t y, RayCounts& counts) {
      store(x, y, first_value(x, y, counts));
    });
    if (two_passes && !stopped()) refine();
    result_.cancelled = stopped();
  }

 private:
  FilmSample sample(double x, double y, Vec2 lens, RayCounts& counts) const {
    auto ray = camera_.ray(x, y, options_.width, options_.height, lens);
    if (!ray) return {{}, 0};
    if (const NormalId bumps = scene_.scene().camera.normal) {
      ray->direction = scene_.textures().perturb(bumps, place_on_image(x, y), ray->direction);
    }
    const Radiance radiance = integrator_.radiance(*ray, counts);
    return {radiance.color, radiance.alpha};
  }

  /// Where the bumps of the camera are looked up: heights and widths from the centre of the image,
  /// x to the right and y upwards (measured).
  Vec3 place_on_image(double x, double y) const {
    return {x / options_.width - 0.5, 0.5 - y / options_.height, 0};
  }

  /// The value at a place of the image: one ray, or what the whole lens sees around it.
  FilmSample value(double x, double y, double spread, RayCounts& counts) const {
    if (!camera_.has_lens()) return sample(x, y, {0.5, 0.5}, counts);
    return lens_.mean(x, y, spread, [&](double px, double py, Vec2 lens) {
      return sample(px, py, lens, counts);
    });
  }

  FilmSample first_value(std::uint32_t x, std::uint32_t y, RayCounts& counts) const {
    const auto at = [&](double px, double py) { return value(px, py, 0, counts); };
    if (options_.antialias.method == 2) return CornerRefiner(options_.antialias, at).pixel(x, y);
    return value(x + 0.5, y + 0.5, 1, counts);
  }

  /// The second pass of antialiasing: where neighbours differ. It reads the first pass only.
  void refine() {
    const auto marked = pixels_to_refine(result_.image, options_.antialias, region_.first_column,
                                         region_.first_row, region_.end_column, region_.end_row);
    pass(0.5, 0.5, [&](std::uint32_t x, std::uint32_t y, RayCounts& counts) {
      const std::size_t index = std::size_t{y} * options_.width + x;
      if (!marked[index]) return;
      const FilmSample centre{result_.image.pixels[index], result_.image.alpha[index]};
      const double spread = 1.0 / std::max(1u, options_.antialias.depth);
      const auto at = [&](double px, double py) { return value(px, py, spread, counts); };
      store(x, y, refine_on_grid(x, y, centre, options_.antialias, at));
    });
  }

  void store(std::uint32_t x, std::uint32_t y, FilmSample value) {
    const std::size_t index = std::size_t{y} * options_.width + x;
    result_.image.pixels[index] = value.color;
    result_.image.alpha[index] = value.alpha;
  }

  /// Calls pixel(x, y, counts) for every pixel of the region, tile by tile.
  template <class Pixel>
  void pass(double done_before, double share, Pixel pixel) {
    const std::uint32_t columns = region_.end_column - region_.first_column;
    const std::uint32_t rows = region_.end_row - region_.first_row;
    const std::uint32_t across = (columns + kTile - 1) / kTile;
    const std::uint32_t tiles = across * ((rows + kTile - 1) / kTile);
    std::uint32_t finished = 0;
    parallel_for(tiles, options_.threads, context_.cancel, [&](std::uint32_t tile) {
      RayCounts counts;
      const std::uint32_t x0 = region_.first_column + tile % across * kTile;
      const std::uint32_t y0 = region_.first_row + tile / across * kTile;
      for (std::uint32_t y = y0; y < std::min(y0 + kTile, region_.end_row); ++y) {
        for (std::uint32_t x = x0; x < std::min(x0 + kTile, region_.end_column); ++x) {
          pixel(x, y, counts);
        }
        if (stopped()) break;
      }
      const std::lock_guard lock(mutex_);
      result_.rays += counts;
      ++finished;
      if (context_.progress) {
        context_.progress({done_before + share * finished / tiles, result_.rays});
      }
    });
  }

  bool stopped() const {
    return context_.cancel && context_.cancel->load(std::memory_order_relaxed);
  }

  const RayIntegrator& integrator_;
  const CameraRays& camera_;
  const RenderScene& scene_;
  LensSamples lens_;
  const RenderOptions& options_;
  const RenderContext& context_;
  PixelRegion region_;
  RenderResult& result_;
  std::mutex mutex_;
};

}  // namespace

Result<RenderResult> render_image(const Scene& scene, const RenderOptions& options,
                                  const RenderContext& context) {
  auto camera = CameraRays::prepare(scene.camera);
  if (!camera) return tl::unexpected(camera.error());
  auto compiled = RenderScene::compile(scene, {.accelerator = options.accelerator});
  if (!compiled) return tl::unexpected(compiled.error());
  auto integrator = make_integrator(options.integrator, **compiled, options.integrator_options);
  if (!integrator) return tl::unexpected(integrator.error());
  RenderResult result;
  Render(**integrator, *camera, **compiled, options, context, result).run();
  return result;
}

}  // namespace dioptre
