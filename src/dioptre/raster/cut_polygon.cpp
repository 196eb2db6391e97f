// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/cut_polygon.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/triangle/smooth_normal.h"

namespace dioptre {
namespace {

constexpr std::size_t kMostSides = 128;

/// The plane of a polygon, with two of the three axes as its coordinates.
struct PolygonPlane {
  Vec3 anchor, normal;
  std::size_t axis = 0;  ///< the third
  Vec2 flat(Vec3 p) const { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }
  Vec3 lifted(Vec2 p) const {
    Vec3 out = anchor;
    out[(axis + 1) % 3] = p.x, out[(axis + 2) % 3] = p.y;
    out[axis] -= dot(normal, out - anchor) / normal[axis];
    return out;
  }
};

/// Through the first points that are not on one line.
std::optional<PolygonPlane> plane_of(const std::vector<Vec3>& points) {
  if (points.empty()) return std::nullopt;
  std::size_t second = 1;
  while (second < points.size() && points[second] == points[0]) ++second;
  for (std::size_t third = second + 1; third < points.size(); ++third) {
    const Vec3 n = unit_or_zero(cross(points[second] - points[0], points[third] - points[0]));
    if (n == Vec3{}) continue;
    const Vec3 size = abs(n);
    const std::size_t axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : size.y > size.z ? 1 : 2;
    return PolygonPlane{points[0], n, axis};
  }
  return std::nullopt;
}

/// A side that is not level, from its lower to its upper end.
struct Side {
  Vec2 low, high;
  double at(double y) const { return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x); }
};

/// The height at which two sides cross, if they do.
std::optional<double> crossing(const Side& a, const Side& b) {
  const Vec2 u = a.high - a.low, v = b.high - b.low;
  const double slope = cross(u, v);
  const double s = cross(b.low - a.low, v) / slope, t = cross(b.low - a.low, u) / slope;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return std::nullopt;
  return a.low.y + s * u.y;
}

std::vector<Side> sides_of(const Polygon& polygon, const PolygonPlane& plane) {
  std::vector<Side> sides;
  for (const std::vector<Vec3>& points : polygon.outlines) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 from = plane.flat(points[i]), to = plane.flat(points[(i + 1) % points.size()]);
      if (from.y != to.y) sides.push_back(from.y < to.y ? Side{from, to} : Side{to, from});
    }
  }
  return sides;
}

std::vector<double> heights_of(const std::vector<Side>& sides) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    heights.push_back(sides[i].low.y);
    heights.push_back(sides[i].high.y);
    for (std::size_t j = 0; j < i; ++j) {
      const auto y = crossing(sides[i], sides[j]);
      if (y && std::isfinite(*y)) heights.push_back(*y);
    }
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

}  // namespace

std::optional<std::vector<Vec3>> cut_into_triangles(const Polygon& polygon) {
  std::size_t count = 0;
  for (const std::vector<Vec3>& points : polygon.outlines) count += points.size();
  if (polygon.outlines.empty() || count > kMostSides) return std::nullopt;
  std::vector<Vec3> corners;
  const auto plane = plane_of(polygon.outlines[0]);
  if (!plane) return corners;
  const std::vector<Side> sides = sides_of(polygon, *plane);
  const std::vector<double> heights = heights_of(sides);
  std::vector<const Side*> across;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double low = heights[i], high = heights[i + 1], middle = 0.5 * (low + high);
    across.clear();
    for (const Side& side : sides) {
      if (side.low.y <= low && side.high.y >= high) across.push_back(&side);
    }
    std::stable_sort(across.begin(), across.end(),
                     [&](const Side* a, const Side* b) { return a->at(middle) < b->at(middle); });
    for (std::size_t j = 0; j + 1 < across.size(); j += 2) {
      const Vec3 a = plane->lifted({across[j]->at(low), low});
      const Vec3 b = plane->lifted({across[j + 1]->at(low), low});
      const Vec3 c = plane->lifted({across[j + 1]->at(high), high});
      const Vec3 d = plane->lifted({across[j]->at(high), high});
      corners.insert(corners.end(), {a, b, c, a, c, d});
    }
  }
  return corners;
}

}  // namespace dioptre
