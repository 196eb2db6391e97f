// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dioptre/io/load_scene.h"

namespace dioptre::app {

/// Prints why a scene that was read cannot be rendered, with the place in the scene file of the
/// first object that is to blame, if there is one. Returns kFailure.
int report_render_failure(const LoadedScene& loaded, const std::string& message);

}  // namespace dioptre::app
