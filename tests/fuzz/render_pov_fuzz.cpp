// SPDX-License-Identifier: Apache-2.0
// Feeds any bytes to the whole program: reads a scene, and renders a few pixels of it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "dioptre/integrators/render_image.h"
#include "dioptre/io/load_scene.h"
#include "dioptre/render/scene_queries.h"
#include "tight_limits.h"

namespace dioptre {
namespace {

void render(Scene scene) {
  scene.settings.max_trace_level = std::min<std::uint32_t>(scene.settings.max_trace_level, 4);
  scene.camera.blur_samples = std::min<std::uint32_t>(scene.camera.blur_samples, 4);
  for (Light& light : scene.lights) light.is_area = false;
  RenderOptions options;
  options.width = 5;
  options.height = 4;
  options.threads = 1;
  (void)render_image(scene, {}, options, {});
}

}  // namespace
}  // namespace dioptre

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const dioptre::LoadOptions options = dioptre::tight_limits();
  const auto queries = dioptre::make_scene_queries();
  dioptre::Diagnostics diagnostics;
  const std::string text(reinterpret_cast<const char*>(data), size);
  auto loaded = dioptre::load_pov_text("fuzz/input.pov", text, options, *queries, diagnostics);
  if (loaded) dioptre::render(std::move(loaded->scene));
  return 0;
}
