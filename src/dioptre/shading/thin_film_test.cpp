// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/thin_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dioptre {
namespace {

TEST(ThinFilm, AddsAWaveOfItsThicknessOverTheWavelength) {
  const ThinFilms films{Settings{}};
  Finish finish;
  finish.irid = 0.4;
  for (const double thickness : {-0.7, 0.0, 0.1, 0.35, 2.0}) {
    finish.irid_thickness = thickness;
    for (const double cosines : {0.0, 0.5, 2.0}) {
      const Color tint = films.tint(finish, {}, cosines);
      const double turn = 2 * std::numbers::pi * thickness * cosines;
      EXPECT_NEAR(tint.r, 1 + 0.4 * std::cos(turn / 0.70), 1e-5);
      EXPECT_NEAR(tint.g, 1 + 0.4 * std::cos(turn / 0.52), 1e-5);
      EXPECT_NEAR(tint.b, 1 + 0.4 * std::cos(turn / 0.48), 1e-5);
    }
  }
}

TEST(ThinFilm, TurbulenceChangesItFromPlaceToPlace) {
  const ThinFilms films{Settings{}};
  Finish finish;
  finish.irid = 1;
  finish.irid_thickness = 0.05;
  finish.irid_turbulence = 0.3;
  EXPECT_NE(films.tint(finish, {0.2, 0.3, 0.4}, 2), films.tint(finish, {1.2, 0.3, 0.4}, 2));
  finish.irid_turbulence = 0;
  EXPECT_EQ(films.tint(finish, {0.2, 0.3, 0.4}, 2), films.tint(finish, {1.2, 0.3, 0.4}, 2));
}

TEST(ThinFilm, NoNumbersMakeItUnbounded) {
  for (const double bad : {0.0, 1e300, -1e300, std::nan(""), HUGE_VAL}) {
    Settings settings;
    settings.irid_wavelength = {static_cast<float>(bad), 0, -1};
    Finish finish;
    finish.irid = 1;
    finish.irid_thickness = bad;
    finish.irid_turbulence = bad;
    const Color tint = ThinFilms(settings).tint(finish, {bad, 1, 2}, 2);
    for (const float v : {tint.r, tint.g, tint.b}) EXPECT_TRUE(v >= 0 && v <= 2) << bad;
  }
}

}  // namespace
}  // namespace dioptre
