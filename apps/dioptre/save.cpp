// SPDX-License-Identifier: Apache-2.0
#include "save.h"

#include <filesystem>

#include "dioptre/film/display.h"
#include "dioptre/io/image/write_image.h"

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

}  // namespace

Result<void> save_image(const AppSettings& settings, const std::string& path, const Image& image,
                        const Settings& scene_settings) {
  const char type = type_of(settings, path);
  if (type == 'E' || type == 'H') {
    Image linear = to_linear(image, scene_settings);
    if (!settings.alpha) linear.alpha.clear();
    return type == 'E' ? write_exr(path, linear, settings.bits == 16) : write_hdr(path, linear);
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

}  // namespace dioptre::app
