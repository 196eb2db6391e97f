// SPDX-License-Identifier: Apache-2.0
// Shapes that are read and checked but not rendered yet. Their modifiers follow as for any object.
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

void skip_float(Parser& parser) {
  parser.parse_float();
  parser.skip_comma();
}

void parse_functions(Parser& parser, int count) {
  for (int i = 0; i < count; ++i) {
    if (!parser.accept(Keyword::kFunction)) parser.fail_expected("function");
    parser.parse_function();
    parser.skip_comma();
  }
}

void parse_parametric(Parser& parser) {
  parse_functions(parser, 3);
  parser.parse_vec2();
  parser.skip_comma();
  parser.parse_vec2();
  for (;;) {
    if (parser.accept(Keyword::kContainedBy)) {
      parse_container(parser);
    } else if (accept_any(parser, {Keyword::kAccuracy, Keyword::kMaxGradient})) {
      parser.parse_float();
    } else if (parser.accept(Keyword::kPrecompute)) {
      skip_float(parser);
      while (accept_any(parser, {Keyword::kX, Keyword::kY, Keyword::kZ})) parser.skip_comma();
    } else if (!parser.accept(',')) {
      return;
    }
  }
}

}  // namespace

bool parse_unrendered_shape(Parser& parser, Keyword keyword, Item& item) {
  parser.not_rendered(text_of(keyword));
  item.drawn = false;
  switch (keyword) {
    case Keyword::kParametric:
      parse_parametric(parser);
      return true;
    default:
      return false;
  }
}

}  // namespace dioptre::pov
