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
  const double width = static_cast<float>(repeat.width);  // as the scene language keeps it
  if (width == 0) return p;
  const double copy = std::floor(p[axis] / width);
  p[axis] -= copy * width;
  if (std::fmod(std::fabs(copy), 2) == 1) {
    p[axis] *= repeat.flip[axis];
    if (repeat.flip[axis] < 0) p[axis] += width;
    for (std::size_t other = 0; other < 3; ++other) {
      if (other != axis) p[other] *= repeat.flip[other];
    }
  }
  return p + copy * repeat.offset;
}

/// Towards a centre, by no more than the distance to it. Of holes that repeat, `turbulence` moves
/// each by the random numbers that crackle has for its cell (measured).
Vec3 warped(Vec3 p, const BlackHoleWarp& hole) {
  Vec3 center = hole.center;
  if (hole.repeats) {
    Vec3 cell, size;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (hole.repeat[axis] == 0) continue;
      // No hole leaves its cell, wherever it is moved to.
      size[axis] = std::fmax(hole.repeat[axis], 2 * hole.radius + hole.turbulence[axis]);
      cell[axis] = std::floor(p[axis] / size[axis]);
      center[axis] = std::fmax(center[axis], hole.radius);
    }
    const auto whole = [](double v) {
      return std::fabs(v) < 0x1p53 ? static_cast<std::int64_t>(v) : 0;
    };
    const std::uint32_t hash = cell_hash(whole(cell.x), whole(cell.y), whole(cell.z));
    center += cell * size + hole.turbulence * Vec3{random_value(hash), random_value(hash + 1),
                                                   random_value(hash + 2)};
  }
  const Vec3 from_center = p - center;
  const double distance = length(from_center);
  if (distance >= hole.radius || distance == 0) return p;
  const double pull =
      std::fmin(std::pow((hole.radius - distance) / hole.radius, hole.falloff) * hole.strength, 1);
  const double stretch = hole.inverse ? 1 - pull : 1 + pull;
  return center + stretch * from_center;
}

/// The angle of (x, y) in turns, 0 to 1.
double turn(double x, double y) {
  const double t = std::atan2(y, x) / (2 * std::numbers::pi);
  return t < 0 ? t + 1 : t;
}

/// The plane of the pattern is wrapped once around a body: u around it, v up, w away from it.
Vec3 on_body(Vec3 p, const MappingWarp& map) {
  const auto stretch = [&](double distance) {
    return map.distance_exponent == 0 ? 1 : std::pow(distance, map.distance_exponent);
  };
  const double u = turn(p.x, p.z);
  switch (map.kind) {
    case MappingWarp::Kind::kPlanar:
      return {p.x, p.y, map.distance_exponent};
    case MappingWarp::Kind::kCylindrical: {
      const double radius = std::hypot(p.x, p.z);
      return {u * stretch(radius), p.y, radius};
    }
    case MappingWarp::Kind::kSpherical: {
      const double radius = length(p), s = stretch(radius);
      const double sine = radius > 0 ? std::fmax(-1, std::fmin(1, p.y / radius)) : 0;
      return {u * s, (0.5 + std::asin(sine) / std::numbers::pi) * s, radius};
    }
    case MappingWarp::Kind::kToroidal: {
      const double across = std::hypot(p.x, p.z) - map.major_radius;
      const double radius = std::hypot(across, p.y), s = stretch(radius);
      const double v = std::fmod(turn(across, p.y) + 0.5, 1.0);
      return {u * s, v * s, radius};
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

/// Turned so that w goes along the orientation, by the scene language's own rule (measured; it is a
/// turn for orientations along the axes only).
Vec3 warped(Vec3 p, const MappingWarp& map) {
  const Vec3 m = on_body(p, map);
  const double size = length(map.orientation);
  if (!(size > 0)) return m;
  const Vec3 n = map.orientation / size;
  return {(n.z + n.y) * m.x + n.x * m.z, (n.z + n.x) * m.y - n.y * m.z,
          -n.x * m.x + n.y * m.y + n.z * m.z};
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
