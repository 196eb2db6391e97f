// SPDX-License-Identifier: Apache-2.0
#include "render_options.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dioptre::app {
namespace {

/// A bound of the region in pixels: a share of the size if under 1.
std::uint32_t pixels(double bound, std::uint32_t size) {
  const double value = bound < 1 ? std::floor(bound * size + 0.5) : std::floor(bound);
  return static_cast<std::uint32_t>(std::min(value, static_cast<double>(size)));
}

/// Rows and columns count from 1 for the user, ends included.
PixelRegion region(const AppSettings& s) {
  const auto first = [](double bound, std::uint32_t size) {
    if (bound < 1) return pixels(bound, size);
    return pixels(bound, size) - 1;
  };
  const auto end = [](double bound, std::uint32_t size) {
    return bound == 0 ? size : pixels(bound, size);
  };
  return {first(s.start_column, s.width), first(s.start_row, s.height), end(s.end_column, s.width),
          end(s.end_row, s.height)};
}

}  // namespace

CompileOptions compile_options(const AppSettings& s) { return {.accelerator = s.accelerator}; }

RenderOptions render_options(const AppSettings& s) {
  RenderOptions options;
  options.width = s.width;
  options.height = s.height;
  options.region = region(s);
  options.antialias.method = s.antialias ? s.sampling_method : 0;
  options.antialias.threshold = s.antialias_threshold;
  options.antialias.depth = s.antialias_depth;
  options.antialias.gamma = s.antialias_gamma;
  options.antialias.jitter = s.jitter ? s.jitter_amount : 0;
  options.integrator_options.quality = s.quality;
  options.integrator_options.penumbra = {s.penumbra, s.light_samples};
  options.integrator_options.appel_shadows = s.shadows;
  options.integrator_options.attenuation = {s.reflected_attenuation, s.transmitted_attenuation};
  options.integrator = s.integrator;
  options.layers = s.layers | s.heat_maps | (s.term_images ? LayerSet::terms() : LayerSet());
  options.threads = s.threads;
  return options;
}

Result<void> check_size(const AppSettings& s) {
  if (std::uint64_t{s.width} * s.height <= s.max_pixels) return {};
  return fail("an image of " + std::to_string(s.width) + " x " + std::to_string(s.height) +
              " has more than " + std::to_string(s.max_pixels) +
              " pixels; --max-pixels raises this limit");
}

}  // namespace dioptre::app
