// SPDX-License-Identifier: Apache-2.0
// Colours and their keywords.
#include <cmath>

#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

/// From the encoding of displays to linear light (IEC 61966-2-1).
double decoded(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

/// From a value in the encoding of displays to one of the scene.
double of_scene(double v, const Settings& settings) {
  if (settings.assumed_gamma == 0) return v;
  const double light = decoded(v);
  if (settings.assumed_gamma == 1 || !(light > 0)) return light;
  return std::pow(light, 1 / settings.assumed_gamma);
}

bool names_component(Keyword k) {
  return k == Keyword::kRed || k == Keyword::kGreen || k == Keyword::kBlue ||
         k == Keyword::kFilter || k == Keyword::kTransmit || k == Keyword::kAlpha;
}

bool begins_vector(Keyword k) {
  switch (k) {
    case Keyword::kRgb:
    case Keyword::kRgbf:
    case Keyword::kRgbt:
    case Keyword::kRgbft:
    case Keyword::kSrgb:
    case Keyword::kSrgbf:
    case Keyword::kSrgbt:
    case Keyword::kSrgbft:
      return true;
    default:
      return false;
  }
}

/// How a vector after `rgbt` and the like becomes five components.
Numeric arranged(Keyword k, const Numeric& n, const Settings& settings) {
  const bool filter = k == Keyword::kRgbf || k == Keyword::kSrgbf;
  const bool transmit = k == Keyword::kRgbt || k == Keyword::kSrgbt;
  const bool both = k == Keyword::kRgbft || k == Keyword::kSrgbft;
  const std::uint8_t size = both ? 5 : filter || transmit ? 4 : 3;
  Numeric color = promoted(n, n.size > size ? n.size : size);
  color = promoted(color, 5);
  if (transmit && n.size <= 4) {
    color.v[4] = color.v[3];
    color.v[3] = 0;
  }
  color.color = true;
  if (k == Keyword::kSrgb || k == Keyword::kSrgbf || k == Keyword::kSrgbt ||
      k == Keyword::kSrgbft) {
    for (std::size_t i = 0; i < 3; ++i) color.v[i] = of_scene(color.v[i], settings);
  }
  return color;
}

}  // namespace

bool is_color_keyword(Keyword k) {
  return k == Keyword::kColor || k == Keyword::kColour || begins_vector(k) || names_component(k);
}

bool Interpreter::at_color_keyword() {
  const Token& token = peek();
  if (token.kind != Token::Kind::kName || token.index >= kKeywordCount) return false;
  return is_color_keyword(static_cast<Keyword>(token.index));
}

bool Interpreter::at_color() {
  const Token& token = peek();
  if (token.is('<') || token.is('(') || at_color_keyword()) return true;
  if (token.kind != Token::Kind::kName || token.index < kKeywordCount) return false;
  const Value* value = operand();
  return value && value_is_numeric(*value);
}

/// A colour as part of an expression: `rgb V`, or `red F` and the like.
Numeric Interpreter::color_factor() {
  const Nesting guard(*this);
  while (accept(Keyword::kColor) || accept(Keyword::kColour)) {
  }
  const Token token = peek();
  const auto k = token.kind == Token::Kind::kName && token.index < kKeywordCount
                     ? static_cast<Keyword>(token.index)
                     : Keyword::kNotAKeyword;
  if (begins_vector(k)) {
    next();
    return arranged(k, sum(), scene_.settings);
  }
  Numeric color;
  color.size = 5;
  color.color = true;
  if (!names_component(k)) return to_color(sum());
  color_component(color);
  return color;
}

Numeric Interpreter::to_color(const Numeric& n) {
  Numeric color = promoted(n, 5);
  color.color = true;
  return color;
}

/// `red F` and the like sets one component.
void Interpreter::color_component(Numeric& color) {
  const auto k = static_cast<Keyword>(next().index);
  const double value = parse_float();
  switch (k) {
    case Keyword::kRed:
      color.v[0] = value;
      break;
    case Keyword::kGreen:
      color.v[1] = value;
      break;
    case Keyword::kBlue:
      color.v[2] = value;
      break;
    case Keyword::kTransmit:
      color.v[4] = value;
      break;
    default:
      color.v[3] = value;
  }
}

/// A whole colour: a colour or vector, then components that are set one by one.
Numeric Interpreter::color_terms() {
  Numeric color = color_factor();
  for (;;) {
    const Token& token = peek();
    if (token.kind != Token::Kind::kName || token.index >= kKeywordCount) return color;
    if (!names_component(static_cast<Keyword>(token.index))) return color;
    color_component(color);
  }
}

PigmentColor Interpreter::parse_color() {
  const Numeric c = color_terms();
  const auto f = [&](std::size_t i) { return static_cast<float>(c.v[i]); };
  return {{f(0), f(1), f(2)}, f(3), f(4)};
}

}  // namespace dioptre::pov
