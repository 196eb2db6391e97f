// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/color.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/finish.h"
#include "dioptre/scene/settings.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre {

/// How the thin films on the surfaces of a scene (`irid`) colour what these send to the viewer.
class ThinFilms {
 public:
  explicit ThinFilms(const Settings& settings);

  /// What multiplies the light that a film at a point of the world passes on:
  /// 1 + amount cos(2 pi d (N.L + N.V) / wavelength) for each channel, where `cosines` is
  /// N.L + N.V (for mirrors L is the mirrored direction) and d the thickness, times
  /// 1 + turbulence (2 s(p) - 1) with five octaves of the scalar turbulence s. (Measured, to 2e-5.)
  /// A channel without a wavelength is black.
  Color tint(const Finish& finish, Vec3 point, double cosines) const;

 private:
  Color wavelengths_;
  NoiseGenerator generator_;
};

}  // namespace dioptre
