// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "commands.h"
#include "dioptre/io/file_access.h"
#include "dioptre/render/scene_queries.h"
#include "dioptre/scene/json.h"
#include "frames.h"

namespace dioptre::app {
namespace {

/// Where POV-Ray's own include files are installed; searched last.
constexpr const char* kIncludeFolders[] = {"/usr/local/share/povray-3.7/include",
                                           "/usr/share/povray-3.7/include"};

/// Half of the machine's memory, and no more than any scene should need.
std::uint64_t usual_scene_bytes() {
  constexpr std::uint64_t kMost = std::uint64_t{8} << 30;
  const auto pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || size <= 0) return kMost;
  return std::min(kMost, static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size) / 2);
}

constexpr std::uint64_t kMostJsonBytes = std::uint64_t{1} << 32;

LoadOptions load_options(const AppSettings& s, std::int64_t frame) {
  LoadOptions options;
  options.search_folders = s.search_folders;
  for (const char* folder : kIncludeFolders) {
    std::error_code ignored;
    if (std::filesystem::is_directory(folder, ignored)) options.search_folders.push_back(folder);
  }
  options.include_header = s.include_header;
  options.version = s.version;
  options.image_width = s.width;
  options.image_height = s.height;
  options.clock = frame_clock(s, frame);
  options.clock_delta = clock_delta(s);
  options.clock_on = is_animation(s) || s.clock_given;  // (measured)
  options.initial_clock = is_animation(s) ? s.initial_clock : 0;
  options.final_clock = is_animation(s) ? s.final_clock : 0;
  options.initial_frame = is_animation(s) ? s.initial_frame : 0;
  // Measured: a cyclic animation counts the frame that would be the first again.
  const std::int64_t last = std::int64_t{final_frame(s)} + (s.cyclic ? 1 : 0);
  options.final_frame =
      is_animation(s) ? static_cast<std::int32_t>(std::min<std::int64_t>(last, INT32_MAX)) : 0;
  options.frame_number = static_cast<std::int32_t>(frame);
  for (const auto& [name, value] : s.declares) options.declares[name] = value;
  options.strict = s.strict;
  options.budgets.steps = s.max_steps;
  options.budgets.objects = s.max_objects;
  options.budgets.nesting = s.max_nesting;
  options.budgets.string_bytes = s.max_string_bytes;
  options.budgets.array_elements = s.max_array_elements;
  options.budgets.written_bytes = s.max_written_bytes;
  options.budgets.memory_bytes = s.max_scene_bytes > 0 ? s.max_scene_bytes : usual_scene_bytes();
  options.budgets.seconds = s.max_read_seconds;
  return options;
}

std::optional<LoadedScene> load_json(const std::string& path) {
  const Result<std::string> text = FileAccess({}).read(path, kMostJsonBytes);
  if (!text) return report_error(text.error().message), std::nullopt;
  Result<Scene> scene = read_json(*text);
  if (!scene) return report_error(path + ": " + scene.error().message), std::nullopt;
  return LoadedScene{std::move(*scene), {}, {}};
}

/// What a terminal could take for a command becomes a question mark: texts come from strangers.
std::string printable(std::string text) {
  for (char& c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    if (control && c != '\n' && c != '\t') c = '?';
  }
  return text;
}

bool is_wanted(const AppSettings& settings, Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return settings.debug_messages;
    case Severity::kWarning:
      return settings.warnings;
    case Severity::kError:
      return true;
  }
  return true;
}

std::optional<LoadedScene> read(const AppSettings& settings, std::int64_t frame,
                                const std::atomic<bool>* cancel) {
  if (to_lower(settings.input).ends_with(".json")) return load_json(settings.input);
  Diagnostics diagnostics([&](const Diagnostic& message) {
    if (is_wanted(settings, message.severity)) print_message(message);
  });
  const auto queries = make_scene_queries();
  LoadOptions options = load_options(settings, frame);
  options.cancel = cancel;
  Result<LoadedScene> scene = load_pov(settings.input, options, *queries, diagnostics);
  if (scene && !diagnostics.has_errors()) return std::move(*scene);
  if (!diagnostics.has_errors()) report_error(scene.error().message);
  return std::nullopt;
}

/// Says how points are held against the polygons of a scene.
void set_polygon_test(Scene& scene, PolygonTest test) {
  for (Object& object : scene.objects) {
    auto* const shape = std::get_if<ShapeData>(&object.geometry);
    if (auto* const polygon = shape ? std::get_if<Polygon>(shape) : nullptr) polygon->test = test;
  }
}

}  // namespace

std::optional<LoadedScene> load(const AppSettings& settings, std::int64_t frame,
                                const std::atomic<bool>* cancel) {
  std::optional<LoadedScene> loaded = read(settings, frame, cancel);
  if (loaded && settings.polygon_test) set_polygon_test(loaded->scene, *settings.polygon_test);
  return loaded;
}

void print_message(const Diagnostic& message) {
  const bool is_note = message.severity == Severity::kNote;  // what the scene itself prints
  const std::string name = message.file.empty() && !is_note ? "dioptre: " : "";
  const std::string text = name + printable(is_note ? message.message : to_text(message));
  std::fwrite(text.data(), 1, text.size(), stderr);
}

int report_error(const std::string& message) {
  Diagnostic error;
  error.message = message;
  print_message(error);
  return kFailure;
}

}  // namespace dioptre::app
