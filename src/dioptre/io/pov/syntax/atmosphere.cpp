// SPDX-License-Identifier: Apache-2.0
// background, fog, rainbow and sky_sphere.
#include <algorithm>

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

/// Only the direction of a fog is transformed, not its height (measured).
void transform_fog(Fog& fog, const Affine& by) {
  const Vec3 up = by.vector(fog.up);
  if (length(up) > 0) fog.up = normalize(up);
}

/// Reads the contents of one rainbow.
class RainbowParser {
 public:
  explicit RainbowParser(Parser& parser) : parser_(parser) {}

  /// Up to the closing brace, which is taken.
  void parse() {
    while (!parser_.accept('}')) {
      if (const auto named = pov::take<Rainbow>(parser_)) {
        rainbow_ = *named;
      } else if (const auto by = parse_transforms(parser_)) {
        rainbow_.direction = by->vector(rainbow_.direction);
        rainbow_.up = by->vector(rainbow_.up);
      } else if (!parse_band() && !parse_arc() && !parser_.accept(',')) {
        parser_.fail_expected("a property of the rainbow or '}'");
      }
    }
    if (!has_arc_) rainbow_.falloff_angle = rainbow_.arc_angle;
  }

  Rainbow take() { return std::move(rainbow_); }

 private:
  bool number(double& value) {
    parser_.next();
    value = parser_.parse_float();
    return true;
  }

  bool parse_band() {
    switch (keyword_at(parser_)) {
      case Keyword::kAngle:
        return number(rainbow_.angle);
      case Keyword::kWidth:
        return number(rainbow_.width);
      case Keyword::kDistance:
        return number(rainbow_.distance);
      case Keyword::kJitter:
        return number(rainbow_.jitter);
      case Keyword::kColorMap:
      case Keyword::kColourMap:
        parser_.next();
        rainbow_.colors = parse_color_map(parser_);
        return true;
      case Keyword::kColor:
      case Keyword::kColour:
        parser_.next();
        rainbow_.colors.assign(1, {0, parser_.parse_color()});
        return true;
      default:
        return false;
    }
  }

  bool parse_arc() {
    switch (keyword_at(parser_)) {
      case Keyword::kDirection:
        parser_.next();
        rainbow_.direction = parser_.parse_vec3();
        return true;
      case Keyword::kUp:
        parser_.next();
        rainbow_.up = parser_.parse_vec3();
        return true;
      case Keyword::kArcAngle:
        has_arc_ = true;
        return number(rainbow_.arc_angle);
      case Keyword::kFalloffAngle:
        return number(rainbow_.falloff_angle);
      default:
        return false;
    }
  }

  Parser& parser_;
  Rainbow rainbow_;
  bool has_arc_ = false;
};

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

Rainbow parse_rainbow(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after rainbow");
  RainbowParser rainbow(parser);
  rainbow.parse();
  return rainbow.take();
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
    // Dimmed by transmit, in mirrors too; filter does nothing (measured).
    atmosphere.background = color.color * std::max(0.0f, 1 - color.transmit);
    atmosphere.background_transmit = color.transmit;
    parser.skip_comma();
  }
}

}  // namespace dioptre::pov
