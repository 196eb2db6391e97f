// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "dioptre/core/color.h"
#include "dioptre/core/rng.h"
#include "dioptre/film/image.h"

namespace dioptre {

/// A sample of the image: a colour and the share of it that is not background.
struct FilmSample {
  Color color;
  float alpha = 1;
};

/// How edges are smoothed.
struct AntialiasSettings {
  std::uint32_t method = 0;  ///< 0: pixel centres only; 1: a grid; 2: recursive corners
  double threshold = 0.3;    ///< of the sum over r, g, b of |a^(1/gamma) - b^(1/gamma)|
  std::uint32_t depth = 3;   ///< 1 to 9; method 1: depth^2 samples; method 2: levels of division
  double jitter = 0;         ///< amount, 0 to 1, in cells of the grid
  double gamma = 2.5;
};

/// How much two samples differ to the eye: the sum over r, g, b of |a^(1/gamma) - b^(1/gamma)|.
inline double antialias_difference(Color a, Color b, double inverse_gamma) {
  const auto adapted = [&](float v) { return v > 0 ? std::pow(double{v}, inverse_gamma) : 0.0; };
  return std::fabs(adapted(a.r) - adapted(b.r)) + std::fabs(adapted(a.g) - adapted(b.g)) +
         std::fabs(adapted(a.b) - adapted(b.b));
}

inline FilmSample operator+(FilmSample a, FilmSample b) {
  return {a.color + b.color, a.alpha + b.alpha};
}
inline FilmSample operator*(FilmSample a, float s) { return {a.color * s, a.alpha * s}; }

/// The pixels of a finished first pass (one sample in each centre) that method 1 refines: both
/// sides of every step above the threshold between neighbours in a row or a column. Depends on the
/// image alone. One byte per pixel, 1 where refined. Pixels outside the region are neither
/// compared nor marked; ends are excluded.
std::vector<std::uint8_t> pixels_to_refine(const Image& centres, const AntialiasSettings& settings,
                                           std::uint32_t first_column, std::uint32_t first_row,
                                           std::uint32_t end_column, std::uint32_t end_row);

/// Method 1: the mean of the centre sample and a grid of depth x depth samples. `sample(x, y)`
/// takes continuous pixel coordinates, (i + 0.5, j + 0.5) being the centre of pixel (i, j). A Value
/// is a FilmSample or anything that can be averaged like one.
template <class Value, class Sample>
Value refine_on_grid(std::uint32_t x, std::uint32_t y, const Value& centre,
                     const AntialiasSettings& settings, Sample&& sample) {
  const std::uint32_t n = std::clamp<std::uint32_t>(settings.depth, 1, 9);
  Value sum = centre;
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t number = j * n + i;
      const double du = settings.jitter * (random_at(x, y, number, 0) - 0.5);
      const double dv = settings.jitter * (random_at(x, y, number, 1) - 0.5);
      sum = sum + sample(x + (i + 0.5 + du) / n, y + (j + 0.5 + dv) / n);
    }
  }
  return sum * (1.0f / static_cast<float>(n * n + 1));
}

/// Method 2: the corners of a pixel and, where they differ, of its quarters, down to `depth`
/// divisions; each square counts with the mean of its corners. Corners shared by squares of one
/// pixel are sampled once. Samples are FilmSamples or anything that can be averaged like one and
/// has a `color`.
template <class Sample>
class CornerRefiner {
 public:
  using Value = std::invoke_result_t<Sample&, double, double>;

  CornerRefiner(const AntialiasSettings& settings, Sample& sample)
      : settings_(settings),
        cells_(1u << std::clamp<std::uint32_t>(settings.depth, 1, 9)),
        sample_(sample) {}

  /// The value of a pixel.
  Value pixel(std::uint32_t x, std::uint32_t y) {
    x_ = x, y_ = y;
    known_.clear();
    return square(0, 0, cells_);
  }

 private:
  Value corner(std::uint32_t i, std::uint32_t j) {
    const std::uint64_t gx = std::uint64_t{x_} * cells_ + i, gy = std::uint64_t{y_} * cells_ + j;
    const auto [place, is_new] = known_.try_emplace(j * (cells_ + 1) + i);
    if (is_new) {
      const auto jitter = [&](std::uint32_t dimension) {
        if (settings_.jitter == 0) return 0.0;
        return settings_.jitter * (random_at(static_cast<std::uint32_t>(gx),
                                             static_cast<std::uint32_t>(gy), 0, dimension) -
                                   0.5);
      };
      place->second = sample_((gx + jitter(0)) / cells_, (gy + jitter(1)) / cells_);
    }
    return place->second;
  }

  bool differ(const std::array<Value, 4>& c) const {
    const double inverse_gamma = 1 / settings_.gamma;
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        if (antialias_difference(c[a].color, c[b].color, inverse_gamma) > settings_.threshold) {
          return true;
        }
      }
    }
    return false;
  }

  Value square(std::uint32_t i, std::uint32_t j, std::uint32_t size) {
    const std::array<Value, 4> c{corner(i, j), corner(i + size, j), corner(i, j + size),
                                 corner(i + size, j + size)};
    if (size == 1 || !differ(c)) return (c[0] + c[1] + c[2] + c[3]) * 0.25f;
    const std::uint32_t half = size / 2;
    return (square(i, j, half) + square(i + half, j, half) + square(i, j + half, half) +
            square(i + half, j + half, half)) *
           0.25f;
  }

  const AntialiasSettings& settings_;
  std::uint32_t cells_;
  Sample& sample_;
  std::uint32_t x_ = 0, y_ = 0;
  std::unordered_map<std::uint32_t, Value> known_;
};

}  // namespace dioptre
