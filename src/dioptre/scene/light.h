// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/color.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/ids.h"

namespace dioptre {

/// A grid of point lights.
struct AreaLight {
  Vec3 axis1{1, 0, 0};
  Vec3 axis2{0, 0, 1};
  std::uint32_t size1 = 1;
  std::uint32_t size2 = 1;
  std::int32_t adaptive = -1;  ///< subdivision level to start from; -1: every sample
  bool jitter = false;
  bool circular = false;
  bool orient = false;
  bool illumination = false;  ///< samples also light, not only shade
  bool operator==(const AreaLight&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("axis1", self.axis1);
    visit("axis2", self.axis2);
    visit("size1", self.size1);
    visit("size2", self.size2);
    visit("adaptive", self.adaptive);
    visit("jitter", self.jitter);
    visit("circular", self.circular);
    visit("orient", self.orient);
    visit("illumination", self.illumination);
  }
};

/// A light source, in world space.
struct Light {
  enum class Kind : std::uint8_t { kPoint, kSpotlight, kCylinder };
  Kind kind = Kind::kPoint;
  Vec3 location;
  Color color{1, 1, 1};
  Vec3 point_at{0, 0, 0};
  double radius = 30;   ///< spotlight: half angle in degrees of full light; cylinder: distance
  double falloff = 45;  ///< where light ends
  double tightness = 0;
  bool parallel = false;
  bool shadowless = false;
  bool is_area = false;
  AreaLight area;
  double fade_distance = 0;
  double fade_power = 0;
  ObjectId projected_through;  ///< a window: light comes through it only
  std::uint32_t group = 0;     ///< 0: lights all; else only the objects of this light group
  bool media_interaction = true;
  bool media_attenuation = false;
  bool operator==(const Light&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("kind", self.kind);
    visit("location", self.location);
    visit("color", self.color);
    visit("point_at", self.point_at);
    visit("radius", self.radius);
    visit("falloff", self.falloff);
    visit("tightness", self.tightness);
    visit("parallel", self.parallel);
    visit("shadowless", self.shadowless);
    visit("is_area", self.is_area);
    visit("area", self.area);
    visit("fade_distance", self.fade_distance);
    visit("fade_power", self.fade_power);
    visit("projected_through", self.projected_through);
    visit("group", self.group);
    visit("media_interaction", self.media_interaction);
    visit("media_attenuation", self.media_attenuation);
  }
};

}  // namespace dioptre
