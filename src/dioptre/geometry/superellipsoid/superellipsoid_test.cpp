// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/superellipsoid/superellipsoid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dioptre/geometry/superellipsoid/power_norm.h"

namespace dioptre {
namespace {

TEST(PowerNorm, SlopesAreThoseOfTheValue) {
  std::mt19937_64 random{5};
  std::uniform_real_distribution<double> uniform(0.1, 1);
  for (const double p : {0.4, 1.0, 1.7, 2.0, 4.0, 7.0, 20.0, 300.0}) {
    const PowerNorm norm(p);
    for (int i = 0; i < 100; ++i) {
      const double a = uniform(random), b = uniform(random), h = 1e-6;
      const PowerNorm::Jet jet = norm.jet(a, b);
      EXPECT_NEAR(jet.value, norm.value(a, b), 1e-14 * jet.value);
      EXPECT_NEAR(jet.by_a, (norm.value(a + h, b) - norm.value(a - h, b)) / (2 * h), 1e-5);
      EXPECT_NEAR(jet.by_b, (norm.value(a, b + h) - norm.value(a, b - h)) / (2 * h), 1e-5);
      EXPECT_NEAR(a * jet.by_a + b * jet.by_b, jet.value, 1e-13 * jet.value);  // homogeneous
    }
  }
}

TEST(Superellipsoid, PointsFoundFulfilItsEquation) {
  std::mt19937_64 random{6};
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Superellipsoid s : {Superellipsoid{0.3, 0.7}, {1.2, 0.5}, {1.9, 1.1}, {3, 4}}) {
    const ShapePtr shape = prepare(s).value();
    int found = 0;
    for (int i = 0; i < 500; ++i) {
      const Ray ray{{uniform(random), uniform(random), -3},
                    {0.3 * uniform(random), 0.3 * uniform(random), 1}};
      Crossing hit;
      if (!shape->nearest(ray, {0, kInfinity}, hit)) continue;
      ++found;
      const Vec3 p = abs(ray.at(hit.t));
      const double flat = std::pow(p.x, 2 / s.east_west) + std::pow(p.y, 2 / s.east_west);
      EXPECT_NEAR(std::pow(flat, s.east_west / s.north_south) + std::pow(p.z, 2 / s.north_south), 1,
                  1e-9 + 10 * hit.error);
    }
    EXPECT_GT(found, 20);
  }
}

TEST(Superellipsoid, OddExponentsGiveAnErrorOrAShape) {
  for (const double e : {0.0, -1.0, std::nan("")}) {
    EXPECT_FALSE(prepare(Superellipsoid{e, 1}));
    EXPECT_FALSE(prepare(Superellipsoid{1, e}));
  }
  for (const double e : {5e-324, 1e-9, 1e-3, 50.0, 1e9, kInfinity}) {
    for (const double n : {1e-300, 0.5, 1e6}) {
      const ShapePtr shape = prepare(Superellipsoid{e, n}).value();
      Crossings out;
      for (int i = 0; i < 50; ++i) {
        shape->crossings({{0.02 * i, 0.1, -3}, {0.01, 0.02, 1}}, Interval::all(), out);
      }
      EXPECT_LE(out.size(), 1000u);
    }
  }
}

}  // namespace
}  // namespace dioptre
