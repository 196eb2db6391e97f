// SPDX-License-Identifier: Apache-2.0
#include "side_images.h"

#include <filesystem>

#include "dioptre/film/display.h"
#include "dioptre/film/heat_map.h"
#include "dioptre/film/layers.h"
#include "dioptre/io/image/write_image.h"

namespace dioptre::app {

std::string path_beside(const std::string& path, const std::string& name) {
  return std::filesystem::path(path).replace_extension("." + name + ".png").string();
}

Result<void> save_term(const AppSettings& settings, const std::string& path,
                       const ImageLayer& linear, const Image& image,
                       const Settings& scene_settings) {
  Image term(image.width, image.height);
  for (std::size_t at = 0; at < term.pixels.size(); ++at) {
    const float* light = &linear.values[3 * at];
    term.pixels[at] = {light[0], light[1], light[2]};
  }
  Settings in_light = scene_settings;
  in_light.assumed_gamma = 1;
  DisplayOptions display;
  display.file_gamma = settings.file_gamma;
  display.bits = settings.bits;
  display.dither = settings.dither;
  return write_image(path_beside(path, linear.name), encode(term, in_light, display),
                     ImageFormat::kPng);
}

Result<void> save_heat_map(const std::string& path, const ImageLayer& layer, const Image& image) {
  std::string_view unit;
  for (const LayerInfo& info : layer_infos()) {
    if (info.name == layer.name) unit = info.unit;
  }
  return write_image(path_beside(path, layer.name),
                     heat_map(layer, image.width, image.height, unit), ImageFormat::kPng);
}

}  // namespace dioptre::app
