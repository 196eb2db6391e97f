// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/lens_samples.h"

#include <algorithm>
#include <numbers>

namespace dioptre {
namespace {

constexpr Vec2 kCentre{0.5, 0.5};

/// A point of a hexagonal grid: q steps along x and r steps 60 degrees above it.
struct Cell {
  int q, r;
};

/// The six corners of a ring around the centre.
void add_corners(int ring, std::vector<Cell>& cells) {
  for (const Cell c : {Cell{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}) {
    cells.push_back({c.q * ring, c.r * ring});
  }
}

/// The cells of a grid of `rings` rings in the order in which they are sampled (measured, up to the
/// order between two looks at the variance).
std::vector<Cell> hexagon_cells(int rings) {
  constexpr Cell kSecondRing[] = {{1, 1}, {2, -1}, {-2, 1}, {-1, -1}, {-1, 2}, {1, -2}};
  constexpr Cell kThirdRing[] = {{2, 1},  {3, -1},  {-3, 1}, {-2, -1}, {1, 2},  {3, -2},
                                 {-3, 2}, {-1, -2}, {-1, 3}, {-2, 3},  {1, -3}, {2, -3}};
  std::vector<Cell> cells{{0, 0}};
  add_corners(rings, cells);
  if (rings == 3) {
    add_corners(2, cells);
    add_corners(1, cells);
    cells.insert(cells.end(), std::begin(kThirdRing), std::end(kThirdRing));
  }
  if (rings > 1) cells.insert(cells.end(), std::begin(kSecondRing), std::end(kSecondRing));
  if (rings == 2) add_corners(1, cells);
  return cells;
}

/// The points of a hexagonal grid with 1, 2 or 3 rings around its centre, one lens wide.
std::vector<Vec2> hexagon(int rings) {
  const double pitch = 1.0 / (2 * rings + 1);
  std::vector<Vec2> points;
  for (const Cell c : hexagon_cells(rings)) {
    points.push_back(kCentre + pitch * Vec2{c.q + 0.5 * c.r, c.r * std::numbers::sqrt3 / 2});
  }
  return points;
}

double radical_inverse(std::uint32_t i, std::uint32_t base) {
  double value = 0, scale = 1.0 / base;
  for (; i > 0; i /= base, scale /= base) value += (i % base) * scale;
  return value;
}

/// Adds points of the disc around the lens until there are `count`.
void fill_disc(std::uint32_t count, std::vector<Vec2>& points) {
  for (auto i = static_cast<std::uint32_t>(points.size()) + 1; i <= count; ++i) {
    const double radius = 0.5 * std::sqrt(radical_inverse(i, 2));
    const double angle = 2 * std::numbers::pi * radical_inverse(i, 3);
    points.push_back(kCentre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
}

/// The number that a standard normal variable exceeds with a probability of `confidence`, by
/// bisection of the error function.
double normal_quantile(double confidence) {
  double low = -8, high = 8;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::numbers::sqrt2) / 2 > confidence ? low : high) = middle;
  }
  return low;
}

/// The same for a sum of n squares of such variables (E. B. Wilson and M. M. Hilferty, "The
/// Distribution of Chi-square", 1931).
double chi_square_quantile(double n, double normal) {
  const double part = 2 / (9 * n), root = 1 - part + normal * std::sqrt(part);
  return root > 0 ? n * root * root * root : 0;
}

/// After how many samples the next look at their variance follows (measured).
std::uint32_t next_look(std::uint32_t samples, std::uint32_t most) {
  if (samples == 7 || samples == 13) return most < 19 ? samples + 4 : samples + 6;
  return samples < 37 && samples + 4 > 37 ? 37 : samples + 4;
}

}  // namespace

LensSamples::LensSamples(const Camera& camera) {
  const std::uint32_t count = std::clamp(camera.blur_samples, 1u, 1u << 16);
  double cell = 1 / std::sqrt(double(count));
  if (count < 4) {
    points_ = {kCentre};
  } else if (count < 7) {
    points_ = {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};
  } else {
    const int rings = count < 19 ? 1 : count < 37 ? 2 : 3;
    points_ = hexagon(rings);
    if (points_.size() == count) cell = 1.0 / (2 * rings + 1);
  }
  fill_disc(count, points_);
  cell_ = {cell, cell};
  const std::uint32_t usual = count < 7 ? 4 : 7;
  std::uint32_t look = camera.blur_samples_min > 0 ? camera.blur_samples_min : usual;
  // n samples are enough if their variance is below v n q(n) / q(N - 1), where v is the camera's
  // variance, N the most samples and q(n) what a sum of n squares exceeds with the camera's
  // confidence (measured to 3 %).
  const double normal = normal_quantile(std::clamp(camera.confidence, 1e-9, 1 - 1e-9));
  const double all = chi_square_quantile(std::max(count, 2u) - 1, normal);
  enough_.assign(count + 1, 0);
  for (; look < count && all > 0; look = next_look(look, count)) {
    enough_[look] = camera.variance * look * chi_square_quantile(look, normal) / all;
  }
}

bool LensSamples::certain(Color sum, Color squares, std::uint32_t count) const {
  const double enough = enough_[count];
  if (!(enough > 0)) return false;
  const auto channel = [&](double s, double q) {
    const double mean = s / count;
    return q / count - mean * mean < enough;
  };
  return channel(sum.r, squares.r) && channel(sum.g, squares.g) && channel(sum.b, squares.b);
}

}  // namespace dioptre
