// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "commands.h"
#include "dioptre/compare/reports.h"
#include "dioptre/film/display.h"
#include "dioptre/io/image/write_image.h"
#include "frames.h"
#include "progress.h"
#include "render_failure.h"
#include "render_options.h"

namespace dioptre::app {
namespace {

/// The names between commas; none if all are meant.
std::vector<std::string> named_accelerators(const AppSettings& settings) {
  std::vector<std::string> names;
  if (!settings.accelerator_is_named) return names;
  const std::string& list = settings.accelerator;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t comma = std::min(list.find(',', begin), list.size());
    names.push_back(list.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return names;
}

Result<void> write_page(const AppSettings& settings, const Comparison& comparison,
                        const Settings& scene_settings) {
  const EncodedImage image = encode(comparison.image, scene_settings, DisplayOptions{});
  const auto png = image_bytes(image, ImageFormat::kPng);
  if (!png) return tl::unexpected(png.error());
  return write_file(settings.html_report, html_report(comparison, *png));
}

/// Writes the reports that are asked for, and the table where it does not mix with one of them.
Result<void> write_reports(const AppSettings& settings, const Comparison& comparison,
                           const Settings& scene_settings) {
  if (const std::string& path = settings.csv_report; !path.empty()) {
    if (auto written = write_file(path, csv_report(comparison)); !written) return written;
  }
  if (const std::string& path = settings.json_report; !path.empty()) {
    if (auto written = write_file(path, json_report(comparison)); !written) return written;
  }
  if (!settings.html_report.empty()) {
    if (auto written = write_page(settings, comparison, scene_settings); !written) return written;
  }
  for (const auto* path : {&settings.csv_report, &settings.json_report, &settings.html_report}) {
    if (*path == "-") return {};
  }
  return write_file("-", table_report(comparison));
}

}  // namespace

int compare_command(const AppSettings& settings) {
  if (const auto fits = check_size(settings); !fits) return report_error(fits.error().message);
  CompareOptions options;
  options.accelerators = named_accelerators(settings);
  options.sample = settings.compared_rays;
  if (const auto known = check_accelerators(options.accelerators); !known) {
    report_error(known.error().message);
    return kUsage;
  }
  const std::optional<LoadedScene> loaded = load(settings, frame_range(settings).first);
  if (!loaded) return kFailure;
  ProgressLine line(settings.verbose ? settings.progress : "none");
  RenderContext context;
  context.progress = [&](const RenderProgress& p) { line.update(p.done, p.rays.total()); };
  auto comparison = compare_accelerators(loaded->scene, compile_options(settings),
                                         render_options(settings), options, context);
  line.clear();
  if (!comparison) return report_render_failure(*loaded, comparison.error().message);
  comparison->title = settings.input;
  const auto written = write_reports(settings, *comparison, loaded->scene.settings);
  if (!written) return report_error(written.error().message);
  if (comparison->all_equal()) return kSuccess;
  return report_error(in_words(*comparison).front());
}

}  // namespace dioptre::app
