// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/warp.h"

#include <cmath>
#include <numbers>

namespace dioptre {
namespace {

Vec3 warped(Vec3 p, const Affine& inverse) { return inverse.point(p); }

Vec3 warped(Vec3 p, const Turbulence& t) {
  return p + t.amount * vector_turbulence(p, {t.octaves, t.omega, t.lambda});
}

Vec3 warped(Vec3 p, const RepeatWarp& repeat) {
  const std::size_t axis = repeat.axis % 3;
  if (repeat.width == 0) return p;
  const double copy = std::floor(p[axis] / repeat.width);
  p[axis] -= copy * repeat.width;
  if (std::fmod(std::fabs(copy), 2) == 1) {
    p[axis] *= repeat.flip[axis];
    if (repeat.flip[axis] < 0) p[axis] += repeat.width;
    for (std::size_t other = 0; other < 3; ++other) {
      if (other != axis) p[other] *= repeat.flip[other];
    }
  }
  return p + copy * repeat.offset;
}

Vec3 warped(Vec3 p, const BlackHoleWarp& hole) {
  Vec3 center = hole.center;
  if (hole.repeats) {
    Vec3 cell;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (hole.repeat[axis] == 0) continue;
      cell[axis] = std::floor(p[axis] / hole.repeat[axis]);
    }
    center += cell * hole.repeat;
    const auto jitter = [&](double salt) {
      return cell == Vec3{} ? 0.0 : noise(cell + Vec3{salt, salt, salt}, NoiseGenerator::kOriginal);
    };
    center += hole.turbulence * Vec3{jitter(1), jitter(2), jitter(3)};
  }
  const Vec3 from_center = p - center;
  const double distance = length(from_center);
  if (distance >= hole.radius || distance == 0) return p;
  const double pull =
      std::pow((hole.radius - distance) / hole.radius, hole.falloff) * hole.strength;
  const double stretch = hole.inverse ? 1 - pull : 1 + pull;
  return center + stretch * from_center;
}

/// Wraps the x-y plane once around a body; the result is in image coordinates where the body has
/// them, z the depth.
Vec3 warped(Vec3 p, const MappingWarp& map) {
  const auto turn = [](double a, double b) {
    const double t = std::atan2(a, b) / (2 * std::numbers::pi);
    return t < 0 ? t + 1 : t;
  };
  const auto stretched = [&](double u, double v, double distance) {
    const double s = map.distance_exponent == 0 ? 1 : std::pow(distance, map.distance_exponent);
    return Vec3{u * s, v * s, distance};
  };
  switch (map.kind) {
    case MappingWarp::Kind::kPlanar: {
      const Vec3 n = abs(map.orientation);
      if (n.x > n.y && n.x > n.z) return {-p.z, p.y, p.x};
      if (n.y > n.z) return {p.x, -p.z, p.y};
      return p;
    }
    case MappingWarp::Kind::kCylindrical: {
      const double r = std::hypot(p.x, p.z);
      return stretched(turn(p.x, p.z), p.y, r);
    }
    case MappingWarp::Kind::kSpherical: {
      const double r = length(p);
      const double up = r > 0 ? std::asin(std::fmax(-1, std::fmin(1, p.y / r))) : 0;
      return stretched(turn(p.x, p.z), 0.5 + up / std::numbers::pi, r);
    }
    case MappingWarp::Kind::kToroidal: {
      const double across = std::hypot(p.x, p.z) - map.major_radius;
      return stretched(turn(p.x, p.z), turn(p.y, across), std::hypot(across, p.y));
    }
    case MappingWarp::Kind::kCubic: {
      const Vec3 a = abs(p);
      if (a.x >= a.y && a.x >= a.z) return {p.z / a.x, p.y / a.x, a.x};
      if (a.y >= a.z) return {p.x / a.y, p.z / a.y, a.y};
      return {p.x / a.z, p.y / a.z, a.z};
    }
  }
  return p;
}

}  // namespace

WarpList::WarpList(const std::vector<Warp>& warps, bool skip_first) {
  for (std::size_t i = warps.size(); i-- > (skip_first ? 1u : 0u);) {
    const auto* placed = std::get_if<TransformWarp>(&warps[i]);
    if (!placed) {
      std::visit(
          [&](const auto& warp) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(warp)>, TransformWarp>) {
              steps_.push_back(warp);
            }
          },
          warps[i]);
      continue;
    }
    const auto back = inverse(placed->transform);
    if (!back) continue;
    transform_ = then(placed->transform, transform_);
    Affine* last = steps_.empty() ? nullptr : std::get_if<Affine>(&steps_.back());
    if (last) {
      *last = then(*last, *back);
    } else {
      steps_.push_back(*back);
    }
  }
}

Vec3 WarpList::apply(Vec3 p) const {
  for (const Step& step : steps_) {
    p = std::visit([p](const auto& warp) { return warped(p, warp); }, step);
  }
  return p;
}

}  // namespace dioptre
