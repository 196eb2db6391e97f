// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "commands.h"
#include "dioptre/render/scene_queries.h"
#include "dioptre/scene/json.h"
#include "frames.h"

namespace dioptre::app {
namespace {

/// Where POV-Ray's own include files are installed; searched last.
constexpr const char* kIncludeFolders[] = {"/usr/local/share/povray-3.7/include",
                                           "/usr/share/povray-3.7/include"};

LoadOptions load_options(const AppSettings& s, std::int64_t frame) {
  LoadOptions options;
  options.library_paths = s.library_paths;
  for (const char* folder : kIncludeFolders) {
    std::error_code ignored;
    if (std::filesystem::is_directory(folder, ignored)) options.library_paths.push_back(folder);
  }
  options.image_width = s.width;
  options.image_height = s.height;
  options.clock = frame_clock(s, frame);
  options.clock_delta = clock_delta(s);
  options.clock_on = is_animation(s);
  options.initial_clock = s.initial_clock;
  options.final_clock = s.final_clock;
  options.initial_frame = s.initial_frame;
  options.final_frame = is_animation(s) ? s.final_frame : s.initial_frame;
  options.frame_number = static_cast<std::int32_t>(frame);
  for (const auto& [name, value] : s.declares) options.declares[name] = value;
  options.budgets.steps = s.max_steps;
  options.budgets.objects = s.max_objects;
  options.budgets.nesting = s.max_nesting;
  options.budgets.seconds = s.max_seconds;
  return options;
}

Result<LoadedScene> load_json(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail("cannot read " + path);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  Result<Scene> scene = read_json(text);
  if (!scene) return fail(path + ": " + scene.error().message);
  return LoadedScene{std::move(*scene), {}};
}

}  // namespace

Result<LoadedScene> load(const AppSettings& settings, std::int64_t frame) {
  if (to_lower(settings.input).ends_with(".json")) return load_json(settings.input);
  if (!settings.include_header.empty()) {
    return fail("Include_Header is not supported; write #include into the scene");
  }
  Diagnostics diagnostics([&](const Diagnostic& message) {
    if (message.severity != Severity::kError && !settings.warnings) return;
    std::fputs(to_text(message).c_str(), stderr);
  });
  const auto queries = make_scene_queries();
  Result<LoadedScene> scene =
      load_pov(settings.input, load_options(settings, frame), *queries, diagnostics);
  if (scene && diagnostics.has_errors()) return fail("the scene has errors");
  return scene;
}

int report_error(const std::string& message) {
  std::fprintf(stderr, "dioptre: error: %s\n", message.c_str());
  return kFailure;
}

}  // namespace dioptre::app
