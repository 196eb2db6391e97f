// SPDX-License-Identifier: Apache-2.0
// The items of a scene's top level, the values of declarations, and #default.
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

DescribedPtr describe(Described value) {
  return std::make_shared<const Described>(std::move(value));
}

DescribedPtr unrendered(Keyword keyword) {
  return describe(UnrenderedValue{static_cast<std::uint16_t>(keyword)});
}

void parse_media_item(Parser& parser) {
  parser.next();
  parse_media(parser);
}

/// Everything of the top level but objects and lights. False if none is next.
bool parse_setting_item(Parser& parser) {
  Scene& scene = parser.scene();
  switch (keyword_at(parser)) {
    case Keyword::kCamera:
      parser.next();
      scene.camera = parse_camera(parser);
      return true;
    case Keyword::kBackground:
      parser.next();
      parse_background(parser);
      return true;
    case Keyword::kFog:
      parser.next();
      scene.atmosphere.fogs.push_back(parse_fog(parser));
      return true;
    case Keyword::kSkySphere:
      parser.next();
      scene.atmosphere.sky_spheres.assign(1, parse_sky_sphere(parser));
      return true;
    case Keyword::kGlobalSettings:
      parser.next();
      parse_global_settings(parser);
      return true;
    case Keyword::kDefault:
      parser.next();
      parse_default(parser);
      return true;
    case Keyword::kMedia:
      parse_media_item(parser);
      return true;
    case Keyword::kRainbow:
      parser.next();
      scene.atmosphere.rainbows.push_back(parse_rainbow(parser));
      return true;
    default:
      // Semicolons and commas between items do no harm.
      return parser.accept(';') || parser.accept(',');
  }
}

/// A described thing by another's name.
DescribedPtr copy_named(Parser& parser) {
  return parser.peek_described() ? parser.take_described() : nullptr;
}

/// Textures may be layered in a declaration.
DescribedPtr parse_texture_value(Parser& parser) {
  TextureId texture = parse_texture(parser);
  while (parser.accept(Keyword::kTexture)) {
    texture = layered(parser, texture, parse_texture(parser));
  }
  return describe(texture);
}

/// What a finish begins as.
Finish default_finish(Parser& parser) {
  const Texture& texture = at(parser.scene().textures, default_texture(parser));
  const auto* layers = std::get_if<LayeredTexture>(&texture.data);
  return layers && !layers->layers.empty() ? layers->layers.back().finish : Finish{};
}

DescribedPtr parse_texture_part(Parser& parser, Keyword keyword) {
  switch (keyword) {
    case Keyword::kTexture:
      parser.next();
      return parse_texture_value(parser);
    case Keyword::kPigment:
      parser.next();
      return describe(parse_pigment(parser, {}));
    case Keyword::kNormal:
      parser.next();
      return describe(parse_normal(parser, {}));
    case Keyword::kFinish:
      parser.next();
      return describe(parse_finish(parser, default_finish(parser)));
    case Keyword::kInterior:
      parser.next();
      return describe(parse_interior(parser, {}));
    case Keyword::kMaterial:
      parser.next();
      return describe(parse_material(parser, {}));
    case Keyword::kInteriorTexture:
      parser.next();
      return parse_texture_value(parser);
    default:
      return nullptr;
  }
}

DescribedPtr parse_map_value(Parser& parser, Keyword keyword) {
  switch (keyword) {
    case Keyword::kColorMap:
    case Keyword::kColourMap:
      parser.next();
      return describe(ColorMapValue{parse_color_map(parser)});
    case Keyword::kPigmentMap:
      parser.next();
      return describe(PigmentMapValue{parse_pigment_map(parser)});
    case Keyword::kNormalMap:
      parser.next();
      return describe(NormalMapValue{parse_normal_map(parser)});
    case Keyword::kSlopeMap:
      parser.next();
      return describe(SlopeMapValue{parse_slope_map(parser)});
    case Keyword::kTextureMap:
      parser.next();
      return describe(TextureMapValue{parse_texture_map(parser)});
    default:
      return nullptr;
  }
}

Affine take_transform(Parser& parser) {
  const auto map = take<Affine>(parser);
  if (!map) parser.fail_expected("the name of a transformation, or '{'");
  return *map;
}

DescribedPtr parse_surroundings(Parser& parser, Keyword keyword) {
  switch (keyword) {
    case Keyword::kTransform:
      parser.next();
      if (parser.at('{')) return describe(parse_transform_block(parser));
      return describe(take_transform(parser));
    case Keyword::kCamera:
      parser.next();
      return describe(parse_camera(parser));
    case Keyword::kFog:
      parser.next();
      return describe(parse_fog(parser));
    case Keyword::kSkySphere:
      parser.next();
      return describe(parse_sky_sphere(parser));
    case Keyword::kMedia:
      parse_media_item(parser);
      return unrendered(keyword);
    case Keyword::kDensity:
      parser.next();
      parse_density(parser);
      return unrendered(keyword);
    case Keyword::kDensityMap:
      parser.next();
      parse_density_map(parser);
      return unrendered(keyword);
    case Keyword::kRainbow:
      parser.next();
      return describe(parse_rainbow(parser));
    default:
      return nullptr;
  }
}

/// The first layer of the default texture, in a copy of it.
void change_default(Parser& parser, Keyword keyword) {
  parser.scene().default_texture = change_texture(parser, keyword, default_texture(parser));
}

}  // namespace

void parse_scene_item(Parser& parser) {
  if (parse_setting_item(parser)) return;
  if (std::optional<Item> item = parse_item(parser)) {
    add_root(parser, std::move(*item));
    return;
  }
  if (const Described* described = parser.peek_described();
      described && std::holds_alternative<Camera>(*described)) {
    parser.scene().camera = *take<Camera>(parser);
    return;
  }
  parser.fail_expected("an object, a light source or another item of a scene");
}

DescribedPtr parse_described(Parser& parser) {
  if (DescribedPtr named = copy_named(parser)) return named;
  const Keyword keyword = keyword_at(parser);
  if (keyword == Keyword::kNotAKeyword) return nullptr;
  if (DescribedPtr part = parse_texture_part(parser, keyword)) return part;
  if (DescribedPtr map = parse_map_value(parser, keyword)) return map;
  if (DescribedPtr thing = parse_surroundings(parser, keyword)) return thing;
  if (std::optional<Item> item = parse_item(parser)) {
    return describe(to_described(std::move(*item)));
  }
  return nullptr;
}

void parse_default(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after #default");
  while (!parser.accept('}')) {
    const Keyword keyword = keyword_at(parser);
    if (parser.accept(Keyword::kTexture)) {
      parser.scene().default_texture = parse_texture(parser);
    } else if (keyword == Keyword::kPigment || keyword == Keyword::kNormal ||
               keyword == Keyword::kFinish) {
      parser.next();
      change_default(parser, keyword);
    } else if (parser.accept(Keyword::kCamera)) {
      parse_camera(parser);
    } else if (parser.accept(Keyword::kRadiosity)) {
      parse_radiosity(parser);
    } else if (!parser.accept(',')) {
      parser.fail_expected("a texture, pigment, normal or finish");
    }
  }
}

}  // namespace dioptre::pov
