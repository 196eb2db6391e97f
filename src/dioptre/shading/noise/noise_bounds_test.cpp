// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/noise/noise_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dioptre {
namespace {

class NoiseBounds : public testing::TestWithParam<int> {
 protected:
  NoiseGenerator generator_ = static_cast<NoiseGenerator>(GetParam());
  std::mt19937_64 random_{3};
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 point(double reach) {
    const double x = uniform(-reach, reach), y = uniform(-reach, reach);
    return {x, y, uniform(-reach, reach)};
  }
  double raw(Vec3 p) {
    Vec3 gradient;
    return unclipped_noise(p, generator_, gradient);
  }
};

TEST_P(NoiseBounds, UnclippedNoiseIsNoiseBeforeClipping) {
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = point(500);
    double value = raw(p);
    if (generator_ != NoiseGenerator::kPerlin) value = std::fmin(std::fmax(value, 0), 1);
    EXPECT_NEAR(value, noise(p, generator_), 1e-12);
  }
}

TEST_P(NoiseBounds, TheGradientIsTheLimitOfDifferences) {
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = point(500), d = normalize(point(1));
    Vec3 gradient;
    unclipped_noise(p, generator_, gradient);
    const double slope = (raw(p + kStep * d) - raw(p - kStep * d)) / (2 * kStep);
    EXPECT_NEAR(dot(gradient, d), slope, 1e-3);
    EXPECT_LT(length(gradient), steepest_noise(generator_));
  }
}

TEST_P(NoiseBounds, RangesHoldAllValuesAndSlopes) {
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = point(100), d = point(2);
    const double width = std::exp(uniform(-7, 0));
    const Vec3 q = p + width * d;
    const auto jet = [](double a, double b, double slope) {
      return IntervalJet{widen({std::min(a, b), std::max(a, b)}), interval_of(slope)};
    };
    const IntervalJet range =
        noise_range(jet(p.x, q.x, d.x), jet(p.y, q.y, d.y), jet(p.z, q.z, d.z), generator_);
    double last = 0;
    for (int k = 0; k <= 8; ++k) {
      const double value = noise(p + (k / 8.0 * width) * d, generator_);
      ASSERT_TRUE(range.value.contains(value));
      const double slope = 8 * (value - last) / width, slack = 1e-13 / width;
      if (k > 0) {
        ASSERT_TRUE(range.slope.min - slack <= slope && slope <= range.slope.max + slack);
      }
      last = value;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllGenerators, NoiseBounds, testing::Values(1, 2, 3));

}  // namespace
}  // namespace dioptre
