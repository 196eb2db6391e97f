// SPDX-License-Identifier: Apache-2.0
#include "save.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "dioptre/film/display.h"
#include "dioptre/io/image/write_image.h"
#include "side_images.h"

namespace dioptre::app {
namespace {

/// The type by the extension of the name, where that names one; a type asked for by +F wins if it
/// is not the default.
char type_of(const AppSettings& settings, const std::string& path) {
  if (settings.file_type != 'N') return settings.file_type;
  const std::string end = to_lower(std::filesystem::path(path).extension().string());
  if (end == ".ppm") return 'P';
  if (end == ".exr") return 'E';
  if (end == ".hdr") return 'H';
  if (end == ".jpg" || end == ".jpeg") return 'J';
  if (end == ".tga") return 'T';
  if (end == ".bmp") return 'B';
  return 'N';
}

ImageFormat format_of(char type) {
  switch (type) {
    case 'B':
      return ImageFormat::kBmp;
    case 'J':
      return ImageFormat::kJpeg;
    case 'P':
      return ImageFormat::kPpm;
    case 'C':
    case 'S':
    case 'T':
      return ImageFormat::kTga;
    default:
      return ImageFormat::kPng;
  }
}

LayerSet kind_of(const ImageLayer& layer) {
  LayerSet set;
  for (const LayerInfo& info : layer_infos()) {
    if (info.name == layer.name) set.add(info.kind);
  }
  return set;
}

std::vector<ImageLayer> only(LayerSet wanted, std::vector<ImageLayer> layers) {
  std::erase_if(layers, [&](const ImageLayer& l) { return !wanted.has_any(kind_of(l)); });
  return layers;
}

/// `layers` are linear.
Result<void> save_image(const AppSettings& settings, const std::string& path, const Image& image,
                        std::vector<ImageLayer> layers, const Settings& scene_settings) {
  const char type = type_of(settings, path);
  if (type == 'E' || type == 'H') {
    Image linear = to_linear(image, scene_settings);
    if (!settings.alpha) linear.alpha.clear();
    if (type == 'H') return write_hdr(path, linear);
    return write_exr(path, linear, settings.bits == 16, only(settings.layers, std::move(layers)));
  }
  const bool deep = type == 'N' || type == 'P';
  DisplayOptions display;
  display.file_gamma = settings.file_gamma;
  display.bits = deep ? settings.bits : 8;
  display.alpha = settings.alpha && type != 'P' && type != 'J';
  display.dither = settings.dither && type != 'J';
  WriteImageOptions options;
  if (settings.compression > 1) options.jpeg_quality = static_cast<int>(settings.compression);
  return write_image(path, encode(image, scene_settings, display), format_of(type), options);
}

}  // namespace

Result<void> check_output(const AppSettings& settings, const std::string& path) {
  if (!settings.layers.empty() && type_of(settings, path) != 'E') {
    return fail("layers need an OpenEXR file; name the output .exr or ask for +FE");
  }
  if ((settings.term_images || !settings.heat_maps.empty()) && path == "-") {
    return fail("terms and heat maps are files beside the output; give that a name");
  }
  return {};
}

Result<void> save_render(const AppSettings& settings, const std::string& path, RenderResult result,
                         const Settings& scene_settings) {
  to_linear(result.layers, result.image, scene_settings);
  const auto saved = save_image(settings, path, result.image, result.layers, scene_settings);
  if (!saved) return saved;
  for (const ImageLayer& layer : result.layers) {
    const LayerSet kind = kind_of(layer);
    const bool as_term = settings.term_images && kind.has_any(LayerSet::terms());
    if (!as_term && !settings.heat_maps.has_any(kind)) continue;
    const auto beside = as_term ? save_term(settings, path, layer, result.image, scene_settings)
                                : save_heat_map(path, layer, result.image);
    if (!beside) return beside;
  }
  return {};
}

}  // namespace dioptre::app
