// SPDX-License-Identifier: Apache-2.0
// light_source { ... } and light_group { ... }
#include <cmath>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kMostSamples = 1 << 12;

/// Reads the contents of one light source.
class LightParser {
 public:
  LightParser(Parser& parser, Item& item, Light& light)
      : parser_(parser), item_(item), light_(light) {}

  /// Up to the closing brace, which is taken.
  void parse() {
    while (!parser_.accept('}')) {
      if (parser_.accept(',') || parse_kind() || parse_area() || parse_reach()) continue;
      if (const auto by = parse_transforms(parser_)) {
        if (item_.drawn) transform_object(parser_, item_.object, *by);
        transform_light(light_, *by);
      } else {
        parser_.fail_expected("a light source modifier or '}'");
      }
    }
  }

 private:
  bool parse_kind() {
    switch (keyword_at(parser_)) {
      case Keyword::kSpotlight:
        parser_.next();
        light_.kind = Light::Kind::kSpotlight;
        return true;
      case Keyword::kCylinder:
        parser_.next();
        light_.kind = Light::Kind::kCylinder;
        return true;
      case Keyword::kParallel:
        parser_.next();
        light_.parallel = true;
        return true;
      case Keyword::kShadowless:
        parser_.next();
        light_.shadowless = true;
        return true;
      case Keyword::kPointAt:
        parser_.next();
        light_.point_at = parser_.parse_vec3();
        return true;
      case Keyword::kRadius:
        return number(light_.radius);
      case Keyword::kFalloff:
        return number(light_.falloff);
      case Keyword::kTightness:
        return number(light_.tightness);
      case Keyword::kLooksLike:
        parser_.next();
        parse_looks_like();
        return true;
      case Keyword::kProjectedThrough:
        parser_.next();
        parse_projected_through();
        return true;
      default:
        return false;
    }
  }

  bool parse_area() {
    AreaLight& area = light_.area;
    switch (keyword_at(parser_)) {
      case Keyword::kAreaLight:
        parser_.next();
        light_.is_area = true;
        area.axis1 = parser_.parse_vec3();
        parser_.skip_comma();
        area.axis2 = parser_.parse_vec3();
        parser_.skip_comma();
        area.size1 = static_cast<std::uint32_t>(parse_whole(parser_, 1, kMostSamples));
        parser_.skip_comma();
        area.size2 = static_cast<std::uint32_t>(parse_whole(parser_, 1, kMostSamples));
        return true;
      case Keyword::kAdaptive:
        parser_.next();
        area.adaptive = static_cast<std::int32_t>(parse_whole(parser_, 0, 32));
        return true;
      case Keyword::kAreaIllumination:
        return flag(area.illumination);
      case Keyword::kJitter:
        return flag(area.jitter);
      case Keyword::kCircular:
        return flag(area.circular);
      case Keyword::kOrient:
        return flag(area.orient);
      default:
        return false;
    }
  }

  bool parse_reach() {
    switch (keyword_at(parser_)) {
      case Keyword::kFadeDistance:
        return number(light_.fade_distance);
      case Keyword::kFadePower:
        return number(light_.fade_power);
      case Keyword::kMediaAttenuation:
        return flag(light_.media_attenuation);
      case Keyword::kMediaInteraction:
        return flag(light_.media_interaction);
      case Keyword::kPhotons:
        parser_.next();
        parse_photons(parser_);
        return true;
      default:
        return false;
    }
  }

  bool number(double& value) {
    parser_.next();
    value = parser_.parse_float();
    return true;
  }
  bool flag(bool& value) {
    parser_.next();
    value = parser_.parse_flag();
    return true;
  }

  /// An object about the light, which does not stand in its way.
  void parse_looks_like() {
    const Parser::Nesting nesting(parser_);
    parser_.expect('{', "after looks_like");
    Item shown = parse_object(parser_);
    parse_object_modifiers(parser_, shown);
    if (!shown.drawn) return;
    shown.object.no_shadow = true;
    if (!shown.object.texture) shown.object.texture = default_texture(parser_);
    transform_object(parser_, shown.object, translation(light_.location));
    item_.object = std::move(shown.object);
    item_.drawn = true;
  }

  void parse_projected_through() {
    const Parser::Nesting nesting(parser_);
    parser_.expect('{', "after projected_through");
    Item window = parse_object(parser_);
    parse_object_modifiers(parser_, window);
    if (!window.drawn) return;
    window.object.no_shadow = true;
    light_.projected_through = add_part(parser_, std::move(window.object), window.where);
  }

  Parser& parser_;
  Item& item_;
  Light& light_;
};

}  // namespace

void transform_light(Light& light, const Affine& by) {
  light.location = by.point(light.location);
  light.point_at = by.point(light.point_at);
  light.area.axis1 = by.vector(light.area.axis1);
  light.area.axis2 = by.vector(light.area.axis2);
}

Item parse_light(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after light_source");
  Item item;
  item.drawn = false;
  Light light;
  const Described* named = parser.peek_described();
  if (const auto* value = named ? std::get_if<LightsValue>(named) : nullptr;
      value && value->lights.size() == 1) {
    light = value->lights[0];
    item.drawn = value->object.has_value();
    if (value->object) item.object = *value->object;
    parser.take_described();
  } else {
    light.location = parser.parse_vec3();
    parser.skip_comma();
    light.color = parse_light_color(parser);
  }
  LightParser(parser, item, light).parse();
  item.lights.push_back(light);
  return item;
}

/// Objects, and the lights that shine on nothing else. In groups within groups each object belongs
/// to the innermost one (measured).
Item parse_light_group(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after light_group");
  Item item;
  item.drawn = false;
  Csg members;
  bool global_lights = false;
  while (!parser.accept('}')) {
    if (parser.accept(Keyword::kGlobalLights)) {
      global_lights = parser.parse_flag();
    } else if (parser.accept(Keyword::kPhotons)) {
      parse_photons(parser);
    } else if (const auto by = parse_transforms(parser)) {
      item.object.geometry = members;
      item.drawn = !members.children.empty();
      transform_item(parser, item, *by);
    } else if (auto member = parse_item(parser)) {
      item.lights.insert(item.lights.end(), member->lights.begin(), member->lights.end());
      if (member->drawn) {
        members.children.push_back(add_part(parser, std::move(member->object), member->where));
      }
    } else if (!parser.accept(',')) {
      parser.fail_expected("an object, a light source, a transformation or '}'");
    }
  }
  item.drawn = !members.children.empty();
  if (!item.drawn) {
    item.lights.clear();
    return item;
  }
  // A group's number is that of the parts there are at its end: no two groups end with the same.
  item.object.light_group = static_cast<std::uint32_t>(parser.scene().objects.size());
  item.object.global_lights = global_lights;
  for (Light& light : item.lights) {
    if (light.group == 0) light.group = item.object.light_group;
  }
  item.object.geometry = std::move(members);
  return item;
}

}  // namespace dioptre::pov
