// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>

#include <cstdio>

#include "commands.h"
#include "dioptre/io/image/write_image.h"
#include "dioptre/render/render_scene.h"
#include "dioptre/scene/json.h"
#include "frames.h"
#include "render_failure.h"

namespace dioptre::app {
namespace {

void print_count(const char* name, std::size_t count) { std::printf("%-12s %zu\n", name, count); }

void print_bounds(const Bounds& b) {
  std::printf("%-12s <%g, %g, %g> to <%g, %g, %g>\n", "bounds", b.min.x, b.min.y, b.min.z, b.max.x,
              b.max.y, b.max.z);
}

/// The most memory that the program has held so far.
void print_memory() {
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return;
  std::printf("%-12s %.1f MiB\n", "memory", static_cast<double>(usage.ru_maxrss) / 1024);
}

}  // namespace

int dump_command(const AppSettings& settings) {
  const std::optional<LoadedScene> loaded = load(settings, frame_range(settings).first);
  if (!loaded) return kFailure;
  const std::string path = settings.output.empty() ? "-" : settings.output;
  const auto written = write_file(path, write_json(loaded->scene));
  if (!written) return report_error(written.error().message);
  return kSuccess;
}

int info_command(const AppSettings& settings) {
  const std::optional<LoadedScene> loaded = load(settings, frame_range(settings).first);
  if (!loaded) return kFailure;
  const Scene& scene = loaded->scene;
  print_count("objects", scene.objects.size());
  print_count("roots", scene.roots.size());
  print_count("textures", scene.textures.size());
  print_count("pigments", scene.pigments.size());
  print_count("normals", scene.normals.size());
  print_count("interiors", scene.interiors.size());
  print_count("functions", scene.functions.size());
  print_count("images", scene.images.size());
  print_count("lights", scene.lights.size());
  const auto compiled = RenderScene::compile(scene, {.accelerator = settings.accelerator});
  if (!compiled) return report_render_failure(*loaded, compiled.error().message);
  print_count("items", (*compiled)->items().size());
  print_bounds((*compiled)->bounds());
  print_memory();
  return kSuccess;
}

}  // namespace dioptre::app
