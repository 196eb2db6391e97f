// SPDX-License-Identifier: Apache-2.0
// Maps from the values of a pattern to colours, pigments, normals, slopes and textures.
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

/// In `[a b color A color B]` the second position, in `[a color A]` nothing. A name may stand for
/// either, so the colour may be read already.
struct AfterPosition {
  std::optional<double> position;
  std::optional<PigmentColor> color;
};

AfterPosition parse_after_position(Parser& parser) {
  AfterPosition found;
  const Token& token = parser.peek();
  const bool name = token.kind == Token::Kind::kName && keyword_at(parser) == Keyword::kNotAKeyword;
  if (token.kind == Token::Kind::kNumber) {
    found.position = parser.parse_float();
  } else if (name) {
    const Numeric n = parser.parse_numeric();
    if (n.size == 1) {
      found.position = n.v[0];
      return found;
    }
    const auto f = [&](std::size_t i) { return i < n.size ? static_cast<float>(n.v[i]) : 0.0f; };
    PigmentColor color{{f(0), f(1), f(2)}, f(3), f(4)};
    for (;;) {
      if (parser.accept(Keyword::kFilter)) {
        color.filter = static_cast<float>(parser.parse_float());
      } else if (parser.accept(Keyword::kTransmit)) {
        color.transmit = static_cast<float>(parser.parse_float());
      } else {
        break;
      }
    }
    found.color = color;
  }
  return found;
}

}  // namespace

std::vector<ColorEntry> parse_color_map(Parser& parser) {
  return parse_map<ColorEntry, ColorMapValue>(
      parser, [&](double position, std::vector<ColorEntry>& entries) {
        const AfterPosition next = parse_after_position(parser);
        parser.skip_comma();
        entries.push_back({position, next.color ? *next.color : parser.parse_color()});
        if (!next.position) return;
        parser.skip_comma();
        entries.push_back({*next.position, parser.parse_color()});
      });
}

std::vector<PigmentEntry> parse_pigment_map(Parser& parser) {
  return parse_map<PigmentEntry, PigmentMapValue>(
      parser, [&](double position, std::vector<PigmentEntry>& entries) {
        entries.push_back({position, parse_pigment_entry(parser)});
      });
}

std::vector<NormalEntry> parse_normal_map(Parser& parser) {
  return parse_map<NormalEntry, NormalMapValue>(
      parser, [&](double position, std::vector<NormalEntry>& entries) {
        entries.push_back({position, parse_normal_entry(parser)});
      });
}

std::vector<TextureEntry> parse_texture_map(Parser& parser) {
  return parse_map<TextureEntry, TextureMapValue>(
      parser, [&](double position, std::vector<TextureEntry>& entries) {
        entries.push_back({position, parse_texture_entry(parser)});
      });
}

std::vector<SlopeEntry> parse_slope_map(Parser& parser) {
  return parse_map<SlopeEntry, SlopeMapValue>(
      parser, [&](double position, std::vector<SlopeEntry>& entries) {
        const Vec2 v = parser.parse_vec2();
        entries.push_back({position, v.x, v.y});
      });
}

}  // namespace dioptre::pov
