// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/box/box.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/convex.h"

namespace dioptre {
namespace {

/// Faces 0 and 1 are the low and high ends in x, 2 and 3 in y, 4 and 5 in z.
class PreparedBox final : public ConvexShape<PreparedBox> {
 public:
  explicit PreparedBox(const Bounds& box) : box_(box) {}

  Bounds bounds() const override { return box_; }
  bool contains(Vec3 p) const override { return box_.contains(p); }

  bool span(const Ray& ray, ConvexSpan& out) const {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const double o = ray.origin[axis], d = ray.direction[axis];
      const double low = box_.min[axis], high = box_.max[axis];
      if (d == 0) {
        if (o < low || o > high) return false;
        continue;
      }
      const double inverse = 1 / d;
      double t_low = (low - o) * inverse, t_high = (high - o) * inverse;
      // A box without thickness is drawn: it is as thick as its rounding.
      if (low == high) (d > 0 ? t_high : t_low) = std::nextafter(t_low, kInfinity);
      const double error_low = 3 * kRounding * std::fabs(t_low);
      const double error_high = 3 * kRounding * std::fabs(t_high);
      if (d > 0) {
        out.clip_enter(t_low, error_low, 2 * axis);
        out.clip_exit(t_high, error_high, 2 * axis + 1);
      } else {
        out.clip_enter(t_high, error_high, 2 * axis + 1);
        out.clip_exit(t_low, error_low, 2 * axis);
      }
      if (out.empty()) return false;
    }
    return true;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const std::uint32_t axis = crossing.face / 2;
    const bool high = crossing.face % 2 == 1;
    Vec3 normal, position = ray.at(crossing.t);
    normal[axis] = high ? 1 : -1;
    position[axis] = high ? box_.max[axis] : box_.min[axis];
    return {position, normal, normal};
  }

  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    return unfold(surface(ray, crossing).position, crossing.face);
  }

 private:
  /// Where a point of a face lies on the cross of six squares that the box unfolds to, in a picture
  /// four squares wide and three high: -x, +z, +x, -z side by side in the middle row, +y above and
  /// -y below +z (as POV-Ray's manual shows it).
  Vec2 unfold(Vec3 p, std::uint32_t face) const {
    const Vec3 size = box_.extent();
    const auto part = [&](std::size_t axis) {
      return size[axis] > 0 ? std::clamp((p[axis] - box_.min[axis]) / size[axis], 0.0, 1.0) : 0;
    };
    const double x = part(0) / 4, z = part(2) / 4, middle = (1 + part(1)) / 3;
    switch (face) {
      case 0:
        return {z, middle};
      case 1:
        return {0.75 - z, middle};
      case 2:
        return {0.25 + x, part(2) / 3};
      case 3:
        return {0.25 + x, 1 - part(2) / 3};
      case 4:
        return {1 - x, middle};
      default:
        return {0.25 + x, middle};
    }
  }

  Bounds box_;
};

}  // namespace

Result<ShapePtr> prepare(const Box& box) {
  if (!is_finite(box.corner1) || !is_finite(box.corner2))
    return fail("box: a corner is not finite");
  return std::make_unique<PreparedBox>(unite(Bounds{box.corner1, box.corner1}, box.corner2));
}

}  // namespace dioptre
