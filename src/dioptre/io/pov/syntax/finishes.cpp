// SPDX-License-Identifier: Apache-2.0
// finish { ... }
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

/// Reads the contents of one finish.
class FinishParser {
 public:
  FinishParser(Parser& parser, const Finish& base) : parser_(parser), finish_(base) {}

  Finish parse() {
    while (!parser_.accept('}')) {
      if (const auto named = take<Finish>(parser_)) {
        finish_ = *named;
      } else if (!parser_.accept(',') && !parse_light() && !parse_mirror() && !parse_old()) {
        parser_.fail_expected("a property of the finish or '}'");
      }
    }
    return finish_;
  }

 private:
  bool parse_light() {
    switch (keyword_at(parser_)) {
      case Keyword::kAmbient:
        return color(finish_.ambient);
      case Keyword::kEmission:
        return color(finish_.emission);
      case Keyword::kDiffuse:
        return diffuse();
      case Keyword::kBrilliance:
        return number(finish_.brilliance);
      case Keyword::kCrand:
        return number(finish_.crand);
      case Keyword::kPhong:
        return albedo_number(finish_.phong, finish_.phong_albedo);
      case Keyword::kPhongSize:
        return number(finish_.phong_size);
      case Keyword::kSpecular:
        return albedo_number(finish_.specular, finish_.specular_albedo);
      case Keyword::kRoughness:
        return number(finish_.roughness);
      case Keyword::kMetallic:
        return optional_number(finish_.metallic);
      default:
        return false;
    }
  }

  bool parse_mirror() {
    switch (keyword_at(parser_)) {
      case Keyword::kReflection:
        parser_.next();
        parse_reflection();
        return true;
      case Keyword::kReflectionExponent:
        return number(finish_.reflection_exponent);
      case Keyword::kConserveEnergy:
        parser_.next();
        finish_.conserve_energy = parser_.parse_flag();
        return true;
      case Keyword::kIrid:
        parser_.next();
        parse_irid();
        return true;
      case Keyword::kSubsurface:
        parser_.next();
        parse_subsurface();
        return true;
      default:
        return false;
    }
  }

  /// Properties that have moved to interior. Of these ior still counts (measured).
  bool parse_old() {
    switch (keyword_at(parser_)) {
      case Keyword::kIor:
        number(finish_.ior);
        parser_.warn("'ior' has moved from finish to interior");
        return true;
      case Keyword::kRefraction:
      case Keyword::kCaustics:
      case Keyword::kFadeDistance:
      case Keyword::kFadePower: {
        const std::string name(text_of(keyword_at(parser_)));
        parser_.next();
        parser_.parse_float();
        parser_.warn("'" + name + "' in a finish does nothing", "write it in an interior");
        return true;
      }
      default:
        return false;
    }
  }

  bool color(Color& value) {
    parser_.next();
    value = parse_light_color(parser_);
    return true;
  }
  bool number(double& value) {
    parser_.next();
    value = parser_.parse_float();
    return true;
  }
  bool optional_number(double& value) {
    parser_.next();
    value = parser_.at_expression() ? parser_.parse_float() : 1;
    return true;
  }
  bool albedo_number(double& value, bool& albedo) {
    parser_.next();
    albedo = parser_.accept(Keyword::kAlbedo);
    value = parser_.parse_float();
    return true;
  }

  bool diffuse() {
    albedo_number(finish_.diffuse, finish_.diffuse_albedo);
    if (parser_.accept(',') || parser_.at_expression()) finish_.diffuse_back = parser_.parse_float();
    return true;
  }

  bool at_color() { return parser_.at_expression() || parser_.at_color(); }

  void parse_reflection() {
    if (!parser_.accept('{')) {
      finish_.reflection_max = finish_.reflection_min = parse_light_color(parser_);
      return;
    }
    const Parser::Nesting nesting(parser_);
    finish_.reflection_min = finish_.reflection_max = parse_light_color(parser_);
    const bool both = parser_.accept(',') || at_color();
    if (both) finish_.reflection_max = parse_light_color(parser_);
    while (!parser_.accept('}')) {
      if (!parse_reflection_item()) parser_.fail_expected("a property of the reflection or '}'");
    }
    // A single value with fresnel is the upper end of a range that begins at 0.
    if (!both && finish_.reflection_fresnel) finish_.reflection_min = {};
  }

  bool parse_reflection_item() {
    switch (keyword_at(parser_)) {
      case Keyword::kFalloff:
        return number(finish_.reflection_falloff);
      case Keyword::kExponent:
        return number(finish_.reflection_exponent);
      case Keyword::kMetallic:
        return optional_number(finish_.reflection_metallic);
      case Keyword::kFresnel:
        parser_.next();
        finish_.reflection_fresnel = parser_.parse_flag();
        return true;
      default:
        return parser_.accept(',');
    }
  }

  void parse_irid() {
    const Parser::Nesting nesting(parser_);
    parser_.expect('{', "after irid");
    finish_.irid = parser_.parse_float();
    while (!parser_.accept('}')) {
      if (parser_.accept(Keyword::kThickness)) {
        finish_.irid_thickness = parser_.parse_float();
      } else if (parser_.accept(Keyword::kTurbulence)) {
        finish_.irid_turbulence = parser_.parse_float();
      } else if (!parser_.accept(',')) {
        parser_.fail_expected("thickness, turbulence or '}'");
      }
    }
  }

  void parse_subsurface() {
    parser_.expect('{', "after subsurface");
    parser_.not_rendered("subsurface");
    while (!parser_.accept('}')) {
      if (parser_.accept(Keyword::kTranslucency)) {
        parser_.parse_color();
      } else if (!parser_.accept(',')) {
        parser_.fail_expected("translucency or '}'");
      }
    }
  }

  Parser& parser_;
  Finish finish_;
};

}  // namespace

Finish parse_finish(Parser& parser, const Finish& base) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after finish");
  return FinishParser(parser, base).parse();
}

}  // namespace dioptre::pov
