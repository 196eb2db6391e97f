// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/height_field/height_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dioptre/geometry/height_field/height_tree.h"
#include "dioptre/geometry/height_field/land.h"
#include "dioptre/geometry/triangle/smooth_normal.h"
#include "dioptre/geometry/triangle/triangle_hit.h"

namespace dioptre {
namespace {

constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 28;
/// The floor is below the lowest land by this part of the heights' size.
constexpr double kFloorDepth = 0x1p-10;
// Faces from here on are not land: the water, and the walls 2 axis + (1 at the high end).
constexpr std::uint32_t kWater = 0xffffff00;
constexpr std::uint32_t kWalls = 0xffffff01;

bool before(const Crossing& a, const Crossing& b) {
  return a.t != b.t ? a.t < b.t : a.face < b.face;
}

/// Where the ray crosses the plane where the axis' coordinate is `at`.
Crossing cross_plane(const Ray& ray, std::size_t axis, double at, std::uint32_t face) {
  Crossing crossing;
  crossing.t = (at - ray.origin[axis]) / ray.direction[axis];
  crossing.error = 2 * std::numeric_limits<double>::epsilon() * std::fabs(crossing.t);
  crossing.face = face;
  crossing.visible = false;
  return crossing;
}

class PreparedHeightField final : public Shape {
 public:
  explicit PreparedHeightField(const HeightField& field)
      : land_(field.grid, field.smooth_scale),
        tree_(land_),
        water_(field.water_level),
        smooth_(field.smooth) {
    const Interval heights = tree_.heights();
    const double top = std::fmax(heights.max, water_);
    const double lowest = std::fmin(heights.min, 0);
    box_ = {{0, lowest - kFloorDepth * std::fmax(top - lowest, std::fabs(top)), 0}, {1, top, 1}};
    if (box_.min.y == top) box_.min.y -= kFloorDepth;
  }

  Bounds bounds() const override { return box_; }

