// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

#include "commands.h"
#include "dioptre/raster/render_picture.h"
#include "frames.h"
#include "progress.h"
#include "render_failure.h"
#include "render_options.h"
#include "save.h"

namespace dioptre::app {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

/// The first signal asks for an orderly end, the second ends at once.
void on_signal(int) {
  if (stop_asked.exchange(true)) ::_exit(kStopped);
}

int report_stop() {
  std::fputs("dioptre: stopped; nothing was written\n", stderr);
  return kStopped;
}

int render_frame(const AppSettings& settings, std::int64_t frame, ProgressLine& line) {
  const std::optional<LoadedScene> loaded = load(settings, frame, &stop_asked);
  if (stop_asked) return report_stop();
  if (!loaded) return kFailure;
  line.start();
  RenderContext context;
  context.cancel = &stop_asked;
  context.progress = [&](const RenderProgress& p) { line.update(p.done, p.rays.total()); };
  auto result =
      render_picture(loaded->scene, compile_options(settings), render_options(settings), context);
  if (!result) return report_render_failure(*loaded, result.error().message);
  if (result->cancelled) return report_stop();
  line.finish(*result);
  if (!settings.output_to_file) return kSuccess;
  const auto saved = save_render(settings, output_path(settings, frame), std::move(*result),
                                 loaded->scene.settings);
  return saved ? kSuccess : report_error(saved.error().message);
}

}  // namespace

int render_command(const AppSettings& settings) {
  if (const auto fits = check_size(settings); !fits) return report_error(fits.error().message);
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGPIPE, SIG_IGN);
  const FrameRange frames = frame_range(settings);
  if (settings.output_to_file) {
    const auto writable = check_output(settings, output_path(settings, frames.first));
    if (!writable) return report_error(writable.error().message);
  }
  const std::int64_t count = (frames.last - frames.first) / frames.step + 1;
  ProgressLine line(settings.verbose ? settings.progress : "none", count);
  for (std::int64_t frame = frames.first; frame <= frames.last; frame += frames.step) {
    const int code = render_frame(settings, frame, line);
    if (code != kSuccess) return code;
  }
  return kSuccess;
}

}  // namespace dioptre::app
