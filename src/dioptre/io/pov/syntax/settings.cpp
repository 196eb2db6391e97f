// SPDX-License-Identifier: Apache-2.0
// global_settings { ... }
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

void parse_assumed_gamma(Parser& parser, Settings& settings) {
  if (parser.accept(Keyword::kSrgb)) {
    settings.assumed_gamma = 0;
    return;
  }
  const SourcePosition where = parser.position();
  settings.assumed_gamma = parser.parse_float();
  if (!(settings.assumed_gamma > 0)) {
    parser.fail_at(where, "assumed_gamma must be over 0", "1.0 is the usual value");
  }
}

void parse_subsurface(Parser& parser) {
  parser.expect('{', "after subsurface");
  parser.not_rendered("subsurface");
  while (!parser.accept('}')) {
    if (parser.accept(Keyword::kSamples)) {
      parser.parse_float();
      if (parser.accept(',')) parser.parse_float();
    } else if (parser.accept(Keyword::kRadiosity)) {
      parser.parse_flag();
    } else if (!parser.accept(',')) {
      parser.fail_expected("samples, radiosity or '}'");
    }
  }
}

bool parse_setting(Parser& parser, Settings& settings) {
  switch (keyword_at(parser)) {
    case Keyword::kAssumedGamma:
      parser.next();
      parse_assumed_gamma(parser, settings);
      return true;
    case Keyword::kAmbientLight:
      parser.next();
      settings.ambient_light = parse_light_color(parser);
      return true;
    case Keyword::kAdcBailout:
      parser.next();
      settings.adc_bailout = parser.parse_setting_float();
      return true;
    case Keyword::kMaxTraceLevel:
      parser.next();
      settings.max_trace_level = static_cast<std::uint32_t>(parse_whole(parser, 1, 256));
      return true;
    case Keyword::kNoiseGenerator:
      parser.next();
      settings.noise_generator = static_cast<std::uint32_t>(parse_whole(parser, 1, 3));
      return true;
    case Keyword::kNumberOfWaves:
      parser.next();
      settings.number_of_waves = static_cast<std::uint32_t>(parse_whole(parser, 1, 1000));
      return true;
    case Keyword::kIridWavelength:
      parser.next();
      settings.irid_wavelength = parse_light_color(parser);
      return true;
    case Keyword::kMaxIntersections:
    case Keyword::kMmPerUnit:
      parser.next();
      parser.parse_float();
      return true;
    case Keyword::kCharset:
      parser.next();
      if (!parser.accept(Keyword::kAscii) && !parser.accept(Keyword::kUtf8) &&
          !parser.accept(Keyword::kSys)) {
        parser.fail_expected("ascii, utf8 or sys");
      }
      return true;
    case Keyword::kHfGray16: {
      const SourcePosition where = parser.position();
      parser.next();
      parser.parse_flag();
      parser.warn_at(where, "hf_gray_16 does nothing",
                     "ask for a grey image of 16 bits on the command line");
      return true;
    }
    case Keyword::kRadiosity:
      parser.next();
      parse_radiosity(parser);
      return true;
    case Keyword::kPhotons:
      parser.next();
      parse_photons(parser);
      return true;
    case Keyword::kSubsurface:
      parser.next();
      parse_subsurface(parser);
      return true;
    default:
      return parser.accept(',');
  }
}

}  // namespace

void parse_global_settings(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after global_settings");
  while (!parser.accept('}')) {
    if (!parse_setting(parser, parser.scene().settings)) {
      parser.fail_expected("a global setting or '}'");
    }
  }
}

}  // namespace dioptre::pov
