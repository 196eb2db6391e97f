// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/render_image.h"

#include <algorithm>
#include <mutex>
#include <type_traits>

#include "dioptre/core/parallel.h"
#include "dioptre/integrators/eye_rays.h"
#include "dioptre/integrators/pixel_layers.h"
#include "dioptre/integrators/term_sample.h"
#include "dioptre/integrators/thread_time.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kTile = 16;

/// What is to be believed of the times in a tile: where queries would have taken far longer than
/// all of the tile, the thread was put aside within one that was timed.
QueryTimes credible(const QueryTimes& times, double busy_seconds) {
  return times.seconds() <= 4 * busy_seconds ? times : QueryTimes{};
}

/// One render: every pixel is a function of the scene and the options alone; threads only decide
/// when it is computed. A Sample is a FilmSample or a TermSample.
template <class Sample>
class Render {
 public:
  Render(const RenderScene& scene, const RayIntegrator& integrator, const EyeRays& eye,
         const RenderOptions& options, const RenderContext& context, RenderResult& result)
      : scene_(scene),
        integrator_(integrator),
        eye_(eye),
        options_(options),
        context_(context),
        region_(region_within(options.region, options.width, options.height)),
        layers_(options.layers, std::size_t{options.width} * options.height),
        result_(result) {
    result.image = Image(options.width, options.height);
    result.image.alpha.assign(result.image.pixels.size(), 0.0f);
  }

  void run() {
    const bool two_passes = options_.antialias.method == 1;
    const double share = two_passes ? 0.5 : 1;
    pass(0, share, [&](std::uint32_t x, std::uint32_t y, PixelLog& log) {
      store(x, y, first_value(x, y, log));
    });
    if (two_passes && !stopped()) refine();
    result_.layers = layers_.take();
    result_.cancelled = stopped();
  }

 private:
  static constexpr bool kWithTerms = std::is_same_v<Sample, TermSample>;

  std::optional<Sample> sample(double x, double y, Vec2 lens, std::uint32_t number,
                               PixelLog& log) const {
    const auto ray = eye_.ray(x, y, lens, number);
    if (!ray) return std::nullopt;
    Sample sample{};
    const Radiance radiance = integrator_.radiance(*ray, log.rays);
    sample.color = radiance.color, sample.alpha = radiance.alpha;
    if constexpr (kWithTerms) sample.terms = log.watch.take_terms();
    return sample;
  }

  /// The value at a place of the image through one point of the lens.
  Sample value_through(double x, double y, Vec2 lens, PixelLog& log) const {
    return eye_.mean([&](std::uint32_t number) { return sample(x, y, lens, number, log); });
  }

  /// The value at a place of the image: one ray, or what the whole lens sees around it.
  Sample value(double x, double y, double spread, PixelLog& log) const {
    if (!eye_.lens()) return value_through(x, y, {0.5, 0.5}, log);
    return eye_.lens()->mean(x, y, spread, [&](double px, double py, Vec2 lens) {
      return value_through(px, py, lens, log);
    });
  }

  Sample first_value(std::uint32_t x, std::uint32_t y, PixelLog& log) const {
    const auto at = [&](double px, double py) { return value(px, py, 0, log); };
    if (options_.antialias.method == 2) return CornerRefiner(options_.antialias, at).pixel(x, y);
    return value(x + 0.5, y + 0.5, 1, log);
  }

  /// The second pass of antialiasing: where neighbours differ. It reads the first pass only.
  void refine() {
    const auto marked = pixels_to_refine(result_.image, options_.antialias, region_.first_column,
                                         region_.first_row, region_.end_column, region_.end_row);
    pass(0.5, 0.5, [&](std::uint32_t x, std::uint32_t y, PixelLog& log) {
      if (!marked[index_of(x, y)]) return;
      const double spread = 1.0 / std::max(1u, options_.antialias.depth);
      const auto at = [&](double px, double py) { return value(px, py, spread, log); };
      store(x, y, refine_on_grid(x, y, stored(x, y), options_.antialias, at));
    });
  }

  std::size_t index_of(std::uint32_t x, std::uint32_t y) const {
    return std::size_t{y} * options_.width + x;
  }

  void store(std::uint32_t x, std::uint32_t y, const Sample& value) {
    const std::size_t index = index_of(x, y);
    result_.image.pixels[index] = value.color;
    result_.image.alpha[index] = value.alpha;
    if constexpr (kWithTerms) layers_.set_terms(index, value.terms);
  }

  Sample stored(std::uint32_t x, std::uint32_t y) const {
    const std::size_t index = index_of(x, y);
    Sample sample{};
    sample.color = result_.image.pixels[index];
    sample.alpha = result_.image.alpha[index];
    if constexpr (kWithTerms) sample.terms = layers_.terms(index);
    return sample;
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
      const std::int64_t begin = thread_nanoseconds();
      PixelLog log(scene_, options_.layers);
      const std::uint32_t x0 = region_.first_column + tile % across * kTile;
      const std::uint32_t y0 = region_.first_row + tile / across * kTile;
      for (std::uint32_t y = y0; y < std::min(y0 + kTile, region_.end_row); ++y) {
        for (std::uint32_t x = x0; x < std::min(x0 + kTile, region_.end_column); ++x) {
          layers_.measure(index_of(x, y), log, [&] { pixel(x, y, log); });
        }
        if (stopped()) break;
      }
      const double busy = 1e-9 * static_cast<double>(thread_nanoseconds() - begin);
      const std::lock_guard lock(mutex_);
      result_.rays += log.rays.counts;
      const QueryTimes times = credible(log.rays.clock.times(), busy);
      result_.queries += times;
      if (times.queries > 0) result_.busy_seconds += busy;
      ++finished;
      if (context_.progress) {
        context_.progress({done_before + share * finished / tiles, result_.rays});
      }
    });
  }

  bool stopped() const {
    return context_.cancel && context_.cancel->load(std::memory_order_relaxed);
  }

  const RenderScene& scene_;
  const RayIntegrator& integrator_;
  const EyeRays& eye_;
  const RenderOptions& options_;
  const RenderContext& context_;
  PixelRegion region_;
  PixelLayers layers_;
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
  if (options.layers.has_any(LayerSet::terms())) {
    Render<TermSample>(scene, **integrator, *eye, options, context, result).run();
  } else {
    Render<FilmSample>(scene, **integrator, *eye, options, context, result).run();
  }
  return result;
}

Result<RenderResult> render_image(const Scene& scene, const CompileOptions& compile_options,
                                  const RenderOptions& options, const RenderContext& context) {
  auto compiled = RenderScene::compile(scene, compile_options);
  if (!compiled) return tl::unexpected(compiled.error());
  return render_image(**compiled, options, context);
}

}  // namespace dioptre
