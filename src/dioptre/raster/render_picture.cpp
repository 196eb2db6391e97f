// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/render_picture.h"

#include <algorithm>
#include <mutex>

#include "dioptre/core/parallel.h"
#include "dioptre/integrators/appel.h"
#include "dioptre/raster/visible_surfaces.h"

namespace dioptre {
namespace {

Result<void> check(const RenderOptions& options) {
  if (options.antialias.method != 0) {
    return fail("zbuffer looks at the centre of each pixel only: switch antialiasing off (-A)");
  }
  if (!options.layers.empty()) return fail("zbuffer makes no layers beside the picture");
  return {};
}

/// What a name of no integrator means.
tl::unexpected<Error> unknown_integrator(std::string_view name) {
  std::string known;
  for (const std::string_view each : integrator_names()) known += std::string(each) + ", ";
  return fail("unknown integrator '" + std::string(name) + "'; known: " + known +
              std::string(kZBuffer));
}

}  // namespace

Result<RenderResult> render_zbuffer(const RenderScene& scene, const RenderOptions& options,
                                    const RenderContext& context) {
  if (auto possible = check(options); !possible) return tl::unexpected(possible.error());
  auto surfaces = VisibleSurfaces::prepare(scene, options.width, options.height, options.region,
                                           options.threads, context.cancel);
  if (!surfaces) return tl::unexpected(surfaces.error());
  const Appel shader(scene, options.integrator_options);
  RenderResult result;
  result.image = Image(options.width, options.height);
  result.image.alpha.assign(result.image.pixels.size(), 0.0f);
  std::mutex mutex;
  std::uint32_t finished = 0;
  const std::uint32_t tiles = surfaces->tile_count();
  parallel_for(tiles, options.threads, context.cancel, [&](std::uint32_t tile) {
    RayLog log;
    surfaces->draw_tile(tile, [&](const PixelHit& pixel) {
      const std::size_t index = std::size_t{pixel.row} * options.width + pixel.column;
      result.image.pixels[index] = pixel.hit ? shader.surface(pixel.ray, *pixel.hit, log)
                                             : shader.background(pixel.ray.direction);
      result.image.alpha[index] = pixel.hit ? 1.0f : 0.0f;
    });
    const std::lock_guard lock(mutex);
    result.rays += log.counts;
    ++finished;
    if (context.progress) {
      context.progress({static_cast<double>(finished) / tiles, result.rays});
    }
  });
  result.cancelled = context.cancel && context.cancel->load(std::memory_order_relaxed);
  return result;
}

Result<RenderResult> render_picture(const Scene& scene, const CompileOptions& compile_options,
                                    const RenderOptions& options, const RenderContext& context) {
  const auto names = integrator_names();
  const bool by_faces = options.integrator == kZBuffer;
  if (!by_faces && std::find(names.begin(), names.end(), options.integrator) == names.end()) {
    return unknown_integrator(options.integrator);
  }
  auto compiled = RenderScene::compile(scene, compile_options);
  if (!compiled) return tl::unexpected(compiled.error());
  return by_faces ? render_zbuffer(**compiled, options, context)
                  : render_image(**compiled, options, context);
}

}  // namespace dioptre
