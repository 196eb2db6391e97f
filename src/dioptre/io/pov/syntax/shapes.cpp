// SPDX-License-Identifier: Apache-2.0
// The shapes that are given by a few numbers.
#include <cmath>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

Vec3 vector_and_comma(Parser& parser) {
  const Vec3 v = parser.parse_vec3();
  parser.skip_comma();
  return v;
}

double float_and_comma(Parser& parser) {
  const double v = parser.parse_float();
  parser.skip_comma();
  return v;
}

Sphere parse_sphere(Parser& parser) {
  Sphere sphere;
  sphere.center = vector_and_comma(parser);
  sphere.radius = std::fabs(float_and_comma(parser));
  return sphere;
}

Box parse_box(Parser& parser) {
  Box box;
  box.corner1 = vector_and_comma(parser);
  box.corner2 = vector_and_comma(parser);
  return box;
}

Cylinder parse_cylinder(Parser& parser, SourcePosition where) {
  Cylinder cylinder;
  cylinder.base = vector_and_comma(parser);
  cylinder.cap = vector_and_comma(parser);
  cylinder.radius = std::fabs(float_and_comma(parser));
  cylinder.open = parser.accept(Keyword::kOpen);
  if (cylinder.base == cylinder.cap) {
    parser.fail_at(where, "the ends of the cylinder are the same point", "give it a length");
  }
  return cylinder;
}

Cone parse_cone(Parser& parser, SourcePosition where) {
  Cone cone;
  cone.base = vector_and_comma(parser);
  cone.base_radius = float_and_comma(parser);
  cone.cap = vector_and_comma(parser);
  cone.cap_radius = float_and_comma(parser);
  cone.open = parser.accept(Keyword::kOpen);
  if (cone.base == cone.cap) {
    parser.fail_at(where, "the ends of the cone are the same point", "give it a length");
  }
  return cone;
}

Plane parse_plane(Parser& parser, SourcePosition where) {
  Plane plane;
  plane.normal = vector_and_comma(parser);
  plane.distance = float_and_comma(parser);
  if (plane.normal == Vec3{}) {
    parser.fail_at(where, "the normal of the plane is zero", "give it a direction, such as y");
  }
  return plane;
}

Torus parse_torus(Parser& parser) {
  Torus torus;
  torus.major_radius = float_and_comma(parser);
  torus.minor_radius = float_and_comma(parser);
  return torus;
}

Disc parse_disc(Parser& parser, SourcePosition where) {
  Disc disc;
  disc.center = vector_and_comma(parser);
  disc.normal = vector_and_comma(parser);
  disc.radius = float_and_comma(parser);
  if (parser.at_expression()) disc.hole_radius = float_and_comma(parser);
  if (disc.normal == Vec3{}) {
    parser.fail_at(where, "the normal of the disc is zero", "give it a direction, such as y");
  }
  return disc;
}

Quadric parse_quadric(Parser& parser) {
  Quadric quadric;
  quadric.squares = vector_and_comma(parser);
  quadric.products = vector_and_comma(parser);
  quadric.linear = vector_and_comma(parser);
  quadric.constant = float_and_comma(parser);
  return quadric;
}

/// The coefficients of a polynomial within < and >, as many as its order asks for.
Poly parse_coefficients(Parser& parser, std::uint32_t order) {
  Poly poly;
  poly.order = order;
  const std::size_t count = (order + 1) * (order + 2) * (order + 3) / 6;
  poly.coefficients.reserve(count);
  parser.expect('<', "to begin the coefficients");
  for (std::size_t i = 0; i < count; ++i) poly.coefficients.push_back(float_and_comma(parser));
  parser.expect('>', "after the last coefficient");
  return poly;
}

Poly parse_poly(Parser& parser, SourcePosition where) {
  const double order = float_and_comma(parser);
  if (!(order >= 2 && order < 36)) {
    parser.fail_at(where, "the order of a poly must be from 2 to 35");
  }
  return parse_coefficients(parser, static_cast<std::uint32_t>(order));
}

