// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/lens_samples.h"

#include <algorithm>
#include <numbers>

namespace dioptre {
namespace {

constexpr Vec2 kCentre{0.5, 0.5};

/// The points of a hexagonal grid with `rings` rings around its centre, one lens wide, the centre
/// and the six corners first.
std::vector<Vec2> hexagon(int rings) {
  const double pitch = 1.0 / (2 * rings + 1);
  const auto point = [&](int q, int r) {
    return kCentre + pitch * Vec2{q + 0.5 * r, r * std::numbers::sqrt3 / 2};
  };
  std::vector<Vec2> points{kCentre};
  for (const auto& [q, r] : {std::pair{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}) {
    points.push_back(point(q * rings, r * rings));
  }
  for (int r = -rings; r <= rings; ++r) {
    for (int q = -rings; q <= rings; ++q) {
      const int ring = std::max({std::abs(q), std::abs(r), std::abs(q + r)});
      const bool corner = ring == rings && (q == 0 || r == 0 || q + r == 0);
      if (ring > 0 && ring <= rings && !corner) points.push_back(point(q, r));
    }
  }
  return points;
}

double radical_inverse(std::uint32_t i, std::uint32_t base) {
  double value = 0, scale = 1.0 / base;
  for (; i > 0; i /= base, scale /= base) value += (i % base) * scale;
  return value;
}

std::vector<Vec2> disc(std::uint32_t count) {
  std::vector<Vec2> points;
  for (std::uint32_t i = 1; i <= count; ++i) {
    const double radius = 0.5 * std::sqrt(radical_inverse(i, 2));
    const double angle = 2 * std::numbers::pi * radical_inverse(i, 3);
    points.push_back(kCentre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return points;
}

/// The number of standard deviations that hold `confidence` of a normal distribution, by bisection
/// of the error function.
double deviations(double confidence) {
  double low = 0, high = 8;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::erf(middle / std::numbers::sqrt2) < confidence ? low : high) = middle;
  }
  return low;
}

}  // namespace

LensSamples::LensSamples(const Camera& camera) {
  const std::uint32_t count = std::clamp(camera.blur_samples, 1u, 1u << 16);
  if (count == 4) {
    points_ = {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};
    cell_ = {0.5, 0.5};
  } else if (count == 7 || count == 19 || count == 37) {
    const int rings = count == 7 ? 1 : count == 19 ? 2 : 3;
    points_ = hexagon(rings);
    cell_ = {1.0 / (2 * rings + 1), 1.0 / (2 * rings + 1)};
  } else {
    points_ = disc(count);
    cell_ = {1 / std::sqrt(double(count)), 1 / std::sqrt(double(count))};
  }
  const std::uint32_t usual = count < 7 ? 4 : 7;
  least_ = camera.blur_samples_min > 0 ? camera.blur_samples_min : usual;
  // The square of the half width of the confidence interval, held against the camera's variance.
  const double z = deviations(std::clamp(camera.confidence, 0.0, 0.999999999));
  tolerance_ = camera.variance / (z * z);
}

bool LensSamples::certain(Color sum, Color squares, std::uint32_t count) const {
  const auto channel = [&](double s, double q) {
    const double variance = std::max(0.0, (q - s * s / count) / (count - 1.0));
    return variance / count <= tolerance_;
  };
  return count > 1 && channel(sum.r, squares.r) && channel(sum.g, squares.g) &&
         channel(sum.b, squares.b);
}

}  // namespace dioptre
