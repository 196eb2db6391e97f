// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/dispersion.h"

#include <gtest/gtest.h>

namespace dioptre {
namespace {

TEST(Dispersion, ColoursAddUpToNearlyWhite) {
  for (const std::uint32_t colors : {1u, 2u, 3u, 7u, 70u, 71u, 1000u}) {
    Color sum;
    for (std::uint32_t i = 0; i < colors; ++i) sum += color_share(i, colors);
    EXPECT_NEAR(sum.r, 0.9938, 1e-4) << colors;
    EXPECT_NEAR(sum.g, 1, 1e-4) << colors;
    EXPECT_NEAR(sum.b, 0.9962, 1e-4) << colors;
  }
}

TEST(Dispersion, SevenColoursAreThoseMeasured) {
  const Color red = color_share(0, 7), green = color_share(3, 7), violet = color_share(6, 7);
  EXPECT_NEAR(red.r, 0.25699, 3e-5);
  EXPECT_NEAR(green.g, 0.3612, 3e-5);
  EXPECT_NEAR(violet.b, 0.2047, 3e-5);
  EXPECT_NEAR(violet.r, 0.0365, 3e-5);
}

TEST(Dispersion, IsTheRatioOfTheEndsOfTheSpectrum) {
  const Interior glass{.ior = 1.5, .has_ior = true, .dispersion = 1.1};
  EXPECT_NEAR(ior_of_color(glass, 1) / ior_of_color(glass, 0), 1.1, 1e-12);
  EXPECT_NEAR(ior_of_color(glass, 0.5), 1.5, 1e-12);
  EXPECT_TRUE(disperses(glass));
  EXPECT_FALSE(disperses(Interior{.dispersion = 1.1}));
}

}  // namespace
}  // namespace dioptre
