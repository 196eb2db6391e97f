// SPDX-License-Identifier: Apache-2.0
// Transformations, turbulence and warps of patterns.
#include <cmath>

#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

std::uint32_t parse_octaves(Parser& parser) {
  return static_cast<std::uint32_t>(parse_whole(parser, 1, 10));
}

/// The turbulence of the keyword, which is always the first in the list.
Turbulence& keyword_turbulence(std::vector<Warp>& warps) {
  if (warps.empty() || !std::holds_alternative<Turbulence>(warps.front())) {
    warps.insert(warps.begin(), Turbulence{});
  }
  return std::get<Turbulence>(warps.front());
}

/// octaves, omega or lambda.
bool parse_spectrum(Parser& parser, Turbulence& turbulence) {
  if (parser.accept(Keyword::kOctaves)) {
    turbulence.octaves = parse_octaves(parser);
  } else if (parser.accept(Keyword::kOmega)) {
    turbulence.omega = parser.parse_float();
  } else if (parser.accept(Keyword::kLambda)) {
    turbulence.lambda = parser.parse_float();
  } else {
    return false;
  }
  return true;
}

RepeatWarp parse_repeat(Parser& parser) {
  RepeatWarp warp;
  const Vec3 direction = parser.parse_vec3();
  int axes = 0;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) continue;
    ++axes;
    warp.axis = axis;
    warp.width = std::fabs(direction[axis]);
  }
  if (axes != 1) parser.fail("a repeat warp needs a vector along one axis", "such as 2*x");
  for (;;) {
    if (parser.accept(Keyword::kOffset)) {
      warp.offset = parser.parse_vec3();
    } else if (parser.accept(Keyword::kFlip)) {
      const Vec3 flip = parser.parse_vec3();
      for (std::size_t i = 0; i < 3; ++i) warp.flip[i] = flip[i] != 0 ? -1 : 1;
    } else if (!parser.accept(',')) {
      return warp;
    }
  }
}

BlackHoleWarp parse_black_hole(Parser& parser) {
  BlackHoleWarp warp;
  warp.center = parser.parse_vec3();
  parser.skip_comma();
  warp.radius = parser.parse_float();
  for (;;) {
    if (parser.accept(Keyword::kStrength)) {
      warp.strength = parser.parse_float();
    } else if (parser.accept(Keyword::kFalloff)) {
      warp.falloff = parser.parse_float();
    } else if (parser.accept(Keyword::kInverse)) {
      warp.inverse = true;
    } else if (parser.accept(Keyword::kRepeat)) {
      warp.repeat = parser.parse_vec3();
      warp.repeats = true;
    } else if (parser.accept(Keyword::kTurbulence)) {
      warp.turbulence = parser.parse_vec3();
    } else if (!parser.accept(',')) {
      return warp;
    }
  }
}

MappingWarp parse_mapping(Parser& parser, MappingWarp::Kind kind) {
  MappingWarp warp;
  warp.kind = kind;
  if (kind == MappingWarp::Kind::kPlanar && parser.at_expression()) {
    warp.orientation = parser.parse_vec3();
    parser.skip_comma();
    warp.distance_exponent = parser.parse_float();
  }
  for (;;) {
    if (parser.accept(Keyword::kOrientation)) {
      warp.orientation = parser.parse_vec3();
    } else if (parser.accept(Keyword::kDistExp)) {
      warp.distance_exponent = parser.parse_float();
    } else if (parser.accept(Keyword::kMajorRadius)) {
      warp.major_radius = parser.parse_float();
    } else if (!parser.accept(',')) {
      return warp;
    }
  }
}

Turbulence parse_turbulence(Parser& parser) {
  Turbulence turbulence;
  turbulence.amount = parser.parse_vec3();
  while (parse_spectrum(parser, turbulence) || parser.accept(',')) {
  }
  return turbulence;
}

/// The block of `warp`.
void parse_warp(Parser& parser, std::vector<Warp>& warps) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after warp");
  using Kind = MappingWarp::Kind;
  if (parser.accept(Keyword::kRepeat)) {
    warps.push_back(parse_repeat(parser));
  } else if (parser.accept(Keyword::kBlackHole)) {
    warps.push_back(parse_black_hole(parser));
  } else if (parser.accept(Keyword::kTurbulence)) {
    // The first place belongs to the keyword.
    if (warps.empty()) warps.push_back(TransformWarp{});
    warps.push_back(parse_turbulence(parser));
  } else if (parser.accept(Keyword::kPlanar)) {
    warps.push_back(parse_mapping(parser, Kind::kPlanar));
  } else if (parser.accept(Keyword::kSpherical)) {
    warps.push_back(parse_mapping(parser, Kind::kSpherical));
  } else if (parser.accept(Keyword::kCylindrical)) {
    warps.push_back(parse_mapping(parser, Kind::kCylindrical));
  } else if (parser.accept(Keyword::kToroidal)) {
    warps.push_back(parse_mapping(parser, Kind::kToroidal));
  } else if (parser.accept(Keyword::kCubic) || parser.accept(Keyword::kCube)) {
    warps.push_back(parse_mapping(parser, Kind::kCubic));
  } else if (const auto by = parse_transforms(parser)) {
    add_transform(warps, *by);
  } else {
    parser.fail_expected("a kind of warp");
  }
  parser.expect('}', "after the warp");
}

}  // namespace

void add_transform(std::vector<Warp>& warps, const Affine& by) {
  auto* last = warps.empty() ? nullptr : std::get_if<TransformWarp>(&warps.back());
  if (last) {
    last->transform = then(last->transform, by);
  } else {
    warps.push_back(TransformWarp{by});
  }
}

bool parse_warp_modifier(Parser& parser, std::vector<Warp>& warps) {
  if (const auto by = parse_transforms(parser)) {
    add_transform(warps, *by);
    return true;
  }
  if (parser.accept(Keyword::kWarp)) {
    parse_warp(parser, warps);
    return true;
  }
  if (parser.accept(Keyword::kTurbulence)) {
    keyword_turbulence(warps).amount = parser.parse_vec3();
    return true;
  }
  const Keyword keyword = keyword_at(parser);
  if (keyword == Keyword::kOctaves || keyword == Keyword::kOmega || keyword == Keyword::kLambda) {
    return parse_spectrum(parser, keyword_turbulence(warps));
  }
  return false;
}

}  // namespace dioptre::pov
