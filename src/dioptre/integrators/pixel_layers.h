// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dioptre/film/layers.h"
#include "dioptre/integrators/integrator.h"
#include "dioptre/integrators/pixel_watch.h"

namespace dioptre {

/// What a thread notes down while it computes pixels one after the other.
struct PixelLog {
  PixelLog(const RenderScene& scene, LayerSet wanted);
  PixelLog(const PixelLog&) = delete;
  PixelLog& operator=(const PixelLog&) = delete;

  PixelWatch watch;
  RayLog rays;  ///< observed by `watch` if a layer needs that
};

/// The layers of a picture while it is rendered. Different threads may write different pixels.
class PixelLayers {
 public:
  PixelLayers(LayerSet wanted, std::size_t pixels);

  /// Makes a pixel's value and adds what that costs to the pixel.
  template <class Pixel>
  void measure(std::size_t at, PixelLog& log, Pixel&& pixel) {
    if (!wanted_.has_any(LayerSet::costs())) return pixel();
    const Snapshot before = snapshot(log);
    pixel();
    add_cost(at, before, log);
  }

  void set_terms(std::size_t at, const TermLight& terms);
  TermLight terms(std::size_t at) const;

  /// The wanted layers, in the order of their kinds.
  std::vector<ImageLayer> take();

 private:
  /// What a thread has spent up to some moment.
  struct Snapshot {
    std::uint64_t rays = 0;
    WalkCost walks;
    std::uint64_t spans = 0;
    std::int64_t time = 0;  ///< nanoseconds; only if wanted
  };

  Snapshot snapshot(const PixelLog& log) const;
  void add_cost(std::size_t at, const Snapshot& before, PixelLog& log);
  void add(LayerKind kind, std::size_t at, double value);
  std::vector<float>& values(LayerKind kind) { return values_[static_cast<std::size_t>(kind)]; }

  LayerSet wanted_;
  std::array<std::vector<float>, kLayerKinds> values_;  ///< of the wanted kinds
};

}  // namespace dioptre
