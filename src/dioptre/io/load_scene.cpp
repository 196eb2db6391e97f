// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/load_scene.h"

#include <pthread.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <memory>
#include <new>
#include <optional>

#include "dioptre/io/file_access.h"
#include "dioptre/io/pov/interpreter.h"

namespace dioptre {
namespace {

constexpr std::size_t kStackBytes = std::size_t{512} << 20;
constexpr std::uint64_t kMostSourceBytes = 256u << 20;

/// Runs `work` on a thread of its own, whose stack is large enough for the deepest nesting that the
/// budgets allow. False if there is no such thread to be had.
bool run_with_large_stack(std::function<void()> work) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStackBytes);
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
  access.library_paths = options.library_paths;
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
  try {
    const FileAccess access(access_options(name, options));
    pov::Interpreter interpreter(options, access, queries, diagnostics);
    interpreter.run(name == "-" ? "standard input" : name, std::move(text));
    return interpreter.take_result();
  } catch (pov::Failure& failure) {
    diagnostics.report(std::move(failure.diagnostic));
  } catch (const std::bad_alloc&) {
    report_error(diagnostics, "there is not enough memory for this scene");
  } catch (const std::length_error&) {
    report_error(diagnostics, "there is not enough memory for this scene");
  } catch (const std::filesystem::filesystem_error& error) {
    report_error(diagnostics, std::string("a file cannot be reached: ") + error.what());
  }
  return std::nullopt;
}

Result<std::string> read_scene_file(const std::string& path) {
  if (path == "-") {
    std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
    return text;
  }
  return FileAccess({}).read(path, kMostSourceBytes);
}

}  // namespace

Result<LoadedScene> load_pov_text(const std::string& name, std::string text,
                                  const LoadOptions& options, SceneQueries& queries,
                                  Diagnostics& diagnostics) {
  std::optional<LoadedScene> scene;
  const bool ran = run_with_large_stack(
      [&] { scene = read_text(name, std::move(text), options, queries, diagnostics); });
  if (!ran) return fail("no thread with a stack of 512 MiB can be started");
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
