// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/color.h"

namespace dioptre {

/// What fills a solid.
struct Interior {
  double ior = 1;  ///< index of refraction
  bool has_ior = false;
  double dispersion = 1;                 ///< ior of violet over that of red; nothing without an ior
  std::uint32_t dispersion_samples = 7;  ///< colours into which light splits
  double caustics = 0;
  double fade_distance = 0;  ///< 0: no fading
  double fade_power = 0;
  Color fade_color;
  bool operator==(const Interior&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("ior", self.ior);
    visit("has_ior", self.has_ior);
    visit("dispersion", self.dispersion);
    visit("dispersion_samples", self.dispersion_samples);
    visit("caustics", self.caustics);
    visit("fade_distance", self.fade_distance);
    visit("fade_power", self.fade_power);
    visit("fade_color", self.fade_color);
  }
};

}  // namespace dioptre
