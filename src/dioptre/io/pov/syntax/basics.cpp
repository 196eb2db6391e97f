// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

constexpr std::string_view kTexts[] = {
#define DIOPTRE_KEYWORD(name, text) text,
#include "dioptre/io/pov/keywords.def"
#undef DIOPTRE_KEYWORD
};

}  // namespace

Keyword keyword_at(Parser& parser) {
  const Token& token = parser.peek();
  const bool reserved = token.kind == Token::Kind::kName &&
                        token.index < static_cast<std::uint32_t>(Keyword::kNotAKeyword);
  return reserved ? static_cast<Keyword>(token.index) : Keyword::kNotAKeyword;
}

std::string_view text_of(Keyword keyword) { return kTexts[static_cast<std::size_t>(keyword)]; }

std::int64_t parse_whole(Parser& parser, std::int64_t low, std::int64_t high) {
  const double value = parser.parse_float();
  if (!(value > static_cast<double>(low))) return low;
  if (value >= static_cast<double>(high)) return high;
  return static_cast<std::int64_t>(value);
}

Color parse_light_color(Parser& parser) { return parser.parse_color().color; }

}  // namespace dioptre::pov
