// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>

#include "commands.h"
#include "dioptre/integrators/render_image.h"
#include "frames.h"
#include "progress.h"
#include "render_failure.h"
#include "save.h"

namespace dioptre::app {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

/// The first signal asks for an orderly end, the second ends at once.
void on_signal(int) {
  if (stop_asked.exchange(true)) ::_exit(kStopped);
}

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
  options.integrator = s.integrator;
  options.threads = s.threads;
  return options;
}

int report_stop() {
  std::fputs("dioptre: stopped; nothing was written\n", stderr);
  return kStopped;
}

int render_frame(const AppSettings& settings, std::int64_t frame) {
  const std::optional<LoadedScene> loaded = load(settings, frame, &stop_asked);
  if (stop_asked) return report_stop();
  if (!loaded) return kFailure;
  ProgressLine line(settings.verbose ? settings.progress : "none");
  RenderContext context;
  context.cancel = &stop_asked;
  context.progress = [&](const RenderProgress& p) { line.update(p.done, p.rays.total()); };
  const auto result =
      render_image(loaded->scene, compile_options(settings), render_options(settings), context);
  if (!result) return report_render_failure(*loaded, result.error().message);
  if (result->cancelled) return report_stop();
  line.finish(result->rays.total());
  if (!settings.output_to_file) return kSuccess;
  const std::string path = output_path(settings, frame);
  const auto saved = save_image(settings, path, result->image, loaded->scene.settings);
  return saved ? kSuccess : report_error(saved.error().message);
}

Result<void> check_size(const AppSettings& s) {
  if (std::uint64_t{s.width} * s.height <= s.max_pixels) return {};
  return fail("an image of " + std::to_string(s.width) + " x " + std::to_string(s.height) +
              " has more than " + std::to_string(s.max_pixels) +
              " pixels; --max-pixels raises this limit");
}

}  // namespace

int render_command(const AppSettings& settings) {
  if (const auto fits = check_size(settings); !fits) return report_error(fits.error().message);
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGPIPE, SIG_IGN);
  const FrameRange frames = frame_range(settings);
  if (frames.first > frames.last) {
    return report_error("there is no frame to render: the first would be " +
                        std::to_string(frames.first) + ", the last " + std::to_string(frames.last));
  }
  for (std::int64_t frame = frames.first; frame <= frames.last; frame += frames.step) {
    const int code = render_frame(settings, frame);
    if (code != kSuccess) return code;
  }
  return kSuccess;
}

}  // namespace dioptre::app
