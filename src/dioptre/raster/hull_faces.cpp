// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/hull_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "dioptre/raster/axes.h"

namespace dioptre {
namespace {

constexpr double kPi = std::numbers::pi;

/// A net of quadrilaterals between rows of corners, each row closed to a ring.
struct Rings {
  std::uint32_t columns = 0, rows = 0;
  bool closed = false;        ///< the last row joins the first
  std::vector<Vec3> corners;  ///< row after row, in the primitive's own space
  double reach = 1;           ///< how far inside the surface may be, in depths of the hull
};

/// Rings of `columns` corners around an axis; for a polygon whose sides touch a circle from outside
/// the radius is that of its corners.
class RingMaker {
 public:
  RingMaker(Vec3 axis, std::uint32_t columns) : across_(beside(axis)) { rings_.columns = columns; }

  void add(Vec3 center, double radius) {
    for (std::uint32_t i = 0; i < rings_.columns; ++i) {
      const double angle = 2 * kPi * i / rings_.columns;
      rings_.corners.push_back(center + radius * std::cos(angle) * across_[0] +
                               radius * std::sin(angle) * across_[1]);
    }
    ++rings_.rows;
  }
  Rings take(bool closed = false) {
    rings_.closed = closed;
    return std::move(rings_);
  }

 private:
  std::array<Vec3, 2> across_;
  Rings rings_;
};

/// Between two discs, with both.
std::optional<Rings> hull_of_cone(Vec3 base, double base_radius, Vec3 cap, double cap_radius) {
  constexpr std::uint32_t kSides = 16;
  const Vec3 axis = unit_or_zero(cap - base);
  if (axis == Vec3{}) return std::nullopt;
  const double wider = 1 / std::cos(kPi / kSides);
  RingMaker rings(axis, kSides);
  rings.add(base, 0);
  rings.add(base, wider * std::fabs(base_radius));
  rings.add(cap, wider * std::fabs(cap_radius));
  rings.add(cap, 0);
  return rings.take();
}

std::optional<Rings> hull(const Cylinder& cylinder) {
  return hull_of_cone(cylinder.base, cylinder.radius, cylinder.cap, cylinder.radius);
}

std::optional<Rings> hull(const Cone& cone) {
  return hull_of_cone(cone.base, cone.base_radius, cone.cap, cone.cap_radius);
}

/// Rings of latitude. Between two of them, and between two of their corners, a face comes nearer to
/// the centre than the corners by the cosines of half the steps. From outside the hull is in front
/// of the sphere. From inside a ray leaves the sphere, of radius r, no more than sqrt(R^2 - r^2)
/// before it leaves one of radius R around the hull, whose depth is that of 2 R.
std::optional<Rings> hull(const Sphere& sphere) {
  constexpr std::uint32_t kAround = 16, kBands = 8;
  const double ratio = std::cos(kPi / kAround) * std::cos(kPi / (2 * kBands));
  const double radius = std::fabs(sphere.radius) / ratio;
  RingMaker rings({0, 1, 0}, kAround);
  for (std::uint32_t i = 0; i <= kBands; ++i) {
    const double angle = kPi * i / kBands;
    rings.add(sphere.center + Vec3{0, -radius * std::cos(angle), 0}, radius * std::sin(angle));
  }
  Rings net = rings.take();
  net.reach = std::sqrt(1 - ratio * ratio) / 2 / ratio;
  return net;
}

/// Between two corners of a ring the tube's middle comes nearer to the axis, and is seen narrower.
std::optional<Rings> hull(const Torus& torus) {
  constexpr std::uint32_t kAround = 32, kOfTube = 12;
  const double squash = std::cos(kPi / kAround);
  const double major = std::fabs(torus.major_radius);
  const double tube =
      (std::fabs(torus.minor_radius) + major * (1 - squash)) / (std::cos(kPi / kOfTube) * squash);
  RingMaker rings({0, 1, 0}, kAround);
  for (std::uint32_t i = 0; i < kOfTube; ++i) {
    const double angle = 2 * kPi * i / kOfTube;
    rings.add({0, tube * std::sin(angle), 0}, major + tube * std::cos(angle));
  }
  return rings.take(true);
}

template <class Other>
std::optional<Rings> hull(const Other&) {
  return std::nullopt;
}

}  // namespace

bool add_hull_faces(const ScreenView& view, const PlacedPrimitive& primitive, std::uint32_t item,
                    FaceSet& out) {
  const auto rings = std::visit([](const auto& shape) { return hull(shape); }, *primitive.shape);
  if (!rings || !out.has_room(rings->corners.size(), 2 * rings->corners.size())) return false;
  std::vector<Vec3> corners;
  double near = kInfinity, far = -kInfinity;
  for (const Vec3 corner : rings->corners) {
    corners.push_back(view.to_view(primitive.to_world.point(corner)));
    if (!is_finite(corners.back())) return false;
    near = std::min(near, corners.back().z);
    far = std::max(far, corners.back().z);
  }
  // A hull without depth stands for something without depth.
  const auto reach =
      std::max(static_cast<float>(rings->reach * (far - near)), std::numeric_limits<float>::min());
  const auto first = static_cast<std::uint32_t>(out.corners.size());
  out.corners.insert(out.corners.end(), corners.begin(), corners.end());
  const std::uint32_t bands = rings->closed ? rings->rows : rings->rows - 1;
  for (std::uint32_t band = 0; band < bands; ++band) {
    const std::uint32_t low = first + band * rings->columns;
    const std::uint32_t high = first + (band + 1) % rings->rows * rings->columns;
    for (std::uint32_t i = 0; i < rings->columns; ++i) {
      const std::uint32_t next = (i + 1) % rings->columns;
      out.faces.push_back({{low + i, low + next, high + next}, item, reach});
      out.faces.push_back({{low + i, high + next, high + i}, item, reach});
    }
  }
  return true;
}

}  // namespace dioptre
