// SPDX-License-Identifier: Apache-2.0
// background, fog and sky_sphere.
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

bool parse_fog_item(Parser& parser, Fog& fog) {
  const auto number = [&](double& value) {
    parser.next();
    value = parser.parse_float();
    return true;
  };
  switch (keyword_at(parser)) {
    case Keyword::kFogType:
      parser.next();
      fog.ground = parse_whole(parser, 1, 2) == 2;
      return true;
    case Keyword::kDistance:
      return number(fog.distance);
    case Keyword::kFogOffset:
      return number(fog.offset);
    case Keyword::kFogAlt:
      return number(fog.altitude);
    case Keyword::kTurbDepth:
      return number(fog.turb_depth);
    case Keyword::kOmega:
      return number(fog.omega);
    case Keyword::kLambda:
      return number(fog.lambda);
    case Keyword::kTurbulence:
      parser.next();
      fog.turbulence = parser.parse_vec3();
      return true;
    case Keyword::kOctaves:
      parser.next();
      fog.octaves = static_cast<std::uint32_t>(parse_whole(parser, 1, 10));
      return true;
    case Keyword::kUp:
      parser.next();
      fog.up = parser.parse_vec3();
      if (length(fog.up) > 0) fog.up = normalize(fog.up);
      return true;
    default:
      return parser.accept(',');
  }
}

void transform_fog(Fog& fog, const Affine& by) {
  const double before = length(fog.up);
  const Vec3 up = by.vector(fog.up);
  const double after = length(up);
  if (before == 0 || after == 0) return;
  const Vec3 base = by.point(fog.up * (fog.offset / before));
  const double scale = after / before;
  fog.up = up / after;
  fog.offset = dot(base, fog.up);
  fog.altitude *= scale;
}

}  // namespace

Fog parse_fog(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after fog");
  Fog fog;
  if (const auto named = take<Fog>(parser)) fog = *named;
  while (!parser.accept('}')) {
    if (const auto by = parse_transforms(parser)) {
      transform_fog(fog, *by);
    } else if (parse_fog_item(parser, fog)) {
      continue;
    } else if (parser.at_color()) {
      fog.color = parser.parse_color();
    } else {
      parser.fail_expected("a property of the fog or '}'");
    }
  }
  return fog;
}

SkySphere parse_sky_sphere(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after sky_sphere");
  SkySphere sky;
  if (const auto named = take<SkySphere>(parser)) sky = *named;
  while (!parser.accept('}')) {
    if (parser.accept(Keyword::kPigment)) {
      sky.pigments.push_back(parse_pigment(parser, {}));
    } else if (parser.accept(Keyword::kEmission)) {
      sky.emission = parse_light_color(parser);
    } else if (const auto by = parse_transforms(parser)) {
      sky.transform = then(sky.transform, *by);
    } else if (!parser.accept(',')) {
      parser.fail_expected("a pigment, a transformation or '}'");
    }
  }
  return sky;
}

void parse_background(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after background");
  Atmosphere& atmosphere = parser.scene().atmosphere;
  while (!parser.accept('}')) {
    const PigmentColor color = parser.parse_color();
    atmosphere.background = color.color;
    atmosphere.background_transmit = color.transmit;
    parser.skip_comma();
  }
}

}  // namespace dioptre::pov
