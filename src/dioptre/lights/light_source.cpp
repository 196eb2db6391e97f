// SPDX-License-Identifier: Apache-2.0
#include "dioptre/lights/light_source.h"

#include <algorithm>
#include <numbers>

namespace dioptre {
namespace {

double cosine_of_degrees(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

/// 0 below `low`, 1 above `high`, a cubic between; a step where the two are out of order.
double smooth_step(double low, double high, double v) {
  if (low >= high) return v >= high ? 1 : 0;
  const double t = std::clamp((v - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The place of a sample along an axis, -0.5 to 0.5: the grid reaches both ends.
double along(std::uint32_t i, std::uint32_t size) {
  return size > 1 ? double(i) / (size - 1) - 0.5 : 0;
}

}  // namespace

LightSource::LightSource(const Light& light) : light_(light) {
  const Vec3 along_axis = light.point_at - light.location;
  const double size = length(along_axis);
  axis_ = size > 0 ? along_axis / size : Vec3{0, 0, 1};
  cos_radius_ = cosine_of_degrees(light.radius);
  cos_falloff_ = cosine_of_degrees(light.falloff);
}

double LightSource::cone(Vec3 to_light) const {
  const double cosine = -dot(to_light, axis_);
  if (cosine <= 0) return 0;
  const double edge = smooth_step(cos_falloff_, cos_radius_, cosine);
  return edge > 0 ? std::pow(cosine, light_.tightness) * edge : 0;
}

double LightSource::beam(Vec3 point) const {
  const Vec3 to_point = point - light_.location;
  const double along_axis = dot(to_point, axis_);
  if (along_axis <= 0) return 0;
  const double distance = length(to_point - along_axis * axis_);
  if (distance >= light_.falloff) return 0;
  const double edge =
      light_.falloff > light_.radius
          ? smooth_step(0, 1, (light_.falloff - distance) / (light_.falloff - light_.radius))
          : 1;
  return edge * std::pow(1 - distance / light_.falloff, light_.tightness);
}

std::optional<Illumination> LightSource::from(Vec3 location, Vec3 point) const {
  Illumination result;
  const bool parallel = light_.parallel || light_.kind == Light::Kind::kCylinder;
  const Vec3 to_light = location - point;
  if (parallel) {
    result.to_light = -axis_;
    result.distance = dot(to_light, -axis_);
  } else {
    result.distance = length(to_light);
    if (!(result.distance > 0)) return std::nullopt;
    result.to_light = to_light / result.distance;
  }
  double strength = 1;
  if (light_.fade_power > 0 && light_.fade_distance != 0) {
    strength = 2 / (1 + std::pow(result.distance / light_.fade_distance, light_.fade_power));
    if (!std::isfinite(strength)) return std::nullopt;
  }
  if (light_.kind == Light::Kind::kSpotlight) strength *= cone(result.to_light);
  if (light_.kind == Light::Kind::kCylinder) strength *= beam(point);
  result.intensity = light_.color * static_cast<float>(strength);
  if (is_black(result.intensity)) return std::nullopt;
  return result;
}

/// Both axes of an area light: the scene's own, or turned to face a point.
std::array<Vec3, 2> LightSource::area_axes(Vec3 seen_from) const {
  const AreaLight& area = light_.area;
  const Vec3 towards = seen_from - light_.location;
  const double distance = length(towards);
  if (!area.orient || !(distance > 0)) return {area.axis1, area.axis2};
  const Vec3 n = towards / distance;
  const Vec3 side = std::fabs(n.y) < 0.999 ? normalize(cross(Vec3{0, 1, 0}, n)) : Vec3{1, 0, 0};
  return {length(area.axis1) * side, length(area.axis2) * cross(n, side)};
}

Vec3 LightSource::sample(std::uint32_t i, std::uint32_t j, Vec3 seen_from) const {
  const AreaLight& area = light_.area;
  double u = along(i, area.size1), v = along(j, area.size2);
  if (area.circular) {
    // The square mapped onto a disc, each ring of the square to a ring of the disc.
    const double ring = std::max(std::fabs(u), std::fabs(v));
    const double radius = std::hypot(u, v);
    if (radius > 0) u *= ring / radius, v *= ring / radius;
  }
  const auto [axis1, axis2] = area_axes(seen_from);
  return light_.location + u * axis1 + v * axis2;
}

Vec3 LightSource::shape_point(LightShape shape, double u, double v, Vec3 seen_from) const {
  const auto [axis1, axis2] = area_axes(seen_from);
  if (shape == LightShape::kSphere) {
    const double radius = 0.25 * (length(axis1) + length(axis2));
    return sphere_point(light_.location, radius, seen_from, u, v);
  }
  const Vec2 at = shape == LightShape::kDisc ? disc_point(u, v) : Vec2{u - 0.5, v - 0.5};
  return light_.location + at.x * axis1 + at.y * axis2;
}

}  // namespace dioptre
