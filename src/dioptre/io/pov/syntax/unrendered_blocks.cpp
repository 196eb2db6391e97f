// SPDX-License-Identifier: Apache-2.0
// Blocks that are read and checked but not rendered yet: media, density, photons, radiosity.
#include <initializer_list>

#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

bool accept_any(Parser& parser, std::initializer_list<Keyword> keywords) {
  for (const Keyword keyword : keywords) {
    if (parser.accept(keyword)) return true;
  }
  return false;
}

void skip_floats(Parser& parser) {
  parser.parse_float();
  while (parser.accept(',')) parser.parse_float();
}

void parse_scattering(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after scattering");
  parser.parse_float();
  parser.skip_comma();
  parser.parse_color();
  while (!parser.accept('}')) {
    if (accept_any(parser, {Keyword::kEccentricity, Keyword::kExtinction})) {
      parser.parse_float();
    } else if (!parser.accept(',')) {
      parser.fail_expected("eccentricity, extinction or '}'");
    }
  }
}

bool parse_media_item(Parser& parser) {
  if (accept_any(parser, {Keyword::kIntervals, Keyword::kRatio, Keyword::kConfidence,
                          Keyword::kVariance, Keyword::kMethod, Keyword::kJitter})) {
    parser.parse_float();
  } else if (accept_any(parser, {Keyword::kAaLevel, Keyword::kAaThreshold})) {
    parser.parse_float();
  } else if (parser.accept(Keyword::kSamples)) {
    skip_floats(parser);
  } else if (accept_any(parser, {Keyword::kAbsorption, Keyword::kEmission})) {
    parser.parse_color();
  } else if (parser.accept(Keyword::kScattering)) {
    parse_scattering(parser);
  } else if (parser.accept(Keyword::kDensity)) {
    parse_density(parser);
  } else if (parser.accept(Keyword::kCollect)) {
    parser.parse_flag();
  } else {
    return parse_transforms(parser).has_value() || parser.accept(',');
  }
  return true;
}

bool take_unrendered(Parser& parser, Keyword keyword) {
  const Described* described = parser.peek_described();
  const auto* thing = described ? std::get_if<UnrenderedValue>(described) : nullptr;
  if (!thing || thing->keyword != static_cast<std::uint16_t>(keyword)) return false;
  parser.take_described();
  return true;
}

void parse_density_contents(Parser& parser, char close);

bool parse_density_item(Parser& parser, Pattern& pattern) {
  if (take_unrendered(parser, Keyword::kDensity)) return true;
  if (accept_any(parser, {Keyword::kColorMap, Keyword::kColourMap})) {
    parse_color_map(parser);
  } else if (parser.accept(Keyword::kDensityMap)) {
    parse_density_map(parser);
  } else if (parser.accept(Keyword::kAverage)) {
    return true;
  } else if (parser.accept(Keyword::kDensity)) {
    parse_density(parser);
  } else if (const auto block = parse_pattern_kind(parser, pattern)) {
    if (block->in_braces) {
      while (!parser.accept('}')) {
        if (!parse_density_item(parser, pattern)) parser.fail_expected("a density or '}'");
      }
    }
  } else if (parser.at_color()) {
    parser.parse_color();
  } else {
    return parse_pattern_modifier(parser, pattern) || parser.accept(',');
  }
  return true;
}

void parse_density_contents(Parser& parser, char close) {
  const Parser::Nesting nesting(parser);
  Pattern pattern;
  while (!parser.at(close)) {
    if (!parse_density_item(parser, pattern)) {
      parser.fail_expected("a density, a modifier or the end of the density");
    }
  }
}

}  // namespace

void parse_media(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.not_rendered("media");
  parser.expect('{', "after media");
  while (!parser.accept('}')) {
    if (!take_unrendered(parser, Keyword::kMedia) && !parse_media_item(parser)) {
      parser.fail_expected("a property of the media or '}'");
    }
  }
}

void parse_density_map(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after density_map");
  take_unrendered(parser, Keyword::kDensityMap);
  while (parser.accept('[')) {
    parser.parse_float();
    parser.skip_comma();
    parse_density_contents(parser, ']');
    parser.expect(']', "after the entry of the map");
    parser.skip_comma();
  }
  parser.expect('}', "after the map");
}

void parse_density(Parser& parser) {
  parser.expect('{', "after density");
  parse_density_contents(parser, '}');
  parser.next();
}

void parse_photons(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.not_rendered("photons");
  parser.expect('{', "after photons");
  while (!parser.accept('}')) {
    if (accept_any(parser, {Keyword::kTarget, Keyword::kRefraction, Keyword::kReflection,
                            Keyword::kCollect, Keyword::kPassThrough, Keyword::kAreaLight})) {
      parser.parse_flag();
    } else if (accept_any(parser, {Keyword::kSpacing, Keyword::kCount, Keyword::kMaxTraceLevel,
                                   Keyword::kAdcBailout, Keyword::kAutostop,
                                   Keyword::kExpandThresholds, Keyword::kGather, Keyword::kJitter,
                                   Keyword::kMedia, Keyword::kRadius})) {
      if (parser.at_expression()) skip_floats(parser);
    } else if (accept_any(parser, {Keyword::kSaveFile, Keyword::kLoadFile})) {
      parser.parse_string();
    } else if (!parser.accept(',')) {
      parser.fail_expected("a setting of the photons or '}'");
    }
  }
}

void parse_radiosity(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.not_rendered("radiosity");
  parser.expect('{', "after radiosity");
  while (!parser.accept('}')) {
    if (accept_any(parser, {Keyword::kAlwaysSample, Keyword::kMedia, Keyword::kNormal,
                            Keyword::kSubsurface})) {
      parser.parse_flag();
    } else if (accept_any(parser,
                          {Keyword::kAdcBailout, Keyword::kBrightness, Keyword::kErrorBound,
                           Keyword::kGrayThreshold, Keyword::kLowErrorFactor, Keyword::kMaxSample,
                           Keyword::kMaximumReuse, Keyword::kMinimumReuse, Keyword::kPretraceEnd,
                           Keyword::kPretraceStart, Keyword::kRecursionLimit})) {
      parser.parse_float();
    } else if (accept_any(parser, {Keyword::kCount, Keyword::kNearestCount})) {
      skip_floats(parser);
    } else if (accept_any(parser, {Keyword::kSaveFile, Keyword::kLoadFile})) {
      parser.parse_string();
    } else if (const SourcePosition where = parser.position();
               parser.accept_word("distance_maximum")) {
      parser.forgive(where, "distance_maximum is no setting of POV-Ray 3.7: ignored",
                     "leave it out");
      parser.parse_float();
    } else if (!parser.accept(',')) {
      parser.fail_expected("a setting of the radiosity or '}'");
    }
  }
}

}  // namespace dioptre::pov
