// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/film/antialias.h"
#include "dioptre/scene/camera.h"

namespace dioptre {

/// The points of a lens that a pixel looks through, and when it has looked enough.
///
/// 7, 19 or 37 samples stand on a hexagonal grid, 4 on a square, each moved at random within its
/// cell; the grid is one lens wide. Other numbers begin with the largest grid that they hold and go
/// on with a Halton sequence in the disc (measured).
class LensSamples {
 public:
  explicit LensSamples(const Camera& camera);

  /// The mean over the samples around (x, y), in continuous pixel coordinates, moved at random
  /// within a square of `spread` pixels; stops early once the mean is certain. The random numbers
  /// follow from (x, y) alone. `sample(x, y, lens)` takes a point of the lens in [0,1)^2 and gives
  /// a FilmSample or something derived from it.
  template <class Sample>
  auto mean(double x, double y, double spread, Sample&& sample) const {
    using Value = std::invoke_result_t<Sample&, double, double, Vec2>;
    const auto key = [](double v) { return static_cast<std::uint32_t>(std::lround(v * 64)); };
    const std::uint32_t kx = key(x), ky = key(y);
    Value sum{};
    sum.alpha = 0;
    Color squares;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const auto random = [&](std::uint32_t k) { return random_at(kx, ky, i, k) - 0.5; };
      const Vec2 moved{cell_.x * random(2), cell_.y * random(3)};
      const Value one = sample(x + spread * random(0), y + spread * random(1), points_[i] + moved);
      sum = sum + one;
      squares += one.color * one.color;
      if (certain(sum.color, squares, i + 1)) {
        return sum * (1.0f / static_cast<float>(i + 1));
      }
    }
    return sum * (1.0f / static_cast<float>(points_.size()));
  }

 private:
  bool certain(Color sum, Color squares, std::uint32_t count) const;

  std::vector<Vec2> points_;
  Vec2 cell_;
  /// By the number of samples: the variance below which they are enough; 0 where that is not asked.
  std::vector<double> enough_;
};

}  // namespace dioptre
