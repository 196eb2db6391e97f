// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dioptre/film/image.h"
#include "dioptre/scene/settings.h"
#include "settings.h"

namespace dioptre::app {

/// Writes a rendered picture in the format that the settings or the name's extension ask for.
Result<void> save_image(const AppSettings& settings, const std::string& path, const Image& image,
                        const Settings& scene_settings);

}  // namespace dioptre::app
