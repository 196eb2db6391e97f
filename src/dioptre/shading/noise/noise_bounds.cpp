// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/noise/noise_bounds.h"

#include <cmath>

namespace dioptre {
namespace {

/// Bounds of the gradient and of its change per distance, which are what six million random points
/// show and a fifth more, and of the rounding of the noise.
struct Bounds {
  double gradient, bend, rounding;
};
constexpr Bounds bounds_of(NoiseGenerator generator) {
  switch (generator) {
    case NoiseGenerator::kOriginal:
      return {3.4, 13, 1e-14};
    case NoiseGenerator::kRangeCorrected:
      return {1.7, 7, 1e-14};
    default:
      return {1.85, 8, 1e-8};  // its points are shifted by 1e7
  }
}

Interval around(double centre, double reach) { return widen({centre - reach, centre + reach}, 4); }

double half_width(Interval a) { return 0.5 * (a.max - a.min); }

}  // namespace

double steepest_noise(NoiseGenerator generator) { return bounds_of(generator).gradient; }

IntervalJet noise_range(const IntervalJet& x, const IntervalJet& y, const IntervalJet& z,
                        NoiseGenerator generator) {
  const bool clipped = generator != NoiseGenerator::kPerlin;
  const Interval whole = clipped ? Interval{0, 1} : Interval{-0.2, 1.2};
  const Bounds bounds = bounds_of(generator);
  const double steepest = bounds.gradient * std::sqrt(magnitude(x.slope) * magnitude(x.slope) +
                                                      magnitude(y.slope) * magnitude(y.slope) +
                                                      magnitude(z.slope) * magnitude(z.slope));
  const Interval any_slope = steepest < kInfinity ? Interval{-steepest, steepest} : Interval::all();
  const Vec3 half{half_width(x.value), half_width(y.value), half_width(z.value)};
  const double radius = length(half);
  // In larger balls there is next to everything that there is.
  constexpr double kLargestRadius = 0.4;
  if (!(radius < kLargestRadius)) return {whole, any_slope};
  Vec3 gradient;
  const Vec3 centre{x.value.min + half.x, y.value.min + half.y, z.value.min + half.z};
  const double value = unclipped_noise(centre, generator, gradient);
  const double turn = bounds.bend * radius;
  const double reach =
      std::min(bounds.gradient * radius, dot(abs(gradient), half) + 0.5 * turn * radius);
  Interval range = around(value, reach + bounds.rounding);
  Interval slope = around(gradient.x, turn) * x.slope + around(gradient.y, turn) * y.slope +
                   around(gradient.z, turn) * z.slope;
  slope = intersect(slope, any_slope);
  if (clipped && (range.min < 0 || range.max > 1)) {
    slope = unite(slope, {0, 0});
    range = {std::clamp(range.min, 0.0, 1.0), std::clamp(range.max, 0.0, 1.0)};
  }
  return {range, slope};
}

}  // namespace dioptre
