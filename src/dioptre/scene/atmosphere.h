// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/core/color.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/ids.h"

namespace dioptre {

/// Mist that takes light away and adds its own.
struct Fog {
  bool ground = false;  ///< thins out with height
  double distance = 0;
  PigmentColor color;
  Vec3 up{0, 1, 0};
  double offset = 0;
  double altitude = 0;
  Vec3 turbulence;
  double turb_depth = 0.5;
  std::uint32_t octaves = 6;
  double omega = 0.5;
  double lambda = 2;
  bool operator==(const Fog&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("ground", self.ground);
    visit("distance", self.distance);
    visit("color", self.color);
    visit("up", self.up);
    visit("offset", self.offset);
    visit("altitude", self.altitude);
    visit("turbulence", self.turbulence);
    visit("turb_depth", self.turb_depth);
    visit("octaves", self.octaves);
    visit("omega", self.omega);
    visit("lambda", self.lambda);
  }
};

/// Colours of the rays that leave the scene, a function of the unit direction.
struct SkySphere {
  std::vector<PigmentId> pigments;  ///< the bottom layer first
  Affine transform;
  Color emission{1, 1, 1};
  bool operator==(const SkySphere&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pigments", self.pigments);
    visit("transform", self.transform);
    visit("emission", self.emission);
  }
};

/// All that is around the objects.
struct Atmosphere {
  Color background;
  float background_transmit = 0;
  std::vector<SkySphere> sky_spheres;  ///< at most one
  std::vector<Fog> fogs;
  bool operator==(const Atmosphere&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("background", self.background);
    visit("background_transmit", self.background_transmit);
    visit("sky_spheres", self.sky_spheres);
    visit("fogs", self.fogs);
  }
};

}  // namespace dioptre
