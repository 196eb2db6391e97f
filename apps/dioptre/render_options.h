// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/integrators/render_image.h"
#include "settings.h"

namespace dioptre::app {

/// How the settings ask for a scene to be made ready.
CompileOptions compile_options(const AppSettings& settings);

/// How the settings ask for the picture to be made.
RenderOptions render_options(const AppSettings& settings);

/// The error says that the picture would have more pixels than the settings allow.
Result<void> check_size(const AppSettings& settings);

}  // namespace dioptre::app
