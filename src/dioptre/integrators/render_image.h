// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/film/antialias.h"
#include "dioptre/film/image.h"
#include "dioptre/film/layers.h"
#include "dioptre/integrators/integrator.h"
#include "dioptre/scene/scene.h"

namespace dioptre {

/// A rectangle of pixels, ends excluded.
struct PixelRegion {
  std::uint32_t first_column = 0, first_row = 0;
  std::uint32_t end_column = 0, end_row = 0;
};

/// A region cut to the size of the image; all of it if nothing would be left.
PixelRegion region_within(PixelRegion region, std::uint32_t width, std::uint32_t height);

/// How to make the picture: what is not in the scene.
struct RenderOptions {
  std::uint32_t width = 320, height = 240;
  /// The part to render; the rest stays black. Cut to the image; all of it if empty.
  PixelRegion region;
  AntialiasSettings antialias;
  IntegratorOptions integrator_options;
  std::string integrator = "whitted";
  LayerSet layers;            ///< to make beside the picture
  std::uint32_t threads = 0;  ///< 0: as many as there are cores
};

/// The state of a render, for a progress line.
struct RenderProgress {
  double done = 0;  ///< share of all work, 0 to 1
  RayCounts rays;
};

/// What the surroundings give to a render.
struct RenderContext {
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(const RenderProgress&)> progress;  ///< from any thread, one call at a time
};

struct RenderResult {
  Image image;
  std::vector<ImageLayer> layers;  ///< in the scene's own values, in the order of LayerKind
  RayCounts rays;
  QueryTimes queries;       ///< asking what rays meet
  double busy_seconds = 0;  ///< processor time of all threads where the queries were timed
  bool cancelled = false;   ///< the image is not complete

  /// The share of the time that went into finding what rays meet; nothing if it was not measured.
  std::optional<double> intersection_share() const {
    if (queries.timed == 0 || !(busy_seconds > 0)) return std::nullopt;
    return std::clamp(queries.seconds() / busy_seconds, 0.0, 1.0);
  }
};

/// Renders a compiled scene. The image does not depend on the number of threads.
Result<RenderResult> render_image(const RenderScene& scene, const RenderOptions& options,
                                  const RenderContext& context);

/// Compiles a scene and renders it.
Result<RenderResult> render_image(const Scene& scene, const CompileOptions& compile_options,
                                  const RenderOptions& options, const RenderContext& context);

}  // namespace dioptre
