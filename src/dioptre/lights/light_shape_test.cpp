// SPDX-License-Identifier: Apache-2.0
#include "dioptre/lights/light_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dioptre {
namespace {

constexpr int kSide = 400;

/// The mean of a function over the unit square.
template <class Function>
double mean(Function f) {
  double sum = 0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) sum += f((i + 0.5) / kSide, (j + 0.5) / kSide);
  }
  return sum / (kSide * kSide);
}

TEST(LightShape, TheDiscIsFilledEvenly) {
  for (const double radius : {0.1, 0.25, 0.4, 0.5}) {
    const double share =
        mean([radius](double u, double v) { return length(disc_point(u, v)) <= radius ? 1 : 0; });
    EXPECT_NEAR(share, 4 * radius * radius, 2e-3);
  }
  // A circular segment: what a straight edge leaves of the disc.
  for (const double edge : {-0.4, -0.1, 0.0, 0.3}) {
    const double share = mean([edge](double u, double v) { return disc_point(u, v).x < edge; });
    const double h = 2 * edge;
    EXPECT_NEAR(share, 1 - (std::acos(h) - h * std::sqrt(1 - h * h)) / std::numbers::pi, 2e-3);
  }
}

TEST(LightShape, PointsOfTheSphereLieOnItAndFillItsSolidAngle) {
  const Vec3 center{1, 2, 3}, eye{4, -1, 2};
  const double radius = 1.5, distance = length(center - eye);
  const Vec3 axis = (center - eye) / distance;
  const double rim = std::sqrt(1 - radius * radius / (distance * distance));
  for (const double cosine : {rim, 0.5 * (1 + rim), 0.9 + 0.1 * rim}) {
    const double share = mean([&](double u, double v) {
      const Vec3 p = sphere_point(center, radius, eye, u, v);
      EXPECT_NEAR(length(p - center), radius, 1e-9);
      return dot(normalize(p - eye), axis) >= cosine ? 1 : 0;
    });
    EXPECT_NEAR(share, (1 - cosine) / (1 - rim), 3e-3);
  }
  EXPECT_EQ(sphere_point(center, 10, eye, 0.3, 0.6), center);
}

}  // namespace
}  // namespace dioptre
