// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "dioptre/core/diagnostics.h"
#include "dioptre/core/result.h"
#include "dioptre/scene/queries.h"
#include "dioptre/scene/scene.h"
#include "dioptre/scene/source_map.h"

namespace dioptre {

/// Limits that keep any input from running away; each can be raised by an option of its name.
struct LoadBudgets {
  std::uint64_t steps = 4'000'000'000;  ///< tokens run, loops and macros counted every time
  std::uint64_t objects = 50'000'000;
  std::uint32_t nesting = 4000;              ///< of braces, parentheses, macros and includes
  std::uint64_t string_bytes = 64u << 20;    ///< of one string
  std::uint64_t array_elements = 64u << 20;  ///< of one array
  std::uint64_t written_bytes = 1u << 30;    ///< by #write, and as messages
  /// By which the memory of the process may grow while a scene is read.
  std::uint64_t memory_bytes = std::uint64_t{8} << 30;
  double seconds = 3600;  ///< 0: no limit
};

/// What the surroundings give to a scene.
struct LoadOptions {
  std::vector<std::string> search_folders;  ///< searched after the scene's own folder
  std::string include_header;              ///< a file that is read before the scene; empty: none
  double version = 0;  ///< of the language, until the scene says another; 0: it must say
  std::uint32_t image_width = 320, image_height = 240;
  double clock = 0, clock_delta = 0;
  bool clock_on = false;
  double initial_clock = 0, final_clock = 1;
  std::int32_t initial_frame = 1, final_frame = 1, frame_number = 0;
  std::map<std::string, std::variant<double, std::string>> declares;  ///< Declare=NAME=VALUE
  std::vector<std::string> readable_paths,
      writable_paths;  ///< beyond the scene's and library folders
  bool strict = false;  ///< what POV-Ray 3.7 refuses is an error, even if its meaning is plain
  LoadBudgets budgets;
  const std::atomic<bool>* cancel = nullptr;  ///< set to true: the reading ends with an error
};

struct LoadedScene {
  Scene scene;
  SourceMap source_map;
  std::vector<std::string> paths;  ///< of the source map's files; empty for one that is no file
};

/// A message about an object of a scene: with the place where it was written and its line, as far
/// as they are known.
Diagnostic about_object(const LoadedScene& loaded, ObjectId object, std::string message);

/// Reads a scene in POV-Ray's scene description language. `path` "-" is the standard input. All
/// messages go to `diagnostics`; the result is an Error only if there is no scene.
Result<LoadedScene> load_pov(const std::string& path, const LoadOptions& options,
                             SceneQueries& queries, Diagnostics& diagnostics);

/// As load_pov, but of a text: `name` is shown in messages, and its folder is the scene's.
Result<LoadedScene> load_pov_text(const std::string& name, std::string text,
                                  const LoadOptions& options, SceneQueries& queries,
                                  Diagnostics& diagnostics);

}  // namespace dioptre
