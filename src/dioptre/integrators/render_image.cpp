// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/render_image.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "dioptre/core/parallel.h"
#include "dioptre/integrators/eye_rays.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kTile = 16;

/// One render: every pixel is a function of the scene and the options alone; threads only decide
/// when it is computed.
class Render {
 public:
  Render(const RayIntegrator& integrator, const EyeRays& eye, const RenderOptions& options,
         const RenderContext& context, RenderResult& result)
      : integrator_(integrator),
        eye_(eye),
        options_(options),
        context_(context),
        region_(region_within(options.region, options.width, options.height)),
        result_(result) {
    result.image = Image(options.width, options.height);
    result.image.alpha.assign(result.image.pixels.size(), 0.0f);
  }

  void run() {
    const bool two_passes = options_.antialias.method == 1;
    const double share = two_passes ? 0.5 : 1;
    pass(0, share, [&](std::uint32_t x, std::uint32_t y, RayLog& log) {
      store(x, y, first_value(x, y, log));
    });
    if (two_passes && !stopped()) refine();
    result_.cancelled = stopped();
  }

 private:
  FilmSample sample(double x, double y, Vec2 lens, RayLog& log) const {
    const auto ray = eye_.ray(x, y, lens);
    if (!ray) return {{}, 0};
    const Radiance radiance = integrator_.radiance(*ray, log);
    return {radiance.color, radiance.alpha};
  }

  /// The value at a place of the image: one ray, or what the whole lens sees around it.
  FilmSample value(double x, double y, double spread, RayLog& log) const {
    if (!eye_.lens()) return sample(x, y, {0.5, 0.5}, log);
    return eye_.lens()->mean(
        x, y, spread, [&](double px, double py, Vec2 lens) { return sample(px, py, lens, log); });
  }

  FilmSample first_value(std::uint32_t x, std::uint32_t y, RayLog& log) const {
    const auto at = [&](double px, double py) { return value(px, py, 0, log); };
    if (options_.antialias.method == 2) return CornerRefiner(options_.antialias, at).pixel(x, y);
    return value(x + 0.5, y + 0.5, 1, log);
  }

  /// The second pass of antialiasing: where neighbours differ. It reads the first pass only.
  void refine() {
    const auto marked = pixels_to_refine(result_.image, options_.antialias, region_.first_column,
                                         region_.first_row, region_.end_column, region_.end_row);
    pass(0.5, 0.5, [&](std::uint32_t x, std::uint32_t y, RayLog& log) {
      const std::size_t index = std::size_t{y} * options_.width + x;
      if (!marked[index]) return;
      const FilmSample centre{result_.image.pixels[index], result_.image.alpha[index]};
      const double spread = 1.0 / std::max(1u, options_.antialias.depth);
      const auto at = [&](double px, double py) { return value(px, py, spread, log); };
      store(x, y, refine_on_grid(x, y, centre, options_.antialias, at));
    });
  }

  void store(std::uint32_t x, std::uint32_t y, FilmSample value) {
    const std::size_t index = std::size_t{y} * options_.width + x;
    result_.image.pixels[index] = value.color;
    result_.image.alpha[index] = value.alpha;
  }

  /// Calls pixel(x, y, log) for every pixel of the region, tile by tile.
  template <class Pixel>
  void pass(double done_before, double share, Pixel pixel) {
    const std::uint32_t columns = region_.end_column - region_.first_column;
    const std::uint32_t rows = region_.end_row - region_.first_row;
    const std::uint32_t across = (columns + kTile - 1) / kTile;
    const std::uint32_t tiles = across * ((rows + kTile - 1) / kTile);
    std::uint32_t finished = 0;
    parallel_for(tiles, options_.threads, context_.cancel, [&](std::uint32_t tile) {
      const auto begin = std::chrono::steady_clock::now();
      RayLog log;
      const std::uint32_t x0 = region_.first_column + tile % across * kTile;
      const std::uint32_t y0 = region_.first_row + tile / across * kTile;
      for (std::uint32_t y = y0; y < std::min(y0 + kTile, region_.end_row); ++y) {
        for (std::uint32_t x = x0; x < std::min(x0 + kTile, region_.end_column); ++x) {
          pixel(x, y, log);
        }
        if (stopped()) break;
      }
      const std::chrono::duration<double> busy = std::chrono::steady_clock::now() - begin;
      const std::lock_guard lock(mutex_);
      result_.rays += log.counts;
      result_.queries += log.clock.times();
      result_.busy_seconds += busy.count();
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
  const EyeRays& eye_;
  const RenderOptions& options_;
  const RenderContext& context_;
  PixelRegion region_;
  RenderResult& result_;
  std::mutex mutex_;
};

}  // namespace

PixelRegion region_within(PixelRegion region, std::uint32_t width, std::uint32_t height) {
  region.end_column = std::min(region.end_column, width);
  region.end_row = std::min(region.end_row, height);
  const bool empty = region.first_column >= region.end_column || region.first_row >= region.end_row;
  return empty ? PixelRegion{0, 0, width, height} : region;
}

Result<RenderResult> render_image(const RenderScene& scene, const RenderOptions& options,
                                  const RenderContext& context) {
  auto eye = EyeRays::prepare(scene, options.width, options.height);
  if (!eye) return tl::unexpected(eye.error());
  auto integrator = make_integrator(options.integrator, scene, options.integrator_options);
  if (!integrator) return tl::unexpected(integrator.error());
  RenderResult result;
  Render(**integrator, *eye, options, context, result).run();
  return result;
}

Result<RenderResult> render_image(const Scene& scene, const CompileOptions& compile_options,
                                  const RenderOptions& options, const RenderContext& context) {
  auto compiled = RenderScene::compile(scene, compile_options);
  if (!compiled) return tl::unexpected(compiled.error());
  return render_image(**compiled, options, context);
}

}  // namespace dioptre
