// SPDX-License-Identifier: Apache-2.0
// interior { ... } and material { ... }
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

/// More colours than this cannot be told apart.
constexpr int kMostDispersionSamples = 1000;

bool parse_interior_item(Parser& parser, Interior& interior) {
  switch (keyword_at(parser)) {
    case Keyword::kIor:
      parser.next();
      interior.ior = parser.parse_float();
      interior.has_ior = true;
      return true;
    case Keyword::kDispersion:
      parser.next();
      interior.dispersion = parser.parse_float();
      return true;
    case Keyword::kDispersionSamples:
      parser.next();
      interior.dispersion_samples =
          static_cast<std::uint32_t>(parse_whole(parser, 2, kMostDispersionSamples));
      return true;
    case Keyword::kCaustics:
      parser.next();
      interior.caustics = parser.parse_float();
      return true;
    case Keyword::kFadeDistance:
      parser.next();
      interior.fade_distance = parser.parse_float();
      return true;
    case Keyword::kFadePower:
      parser.next();
      interior.fade_power = parser.parse_float();
      return true;
    case Keyword::kFadeColor:
    case Keyword::kFadeColour:
      parser.next();
      interior.fade_color = parse_light_color(parser);
      return true;
    case Keyword::kRefraction:
      parser.next();
      parser.parse_float();
      parser.warn("'refraction' does nothing: ior alone decides");
      return true;
    case Keyword::kMedia:
      parser.next();
      parse_media(parser);
      return true;
    default:
      return parser.accept(',');
  }
}

void put_on(Parser& parser, TextureId& worn, TextureId texture) {
  worn = worn ? layered(parser, worn, texture) : texture;
}

}  // namespace

InteriorId parse_interior(Parser& parser, InteriorId base) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after interior");
  if (const auto named = take<InteriorId>(parser)) {
    base = *named;
    if (parser.accept('}')) return base;
  }
  Interior interior = base ? at(parser.scene().interiors, base) : Interior{};
  while (!parser.accept('}')) {
    if (!parse_interior_item(parser, interior)) {
      parser.fail_expected("a property of the interior or '}'");
    }
  }
  return append_once(parser.scene().interiors, interior);
}

MaterialValue parse_material(Parser& parser, MaterialValue base) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after material");
  if (const auto named = take<MaterialValue>(parser)) base = *named;
  while (!parser.accept('}')) {
    const Keyword keyword = keyword_at(parser);
    if (parser.accept(Keyword::kTexture)) {
      put_on(parser, base.texture, parse_texture(parser));
    } else if (parser.accept(Keyword::kInteriorTexture)) {
      put_on(parser, base.interior_texture, parse_interior_texture(parser));
    } else if (parser.accept(Keyword::kInterior)) {
      base.interior = parse_interior(parser, base.interior);
    } else if (keyword == Keyword::kPigment || keyword == Keyword::kNormal ||
               keyword == Keyword::kFinish) {
      parser.next();
      base.texture =
          change_texture(parser, keyword, base.texture ? base.texture : default_texture(parser));
    } else if (const auto by = parse_transforms(parser)) {
      if (base.texture) base.texture = transformed(parser, base.texture, *by);
      if (base.interior_texture) {
        base.interior_texture = transformed(parser, base.interior_texture, *by);
      }
    } else if (!parser.accept(',')) {
      parser.fail_expected("a texture, an interior, a transformation or '}'");
    }
  }
  return base;
}

}  // namespace dioptre::pov
