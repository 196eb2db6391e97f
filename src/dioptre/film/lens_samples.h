// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/film/antialias.h"
#include "dioptre/scene/camera.h"

namespace dioptre {

/// The points of a lens that a pixel looks through, and when it has looked enough.
///
/// 7, 19 or 37 samples stand on a hexagonal grid, 4 on a square, each moved at random within its
/// cell; the grid is one lens wide (measured). More come from a Halton sequence in the disc.
class LensSamples {
 public:
  explicit LensSamples(const Camera& camera);

  /// The mean over the samples of pixel (x, y); stops early once the mean is known to within the
  /// camera's `variance` at its `confidence`. `sample(x, y, lens)` takes continuous pixel
  /// coordinates and a point of the lens in [0,1)^2.
  template <class Sample>
  FilmSample pixel(std::uint32_t x, std::uint32_t y, Sample&& sample) const {
    FilmSample sum{{}, 0};
    Color squares;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const double px = x + random_at(x, y, i, 0), py = y + random_at(x, y, i, 1);
      const Vec2 moved{cell_.x * (random_at(x, y, i, 2) - 0.5),
                       cell_.y * (random_at(x, y, i, 3) - 0.5)};
      const FilmSample one = sample(px, py, points_[i] + moved);
      sum = sum + one;
      squares += one.color * one.color;
      if (i + 1 >= least_ && certain(sum.color, squares, i + 1)) {
        return sum * (1.0f / static_cast<float>(i + 1));
      }
    }
    return sum * (1.0f / static_cast<float>(points_.size()));
  }

 private:
  bool certain(Color sum, Color squares, std::uint32_t count) const;

  std::vector<Vec2> points_;
  Vec2 cell_;
  std::uint32_t least_;
  double tolerance_;  ///< of the standard error of the mean
};

}  // namespace dioptre
