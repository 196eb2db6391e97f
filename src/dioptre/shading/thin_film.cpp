// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/thin_film.h"

#include <cmath>
#include <numbers>

#include "dioptre/shading/patterns/pattern_evaluator.h"

namespace dioptre {

ThinFilms::ThinFilms(const Settings& settings)
    : wavelengths_(settings.irid_wavelength), generator_(noise_generator_of({}, settings)) {}

Color ThinFilms::tint(const Finish& finish, Vec3 point, double cosines) const {
  double thickness = finish.irid_thickness;
  if (finish.irid_turbulence != 0) {
    const double noise = scalar_turbulence(point, {.count = 5}, generator_);
    thickness *= 1 + finish.irid_turbulence * (2 * noise - 1);
  }
  const double way = 2 * std::numbers::pi * thickness * cosines;
  const auto channel = [&](double wavelength) {
    const double wave = std::cos(way / wavelength);
    return std::isfinite(wave) ? static_cast<float>(1 + finish.irid * wave) : 0.0f;
  };
  return {channel(wavelengths_.r), channel(wavelengths_.g), channel(wavelengths_.b)};
}

}  // namespace dioptre
