// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/load_scene.h"

#include <pthread.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <optional>

#include "dioptre/io/file_access.h"
#include "dioptre/io/pov/interpreter.h"

namespace dioptre {
namespace {

constexpr std::size_t kStackBytes = std::size_t{64} << 20;
constexpr std::size_t kStackBytesPerLevel = std::size_t{32} << 10;
constexpr std::uint64_t kMostSourceBytes = 256u << 20;

/// Runs `work` on a thread of its own, whose stack is large enough for the deepest nesting that the
/// budgets allow. False if there is no such thread to be had.
bool run_with_stack_for(std::uint32_t levels, std::function<void()> work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStackBytes + levels * kStackBytesPerLevel);
  const auto start = [](void* argument) -> void* {
    (*static_cast<std::function<void()>*>(argument))();
    return nullptr;
  };
  pthread_t thread;
  const bool started = pthread_create(&thread, &attributes, start, &work) == 0;
  pthread_attr_destroy(&attributes);
  if (started) pthread_join(thread, nullptr);
  return started;
}

FileAccess::Options access_options(const std::string& name, const LoadOptions& options) {
  FileAccess::Options access;
  access.scene_folder = std::filesystem::path(name).parent_path().string();
  access.search_folders = options.search_folders;
  access.readable_paths = options.readable_paths;
  access.writable_paths = options.writable_paths;
  if (name != "-") access.scene_file = name;
  return access;
}

void report_error(Diagnostics& diagnostics, std::string message) {
  Diagnostic d;
  d.message = std::move(message);
  diagnostics.report(std::move(d));
}

/// Reads the text; nothing if an error was reported.
std::optional<LoadedScene> read_text(const std::string& name, std::string text,
                                     const LoadOptions& options, SceneQueries& queries,
                                     Diagnostics& diagnostics) {
  const bool is_file = name != "-";
  std::unique_ptr<pov::Interpreter> interpreter;
  const auto out_of_memory = [&] {
    if (interpreter) return diagnostics.report(interpreter->out_of_memory());
    report_error(diagnostics, "there is not enough memory to begin");
  };
  try {
    const FileAccess access(access_options(name, options));
    interpreter = std::make_unique<pov::Interpreter>(options, access, queries, diagnostics);
    interpreter->run(is_file ? name : "standard input", std::move(text), is_file ? name : "");
    return interpreter->take_result();
  } catch (pov::Failure& failure) {
    diagnostics.report(std::move(failure.diagnostic));
  } catch (const std::bad_alloc&) {
    out_of_memory();
  } catch (const std::length_error&) {
    out_of_memory();
  } catch (const std::filesystem::filesystem_error& error) {
    report_error(diagnostics, std::string("a file cannot be reached: ") + error.what());
  }
  return std::nullopt;
}

/// All of the standard input.
Result<std::string> read_input(std::uint64_t most_bytes) {
  std::string text;
  char block[1 << 16];
  while (const std::size_t size = std::fread(block, 1, sizeof block, stdin)) {
    if (text.size() + size > most_bytes) {
      return fail("the standard input is larger than " + std::to_string(most_bytes) + " bytes");
    }
    text.append(block, size);
  }
  return text;
}

Result<std::string> read_scene_file(const std::string& path) {
  if (path == "-") return read_input(kMostSourceBytes);
  return FileAccess({}).read(path, kMostSourceBytes);
}

/// A line of a file, from 1; empty if it cannot be read.
std::string line_of(const std::string& path, std::uint32_t number) {
  const Result<std::string> text = FileAccess({}).read(path, kMostSourceBytes);
  if (!text) return {};
  std::string_view rest = *text;
  for (std::uint32_t line = 1; line < number && !rest.empty(); ++line) {
    const std::size_t end = rest.find_first_of("\r\n");
    const bool both = end != rest.npos && rest.substr(end).starts_with("\r\n");
    rest.remove_prefix(end == rest.npos ? rest.size() : end + (both ? 2 : 1));
  }
  return std::string(rest.substr(0, rest.find_first_of("\r\n")));
}

}  // namespace

Diagnostic about_object(const LoadedScene& loaded, ObjectId object, std::string message) {
  Diagnostic d;
  d.message = std::move(message);
  const auto& places = loaded.source_map.objects;
  if (object.index >= places.size() || places[object.index].line == 0) return d;
  const SourcePosition at = places[object.index];
  if (at.file >= loaded.source_map.files.size()) return d;
  d.file = loaded.source_map.files[at.file];
  d.line = at.line;
  d.column = at.column;
  if (at.file < loaded.paths.size()) d.source_line = line_of(loaded.paths[at.file], at.line);
  return d;
}

Result<LoadedScene> load_pov_text(const std::string& name, std::string text,
                                  const LoadOptions& options, SceneQueries& queries,
                                  Diagnostics& diagnostics) {
  std::optional<LoadedScene> scene;
  const bool ran = run_with_stack_for(options.budgets.nesting, [&] {
    scene = read_text(name, std::move(text), options, queries, diagnostics);
  });
  if (!ran) {
    report_error(diagnostics, "there is not enough memory for " +
                                  std::to_string(options.budgets.nesting) + " levels of nesting");
    return fail("no thread with so large a stack can be started");
  }
  if (!scene) return fail("'" + name + "' could not be read");
  return std::move(*scene);
}

Result<LoadedScene> load_pov(const std::string& path, const LoadOptions& options,
                             SceneQueries& queries, Diagnostics& diagnostics) {
  Result<std::string> text = read_scene_file(path);
  if (!text) {
    report_error(diagnostics, text.error().message);
    return tl::unexpected<Error>(text.error());
  }
  return load_pov_text(path, std::move(*text), options, queries, diagnostics);
}

}  // namespace dioptre