  bool contains(Vec3 p) const override {
    if (!box_.contains(p)) return false;
    return p.y < water_ || p.y < land_.height_at(p.x, p.z);
  }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const std::size_t first = out.size();
    Crossing in, leave;
    if (!clip_to_box(ray, in, leave)) return false;
    for_each_hit(ray, {-kInfinity, kInfinity},
                 [&](const Crossing& hit, Interval&) { out.push_back(hit); });
    add_water(ray, out);
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), before);
    const bool inside_box =
        out.size() > first ? !out[first].entering : contains(ray.at(0.5 * (in.t + leave.t)));
    keep_alternating(out, first, inside_box);
    close(in, leave, first, inside_box, out);
    return cut(range, first, out);
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    bool found = false;
    for_each_hit(ray, range, [&](const Crossing& hit, Interval& rest) {
      if (found && !before(hit, out)) return;
      found = true;
      out = hit;
      rest.max = hit.t;
    });
    return found;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    Surface s;
    if (crossing.face >= kWater) {
      s.position = ray.at(crossing.t);
      s.normal = normal_of(crossing.face);
    } else {
      const auto [a, b, c] = land_.triangle(crossing.face);
      s.position = a + crossing.u * (b - a) + crossing.v * (c - a);
      s.normal = normalize(cross(c - a, b - a));
    }
    s.shading_normal = s.normal;
    if (smooth_ && crossing.face < kWater) {
      const Vec3 mixed = land_.smooth_normal_at(s.position.x, s.position.z);
      if (mixed != Vec3{}) s.shading_normal = mixed;
    }
    return s;
  }

  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    return {p.x, p.z};
  }

 private:
  static Vec3 normal_of(std::uint32_t face) {
    if (face == kWater) return {0, 1, 0};
    const std::uint32_t wall = face - kWalls;
    Vec3 normal;
    normal[wall / 2] = wall % 2 ? 1 : -1;
    return normal;
  }

  /// Where the ray's line goes into the box and leaves it; false if it misses.
  bool clip_to_box(const Ray& ray, Crossing& in, Crossing& out) const {
    if (!is_finite(ray.origin) || !is_finite(ray.direction)) return false;
    if (ray.direction == Vec3{}) return false;
    in.t = -kInfinity;
    out.t = kInfinity;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const double direction = ray.direction[axis];
      if (direction == 0) {
        if (!(box_.min[axis] <= ray.origin[axis] && ray.origin[axis] <= box_.max[axis])) {
          return false;
        }
        continue;
      }
      const std::uint32_t high = direction > 0;
      const Crossing far =
          cross_plane(ray, axis, high ? box_.max[axis] : box_.min[axis], kWalls + 2 * axis + high);
      const Crossing near = cross_plane(ray, axis, high ? box_.min[axis] : box_.max[axis],
                                        kWalls + 2 * axis + 1 - high);
      if (near.t > in.t) in = near;
      if (far.t < out.t) out = far;
    }
    in.entering = true;
    out.entering = false;
    return in.t <= out.t && std::isfinite(in.t) && std::isfinite(out.t);
  }

  /// Where the ray goes through the top of water, which is not drawn.
  void add_water(const Ray& ray, Crossings& out) const {
    if (ray.direction.y == 0) return;
    Crossing crossing = cross_plane(ray, 1, water_, kWater);
    const Vec3 p = ray.at(crossing.t);
    if (!(0 <= p.x && p.x <= 1 && 0 <= p.z && p.z <= 1)) return;
    if (!(land_.height_at(p.x, p.z) < water_) || water_ <= box_.min.y) return;
    crossing.entering = ray.direction.y < 0;
    out.push_back(crossing);
  }

  /// Drops what rounding doubled, where the shore meets the land.
  static void keep_alternating(Crossings& out, std::size_t first, bool inside) {
    std::size_t kept = first;
    for (std::size_t i = first; i < out.size(); ++i) {
      if (out[i].entering == inside) continue;
      inside = out[i].entering;
      out[kept++] = out[i];
    }
    out.resize(kept);
  }

  /// Adds the walls where the ray is inside at the ends of the box.
  static void close(Crossing in, Crossing leave, std::size_t first, bool inside, Crossings& out) {
    const bool at_end = out.size() > first ? out.back().entering : inside;
    if (at_end) {
      if (out.size() > first) leave.t = std::fmax(leave.t, out.back().t);
      out.push_back(leave);
    }
    if (!inside) return;
    in.t = std::fmin(in.t, out[first].t);
    out.insert(out.begin() + static_cast<std::ptrdiff_t>(first), in);
  }

  /// Leaves what is in the range, and returns whether the ray is inside at its beginning.
  static bool cut(Interval range, std::size_t first, Crossings& out) {
    bool inside = false;
    std::size_t kept = first;
    for (std::size_t i = first; i < out.size(); ++i) {
      if (range.surrounds(out[i].t)) {
        out[kept++] = out[i];
      } else if (out[i].t <= range.min) {
        inside = out[i].entering;
      }
    }
    out.resize(kept);
    return inside;
  }

  /// Calls sink(hit, range) for the hits of land above the water in the range, the nearest cells
  /// first; it may lower range.max.
  template <class Sink>
  void for_each_hit(const Ray& ray, Interval range, Sink&& sink) const {
    if (!is_finite(ray.origin) || !is_finite(ray.direction) || ray.direction == Vec3{}) return;
    const TriangleRay triangle_ray(ray);
    tree_.traverse(ray, range, water_, [&](std::uint32_t cell, Interval& rest) {
      for (const std::uint32_t index : {2 * cell, 2 * cell + 1}) {
        const auto [a, b, c] = land_.triangle(index);
        if (!line_meets_triangle(triangle_ray, a, b, c)) continue;
        const TriangleHit hit = triangle_hit(triangle_ray, a, b, c);
        if (!range.surrounds(hit.t)) continue;
        if (!(a.y + hit.v * (b.y - a.y) + hit.w * (c.y - a.y) >= water_)) continue;
        sink(crossing_of(hit, index), rest);
      }
    });
  }

  Land land_;
  HeightTree tree_;
  double water_;
  bool smooth_;
  Bounds box_;
};

}  // namespace

Result<ShapePtr> prepare(const HeightField& field) {
  const HeightGrid& grid = *field.grid;
  if (grid.width < 2 || grid.depth < 2) return fail("height_field needs at least 2 x 2 points");
  const std::uint64_t points = std::uint64_t{grid.width} * grid.depth;
  if (points > kMostPoints) return fail("height_field has too many points");
  if (grid.heights.size() != points) return fail("height_field has a wrong number of heights");
  for (const float height : grid.heights) {
    if (!std::isfinite(height)) return fail("height_field has a height that is not finite");
  }
  if (!std::isfinite(field.water_level)) return fail("height_field water_level is not finite");
  const Vec3 scale = field.smooth_scale;
  if (!is_finite(scale) || !(scale.x > 0 && scale.y > 0 && scale.z > 0)) {
    return fail("height_field smooth_scale must be greater than 0");
  }
  return std::make_unique<PreparedHeightField>(field);
}

}  // namespace dioptre
