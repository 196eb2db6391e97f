// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/blob/field.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dioptre {
namespace {

/// A rigid map that carries the unit vector `axis` to z.
Affine turn_to_z(Vec3 axis) {
  const Vec3 other = std::fabs(axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalize(cross(axis, other)), v = cross(axis, u);
  return {{u.x, v.x, axis.x}, {u.y, v.y, axis.y}, {u.z, v.z, axis.z}, {}};
}

/// A box around the image of the unit ball at `center` (unit space) under `map`.
Bounds ball_image(Vec3 center, const Affine& map) {
  const Vec3 middle = map.point(center);
  Vec3 reach;
  for (std::size_t i = 0; i < 3; ++i) {
    reach[i] = length(Vec3{map.x[i], map.y[i], map.z[i]}) * (1 + 1e-12) +
               1e-15 * (std::fabs(middle[i]) + std::fabs(map.o[i]));
  }
  return {middle - reach, middle + reach};
}

/// Where the ray is within distance 1 of the origin; empty if it is not.
Interval within_unit_ball(Vec3 o, Vec3 d) {
  const double a = dot(d, d);
  if (a == 0) return {};
  const double middle = -dot(o, d) / a;
  const double rest = 1 - length_squared(o + middle * d);
  if (!(rest > 0)) return {};
  const double half = std::sqrt(rest / a);
  return {middle - half, middle + half};
}

void append_piece(const FieldComponent& c, Interval where, Vec3 o, Vec3 d,
                  std::vector<FieldPiece>& pieces) {
  if (where.min < where.max) {
    pieces.push_back({where.min, where.max, {o, d}, c.strength, c.index});
  }
}

Result<std::optional<FieldComponent>> field_component(const BlobComponent& component) {
  const Affine& map = component.transform;
  if (!is_finite(component.a) || !is_finite(component.b) || !std::isfinite(component.radius) ||
      !std::isfinite(component.strength)) {
    return fail("blob component is not finite");
  }
  if (component.cylinder && component.a == component.b) {
    return fail("blob component is a cylinder without length");
  }
  const double radius = std::fabs(component.radius);
  if (radius == 0 || component.strength == 0) return std::optional<FieldComponent>{};
  const std::optional<Affine> back = inverse(map);
  if (!back) return fail("blob component has a singular transform");

  FieldComponent c;
  c.strength = component.strength;
  Affine unit = translation(-component.a);
  if (component.cylinder) {
    const Vec3 axis = component.b - component.a;
    unit = then(unit, turn_to_z(normalize(axis)));
    c.length = length(axis) / radius;
  }
  unit = then(unit, scaling(Vec3{1, 1, 1} / radius));
  c.to_unit = then(*back, unit);
  const std::optional<Affine> from_unit = inverse(c.to_unit);
  if (!from_unit || !std::isfinite(c.length)) {
    return fail("blob component is too small or too large");
  }
  c.bounds = unite(ball_image({}, *from_unit), ball_image({0, 0, c.length}, *from_unit));
  if (!c.bounds.finite()) return fail("blob component is too small or too large");
  return std::optional<FieldComponent>(c);
}

}  // namespace

Bernstein<4> FieldPiece::field(double ta, double tb) const {
  const Vec3 a = ray.at(ta), b = ray.at(tb);
  const double g0 = 1 - dot(a, a), g1 = 1 - dot(a, b), g2 = 1 - dot(b, b);
  return {strength * g0 * g0, strength * g0 * g1, strength * (g0 * g2 + 2 * g1 * g1) / 3,
          strength * g1 * g2, strength * g2 * g2};
}

Result<std::vector<FieldComponent>> field_components(const Blob& blob) {
  std::vector<FieldComponent> components;
  components.reserve(blob.components.size());
  for (std::size_t i = 0; i < blob.components.size(); ++i) {
    Result<std::optional<FieldComponent>> c = field_component(blob.components[i]);
    if (!c) return tl::unexpected<Error>(c.error());
    if (!*c) continue;
    (*c)->index = static_cast<std::uint32_t>(i);
    (*c)->texture = blob.components[i].texture;
    components.push_back(**c);
  }
  return components;
}

void append_pieces(const FieldComponent& c, const Ray& ray, std::vector<FieldPiece>& pieces) {
  const Ray unit = c.to_unit.ray(ray);
  const Vec3 o = unit.origin, d = unit.direction;
  if (c.length == 0) return append_piece(c, within_unit_ball(o, d), o, d, pieces);
  const Vec3 end{o.x, o.y, o.z - c.length};
  const Vec3 flat_o{o.x, o.y, 0}, flat_d{d.x, d.y, 0};
  if (flat_d == Vec3{} && !(dot(flat_o, flat_o) < 1)) return;

  // Where the ray passes the two ends' planes, and what lies before, between and behind them.
  Interval before{-kInfinity, -kInfinity}, body = Interval::all(), behind{kInfinity, kInfinity};
  if (d.z != 0) {
    body = {std::min(-o.z / d.z, -end.z / d.z), std::max(-o.z / d.z, -end.z / d.z)};
    before = {-kInfinity, body.min};
    behind = {body.max, kInfinity};
  } else if (o.z < 0 || end.z > 0) {
    before = o.z < 0 ? Interval::all() : Interval{};
    behind = o.z < 0 ? Interval{} : Interval::all();
    body = {};
  }
  const bool upwards = d.z >= 0;
  const Interval tube = flat_d == Vec3{} ? Interval::all() : within_unit_ball(flat_o, flat_d);
  const Interval begin_ball = intersect(within_unit_ball(o, d), upwards ? before : behind);
  const Interval end_ball = intersect(within_unit_ball(end, d), upwards ? behind : before);
  append_piece(c, begin_ball, o, d, pieces);
  append_piece(c, intersect(tube, body), flat_o, flat_d, pieces);
  append_piece(c, end_ball, end, d, pieces);
}

double field_at(const FieldComponent& c, Vec3 p, Vec3* gradient) {
  Vec3 x = c.to_unit.point(p);
  x.z -= std::clamp(x.z, 0.0, c.length);
  const double g = 1 - dot(x, x);
  if (!(g > 0)) return 0;
  if (gradient) *gradient -= 4 * c.strength * g * c.to_unit.covector(x);
  return c.strength * g * g;
}

}  // namespace dioptre
