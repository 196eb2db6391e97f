// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "dioptre/scene/queries.h"

namespace dioptre {

/// Answers by preparing what is asked about, once, with the renderer's own shapes and textures.
std::unique_ptr<SceneQueries> make_scene_queries();

}  // namespace dioptre
