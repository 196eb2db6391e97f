// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "dioptre/explain/reports.h"
#include "dioptre/io/image/write_image.h"
#include "frames.h"
#include "render_failure.h"
#include "render_options.h"

namespace dioptre::app {
namespace {

/// A tree whose contributions do not sum to its pixel is a mistake of the program.
constexpr double kLargestGap = 1e-6;

/// Writes the reports that are asked for, or the text.
Result<void> write_reports(const AppSettings& settings, const ExplainedScene& scene,
                           const RayTree& tree) {
  if (const std::string& path = settings.json_report; !path.empty()) {
    if (auto written = write_file(path, json_report(scene, tree)); !written) return written;
  }
  if (const std::string& path = settings.html_report; !path.empty()) {
    if (auto written = write_file(path, html_report(scene, tree)); !written) return written;
  }
  const bool output_is_taken = settings.json_report == "-" || settings.html_report == "-";
  return output_is_taken ? Result<void>{} : write_file("-", text_report(scene, tree));
}

}  // namespace

int explain_command(const AppSettings& settings) {
  if (!settings.pixel) {
    report_error("explain needs --pixel X,Y, counted from 0 at the top left");
    return kUsage;
  }
  const std::optional<LoadedScene> loaded = load(settings, frame_range(settings).first);
  if (!loaded) return kFailure;
  const auto compiled = RenderScene::compile(loaded->scene, compile_options(settings));
  if (!compiled) return report_render_failure(*loaded, compiled.error().message);
  ExplainOptions options;
  options.column = (*settings.pixel)[0];
  options.row = (*settings.pixel)[1];
  options.width = settings.width;
  options.height = settings.height;
  options.integrator = settings.integrator;
  options.integrator_options = render_options(settings).integrator_options;
  const auto tree = explain_pixel(**compiled, options);
  if (!tree) return report_render_failure(*loaded, tree.error().message);
  const ExplainedScene scene{**compiled, loaded->source_map, settings.input};
  if (auto written = write_reports(settings, scene, *tree); !written) {
    return report_error(written.error().message);
  }
  if (tree->gap() <= kLargestGap) return kSuccess;
  return report_error("the contributions do not sum to the pixel");
}

}  // namespace dioptre::app
