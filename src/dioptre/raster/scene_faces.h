// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "dioptre/raster/faces.h"
#include "dioptre/raster/screen_view.h"
#include "dioptre/render/render_scene.h"

namespace dioptre {

/// The faces of all items that the camera may see: flat primitives as they are, everything else
/// cut up as finely as the view needs, solids after their operators were applied. The same for any
/// number of threads (0: all there are). An error if they are too many. Once `cancel` is set the
/// result is of no use.
Result<FaceSet> scene_faces(const RenderScene& scene, const ScreenView& view, std::uint32_t threads,
                            const std::atomic<bool>* cancel);

}  // namespace dioptre
