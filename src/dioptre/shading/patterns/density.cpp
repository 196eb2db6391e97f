// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/density.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dioptre {
namespace {

/// Up to four values along an axis that count, by their numbers and weights.
struct Taps {
  std::size_t number[4];
  double weight[4];
  int count;
};

/// `place` is in [0, 1), `size` at least 1.
Taps taps(double place, std::uint32_t size, std::uint32_t interpolation) {
  const double at = place * size;
  const auto before = std::min<std::uint64_t>(static_cast<std::uint64_t>(at), size - 1);
  const double t = at - static_cast<double>(before), r = 1 - t;
  const auto number = [&](std::uint64_t i) { return static_cast<std::size_t>(i % size); };
  if (interpolation == 0) return {{number(before)}, {1}, 1};
  if (interpolation == 1) return {{number(before), number(before + 1)}, {r, t}, 2};
  return {{number(before - 1), number(before), number(before + 1), number(before + 2)},
          {-0.5 * t * r * r, 1 + t * t * (1.5 * t - 2.5), 1 + r * r * (1.5 * r - 2.5),
           -0.5 * r * t * t},
          4};
}

bool in_unit(double v) { return v >= 0 && v < 1; }

}  // namespace

double density_value(Vec3 p, const DensityFile& file) {
  const DensityGrid& grid = *file.data;
  if (!in_unit(p.x) || !in_unit(p.y) || !in_unit(p.z)) return 0;
  const std::size_t width = grid.width, height = grid.height;
  if (grid.values.empty() || grid.values.size() != width * height * grid.depth) return 0;
  const Taps x = taps(p.x, grid.width, file.interpolation);
  const Taps y = taps(p.y, grid.height, file.interpolation);
  const Taps z = taps(p.z, grid.depth, file.interpolation);
  double sum = 0;
  for (int k = 0; k < z.count; ++k) {
    for (int j = 0; j < y.count; ++j) {
      const float* row = &grid.values[(z.number[k] * height + y.number[j]) * width];
      double along = 0;
      for (int i = 0; i < x.count; ++i) along += x.weight[i] * row[x.number[i]];
      sum += z.weight[k] * y.weight[j] * along;
    }
  }
  return std::max(0.0, sum);
}

}  // namespace dioptre
