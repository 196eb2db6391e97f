// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/rainbow.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "dioptre/core/rng.h"

namespace dioptre {
namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// A number in [-1, 1) that follows from a direction alone.
double noise_of(Vec3 direction) {
  std::uint64_t bits = mix_bits(std::bit_cast<std::uint64_t>(direction.x));
  bits = mix_bits(bits ^ std::bit_cast<std::uint64_t>(direction.y));
  return 2 * to_unit(mix_bits(bits ^ std::bit_cast<std::uint64_t>(direction.z))) - 1;
}

/// The share of the colour at an angle, in degrees, from the top of the arc: 1 up to half the
/// falloff angle, a cubic down to 0 at half the arc angle (measured).
double arc_share(const Rainbow& rainbow, double from_top) {
  const double end = rainbow.arc_angle / 2, full = rainbow.falloff_angle / 2;
  if (from_top > end) return 0;
  if (!(from_top > full)) return 1;
  const double t = (end - from_top) / (end - full);
  return t * t * (3 - 2 * t);
}

}  // namespace

Rainbows::Rainbows(const Scene& scene) {
  for (const Rainbow& rainbow : scene.atmosphere.rainbows) {
    const bool shows = rainbow.width > 0 && rainbow.distance > 0 && !rainbow.colors.empty();
    if (!shows || !(length(rainbow.direction) > 0) || !is_finite(rainbow.direction)) continue;
    const Vec3 forward = normalize(rainbow.direction);
    Vec3 side = cross(forward, rainbow.up);
    if (!(length(side) > 0)) side = cross(forward, Vec3{forward.y, forward.z, forward.x});
    if (!(length(side) > 0)) side = cross(forward, Vec3{1, 0, 0});
    side = normalize(side);
    bows_.push_back(
        {rainbow, PositionMap(rainbow.colors, false), forward, cross(side, forward), side});
  }
}

/// Each bow acts as a fog of the colour at its place in the map (0 at the inner edge, 1 at the
/// outer), whose filter tints what comes through by what the bow takes; away from the middle of the
/// arc it transmits more (all measured).
FogEffect Rainbows::effect(const Ray& ray, double distance) const {
  FogEffect sum{{0, 0, 0}, {0, 0, 0}};
  int count = 0;
  for (const Bow& bow : bows_) {
    const Rainbow& rainbow = bow.rainbow;
    const double angle = degrees(std::acos(std::clamp(dot(ray.direction, bow.forward), -1.0, 1.0)));
    double place = (angle - rainbow.angle) / rainbow.width + 0.5;
    if (!(place >= 0 && place <= 1)) continue;
    const double from_top =
        degrees(std::fabs(std::atan2(dot(ray.direction, bow.side), dot(ray.direction, bow.up))));
    const auto share = static_cast<float>(arc_share(rainbow, from_top));
    if (share == 0) continue;
    if (rainbow.jitter != 0) place += rainbow.jitter * noise_of(ray.direction);
    const MapPlace at = bow.map.find(place);
    const PigmentColor color = rainbow.colors[at.first].color * (1 - at.share) +
                               rainbow.colors[at.second].color * at.share;
    const double depth = std::min(distance, kSkyDistance) / rainbow.distance;
    const float through =
        std::max(static_cast<float>(std::exp(-depth)), 1 - share * (1 - color.transmit));
    const float taken = color.filter * (1 - through);
    sum.transmittance += (Color{1, 1, 1} * (1 - taken) + color.color * taken) * through;
    sum.added += color.color * (1 - through);
    ++count;
  }
  if (count == 0) return {};
  const float weight = 1.0f / static_cast<float>(count);
  return {sum.transmittance * weight, sum.added * weight};
}

}  // namespace dioptre
