// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dioptre/integrators/render_image.h"
#include "dioptre/scene/settings.h"
#include "settings.h"

namespace dioptre::app {

/// The error says why what the settings ask for cannot be written to that path: layers need an
/// OpenEXR file, and files beside the output need one that has a name.
Result<void> check_output(const AppSettings& settings, const std::string& path);

/// Writes a rendered picture in the format that the settings or the name's extension ask for, with
/// its layers in it, and beside it the pictures of terms and the heat maps.
Result<void> save_render(const AppSettings& settings, const std::string& path, RenderResult result,
                         const Settings& scene_settings);

}  // namespace dioptre::app
