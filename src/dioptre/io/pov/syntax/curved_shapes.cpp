// SPDX-License-Identifier: Apache-2.0
// superellipsoid, ovus, lathe, sor and sphere_sweep.
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kMostPoints = std::int64_t{1} << 26;

Superellipsoid parse_superellipsoid(Parser& parser, SourcePosition where) {
  const Vec2 exponents = parser.parse_vec2();
  if (!(exponents.x > 0 && exponents.y > 0)) {
    parser.fail_at(where, "the exponents of a superellipsoid must be greater than 0");
  }
  return {exponents.x, exponents.y};
}

Ovus parse_ovus(Parser& parser, SourcePosition where) {
  Ovus ovus;
  ovus.bottom_radius = parser.parse_float();
  parser.skip_comma();
  ovus.top_radius = parser.parse_float();
  if (ovus.bottom_radius == 0 && ovus.top_radius == 0) {
    parser.fail_at(where, "both radii of the ovus are 0");
  }
  return ovus;
}

/// COUNT, then points (distance from the y axis, height).
std::vector<Vec2> parse_profile(Parser& parser, std::string_view shape, std::int64_t fewest) {
  const SourcePosition where = parser.position();
  const std::int64_t count = parse_whole(parser, 0, kMostPoints);
  if (count < fewest) {
    parser.fail_at(where, "this " + std::string(shape) + " needs at least " +
                              std::to_string(fewest) + " points");
  }
  std::vector<Vec2> points;
  for (std::int64_t i = 0; i < count; ++i) {
    parser.skip_comma();
    const SourcePosition here = parser.position();
    points.push_back(parser.parse_vec2());
    if (points.back().x < 0) {
      parser.fail_at(here, "the distance of a point from the y axis must not be negative");
    }
  }
  return points;
}

Lathe parse_lathe(Parser& parser) {
  Lathe lathe;
  lathe.spline = parse_outline_spline(parser).value_or(OutlineSpline::kLinear);
  parser.skip_comma();
  const SourcePosition where = parser.position();
  lathe.points =
      parse_profile(parser, "lathe", static_cast<std::int64_t>(least_points(lathe.spline, false)));
  if (lathe.spline == OutlineSpline::kBezier && lathe.points.size() % 4 != 0) {
    parser.fail_at(where, "a bezier_spline needs four points for each piece, found " +
                              std::to_string(lathe.points.size()));
  }
  return lathe;
}

Sor parse_sor(Parser& parser) {
  Sor sor;
  sor.points = parse_profile(parser, "sor", 4);
  return sor;
}

SphereSweep parse_sphere_sweep(Parser& parser) {
  SphereSweep sweep;
  if (parser.accept(Keyword::kLinearSpline)) {
    sweep.spline = SphereSweepSpline::kLinear;
  } else if (parser.accept(Keyword::kBSpline)) {
    sweep.spline = SphereSweepSpline::kBSpline;
  } else if (parser.accept(Keyword::kCubicSpline)) {
    sweep.spline = SphereSweepSpline::kCubic;
  } else {
    parser.fail_expected("linear_spline, b_spline or cubic_spline");
  }
  parser.skip_comma();
  const SourcePosition where = parser.position();
  const std::int64_t count = parse_whole(parser, 0, kMostPoints);
  const std::int64_t fewest = sweep.spline == SphereSweepSpline::kLinear ? 2 : 4;
  if (count < fewest) {
    parser.fail_at(where,
                   "this sphere_sweep needs at least " + std::to_string(fewest) + " spheres");
  }
  for (std::int64_t i = 0; i < count; ++i) {
    parser.skip_comma();
    SphereSweep::Sphere sphere;
    sphere.center = parser.parse_vec3();
    parser.skip_comma();
    sphere.radius = parser.parse_float();
    sweep.spheres.push_back(sphere);
  }
  if (parser.accept(Keyword::kTolerance)) sweep.tolerance = parser.parse_float();
  return sweep;
}

}  // namespace

bool parse_curved_shape(Parser& parser, Keyword keyword, Item& item) {
  const auto set = [&](auto shape) {
    item.object.geometry = ShapeData{std::move(shape)};
    return true;
  };
  switch (keyword) {
    case Keyword::kSuperellipsoid:
      return set(parse_superellipsoid(parser, parser.position()));
    case Keyword::kOvus:
      return set(parse_ovus(parser, parser.position()));
    case Keyword::kLathe:
      return set(parse_lathe(parser));
    case Keyword::kSor:
      return set(parse_sor(parser));
    case Keyword::kSphereSweep:
      return set(parse_sphere_sweep(parser));
    default:
      return false;
  }
}

}  // namespace dioptre::pov
