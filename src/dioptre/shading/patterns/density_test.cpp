// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/density.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre {
namespace {

DensityFile file_of(std::uint32_t interpolation) {
  DensityGrid grid{4, 3, 5, {}};
  for (int i = 0; i < 60; ++i) grid.values.push_back(static_cast<float>(i * 37 % 64) / 64);
  return {"", grid, interpolation};
}

TEST(DensityFile, EveryInterpolationGoesThroughTheValues) {
  for (const std::uint32_t interpolation : {0u, 1u, 2u}) {
    const DensityFile file = file_of(interpolation);
    for (int i = 0; i < 60; ++i) {
      const Vec3 p{i % 4 / 4.0 + 1e-12, i / 4 % 3 / 3.0 + 1e-12, i / 12 / 5.0 + 1e-12};
      EXPECT_NEAR(density_value(p, file), file.data->values[static_cast<std::size_t>(i)], 1e-9);
    }
  }
}

TEST(DensityFile, IsLinearBetweenTwoValues) {
  const DensityFile file = file_of(1);
  const double a = density_value({0.25, 0, 0}, file), b = density_value({0.5, 0, 0}, file);
  EXPECT_NEAR(density_value({0.3, 0, 0}, file), 0.8 * a + 0.2 * b, 1e-9);
  // The last goes over into the first.
  const double first = density_value({0, 0, 0}, file), last = density_value({0.75, 0, 0}, file);
  EXPECT_NEAR(density_value({0.875, 0, 0}, file), (first + last) / 2, 1e-9);
}

TEST(DensityFile, IsZeroOutsideTheUnitCubeAndForEmptyGrids) {
  for (const double bad : {-1e-9, 1.0, 1e300, std::nan(""), -HUGE_VAL}) {
    EXPECT_EQ(density_value({bad, 0.5, 0.5}, file_of(2)), 0) << bad;
    EXPECT_EQ(density_value({0.5, bad, 0.5}, file_of(1)), 0) << bad;
    EXPECT_EQ(density_value({0.5, 0.5, bad}, file_of(0)), 0) << bad;
  }
  EXPECT_EQ(density_value({0.5, 0.5, 0.5}, DensityFile{}), 0);
}

}  // namespace
}  // namespace dioptre
