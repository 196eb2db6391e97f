// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dioptre/film/image.h"
#include "dioptre/scene/settings.h"
#include "settings.h"

namespace dioptre::app {

/// For out/scene.png and "rays": out/scene.rays.png.
std::string path_beside(const std::string& path, const std::string& name);

/// Writes a layer of linear light as a PNG beside a picture, encoded as the picture is.
Result<void> save_term(const AppSettings& settings, const std::string& path,
                       const ImageLayer& linear, const Image& image,
                       const Settings& scene_settings);

/// Writes the heat map of a layer as a PNG beside a picture.
Result<void> save_heat_map(const std::string& path, const ImageLayer& layer, const Image& image);

}  // namespace dioptre::app