/// The exponents of x, y and z within `xyz(...)`, as the place of their coefficient in a poly.
std::size_t parse_exponents(Parser& parser, std::uint32_t order) {
  const SourcePosition where = parser.position();
  double exponents[3];
  parser.expect('(', "after xyz");
  for (double& e : exponents) e = std::trunc(float_and_comma(parser));
  parser.expect(')', "after three exponents");
  const auto [x, y, z] = exponents;
  if (!(x >= 0 && y >= 0 && z >= 0 && x + y + z <= order)) {
    parser.fail_at(where, "the exponents of a term must not be negative, nor sum up to more than " +
                              std::to_string(order));
  }
  // Those behind it in the order of poly: with less of x, then less of y, then less of z.
  const auto rest = static_cast<std::size_t>(order - x), last = static_cast<std::size_t>(rest - y);
  return rest * (rest + 1) * (rest + 2) / 6 + last * (last + 1) / 2 +
         static_cast<std::size_t>(last - z);
}

/// `polynomial { ORDER, xyz(X, Y, Z): COEFFICIENT, ... }`: a poly by its terms.
Poly parse_polynomial(Parser& parser, SourcePosition where) {
  const double order = float_and_comma(parser);
  if (!(order >= 2 && order < 36)) {
    parser.fail_at(where, "the order of a polynomial must be from 2 to 35");
  }
  Poly poly;
  poly.order = static_cast<std::uint32_t>(order);
  poly.coefficients.resize((poly.order + 1) * (poly.order + 2) * (poly.order + 3) / 6);
  while (parser.accept(Keyword::kXyz)) {
    const std::size_t place = parse_exponents(parser, poly.order);
    parser.expect(':', "after the exponents of a term");
    poly.coefficients[place] = float_and_comma(parser);
  }
  return poly;
}

bool is_degenerate(const Triangle& t) { return cross(t.b - t.a, t.c - t.a) == Vec3{}; }

/// A degenerate triangle is left out with a warning.
Triangle parse_triangle(Parser& parser, bool smooth, bool& drawn) {
  Triangle t;
  const auto corner = [&] {
    const Vec3 place = vector_and_comma(parser);
    if (smooth) t.normals.push_back(vector_and_comma(parser));
    return place;
  };
  t.a = corner();
  t.b = corner();
  t.c = corner();
  if (is_degenerate(t)) {
    parser.warn("the corners of the triangle lie on one line: it is left out");
    drawn = false;
  }
  return t;
}

}  // namespace

bool parse_shape(Parser& parser, Keyword keyword, Item& item) {
  const SourcePosition where = parser.position();
  Object& object = item.object;
  const auto set = [&](auto shape) {
    object.geometry = ShapeData{std::move(shape)};
    return true;
  };
  switch (keyword) {
    case Keyword::kSphere:
      return set(parse_sphere(parser));
    case Keyword::kBox:
      return set(parse_box(parser));
    case Keyword::kCylinder:
      return set(parse_cylinder(parser, where));
    case Keyword::kCone:
      return set(parse_cone(parser, where));
    case Keyword::kPlane:
      return set(parse_plane(parser, where));
    case Keyword::kTorus:
      return set(parse_torus(parser));
    case Keyword::kDisc:
      return set(parse_disc(parser, where));
    case Keyword::kQuadric:
      return set(parse_quadric(parser));
    case Keyword::kCubic:
      return set(parse_coefficients(parser, 3));
    case Keyword::kQuartic:
      return set(parse_coefficients(parser, 4));
    case Keyword::kPoly:
      return set(parse_poly(parser, where));
    case Keyword::kPolynomial:
      return set(parse_polynomial(parser, where));
    case Keyword::kTriangle:
      return set(parse_triangle(parser, false, item.drawn));
    case Keyword::kSmoothTriangle:
      return set(parse_triangle(parser, true, item.drawn));
    case Keyword::kHeightField:
      parse_height_field(parser, item);
      return true;
    case Keyword::kBicubicPatch:
      return set(parse_bicubic_patch(parser));
    case Keyword::kJuliaFractal:
      return set(parse_julia_fractal(parser));
    default:
      return parse_composite_shape(parser, keyword, item) ||
             parse_function_shape(parser, keyword, item) ||
             parse_curved_shape(parser, keyword, item) ||
             parse_unrendered_shape(parser, keyword, item);
  }
}

}  // namespace dioptre::pov
