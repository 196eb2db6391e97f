// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/color.h"

namespace dioptre {

/// What holds for the whole scene.
struct Settings {
  double assumed_gamma = 1;  ///< 0: the sRGB curve
  bool gamma_correction =
      true;  ///< false: old scenes without assumed_gamma; values go to files as they are
  Color ambient_light{1, 1, 1};
  std::uint32_t max_trace_level = 5;
  double adc_bailout = 1.0 / 255;
  std::uint32_t noise_generator = 2;
  std::uint32_t number_of_waves = 10;
  Color irid_wavelength{0.70f, 0.52f, 0.48f};
  /// Of scenes before 3.7: `filter` takes away of a surface's own light what it lets through in the
  /// brightest channel, not all of it.
  bool old_opacity = false;
  double language_version = 3.7;  ///< 3.7 or the older one that the scene asks for
  bool operator==(const Settings&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("assumed_gamma", self.assumed_gamma);
    visit("gamma_correction", self.gamma_correction);
    visit("ambient_light", self.ambient_light);
    visit("max_trace_level", self.max_trace_level);
    visit("adc_bailout", self.adc_bailout);
    visit("noise_generator", self.noise_generator);
    visit("number_of_waves", self.number_of_waves);
    visit("irid_wavelength", self.irid_wavelength);
    visit("old_opacity", self.old_opacity);
    visit("language_version", self.language_version);
  }
};

}  // namespace dioptre
