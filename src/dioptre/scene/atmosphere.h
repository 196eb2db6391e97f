// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/affine.h"
#include "dioptre/core/color.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/ids.h"
#include "dioptre/scene/pigment.h"

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

/// A band of colours around a direction, seen against whatever is far behind.
struct Rainbow {
  Vec3 direction{0, 0, 1};         ///< of the sunlight
  Vec3 up{0, 1, 0};                ///< from where the angles of the arc count
  double angle = 0;                ///< of the middle of the band to the direction, degrees
  double width = 0;                ///< of the band, degrees
  double distance = 0;             ///< over which 1 - 1/e of the colour appears
  double jitter = 0;               ///< at random added to the place in the map
  double arc_angle = 360;          ///< of the part of the circle that is there, degrees
  double falloff_angle = 360;      ///< where the arc begins to fade, degrees
  std::vector<ColorEntry> colors;  ///< from the inner edge (0) to the outer (1)
  bool operator==(const Rainbow&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("direction", self.direction);
    visit("up", self.up);
    visit("angle", self.angle);
    visit("width", self.width);
    visit("distance", self.distance);
    visit("jitter", self.jitter);
    visit("arc_angle", self.arc_angle);
    visit("falloff_angle", self.falloff_angle);
    visit("colors", self.colors);
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
  std::vector<Rainbow> rainbows;
  bool operator==(const Atmosphere&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("background", self.background);
    visit("background_transmit", self.background_transmit);
    visit("sky_spheres", self.sky_spheres);
    visit("fogs", self.fogs);
    visit("rainbows", self.rainbows);
  }
};

}  // namespace dioptre
