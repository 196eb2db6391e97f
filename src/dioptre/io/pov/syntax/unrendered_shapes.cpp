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
void skip_vector(Parser& parser) {
  parser.parse_vec3();
  parser.skip_comma();
}

void parse_bicubic_patch(Parser& parser) {
  for (;;) {
    if (accept_any(parser,
                   {Keyword::kType, Keyword::kFlatness, Keyword::kUSteps, Keyword::kVSteps})) {
      parser.parse_float();
    } else if (parser.accept(Keyword::kUvVectors)) {
      for (int i = 0; i < 4; ++i) {
        parser.parse_vec2();
        parser.skip_comma();
      }
    } else if (!parser.accept(',')) {
      break;
    }
  }
  for (int i = 0; i < 16; ++i) skip_vector(parser);
}

/// The kinds of quaternion formulas are words that stand alone.
void parse_julia_fractal(Parser& parser) {
  parser.parse_numeric();
  for (;;) {
    if (accept_any(parser, {Keyword::kMaxIteration, Keyword::kPrecision})) {
      parser.parse_float();
    } else if (parser.accept(Keyword::kSlice)) {
      parser.parse_numeric();
      parser.skip_comma();
      parser.parse_float();
    } else if (parser.accept(Keyword::kPwr)) {
      parser.expect('(', "after pwr");
      parser.parse_float();
      parser.skip_comma();
      parser.parse_float();
      parser.expect(')', "after the exponent");
    } else if (!parser.accept(',') &&
               !accept_any(
                   parser,
                   {Keyword::kQuaternion, Keyword::kHypercomplex, Keyword::kSqr, Keyword::kCube,
                    Keyword::kExp,        Keyword::kReciprocal,   Keyword::kSin, Keyword::kAsin,
                    Keyword::kSinh,       Keyword::kAsinh,        Keyword::kCos, Keyword::kAcos,
                    Keyword::kCosh,       Keyword::kAcosh,        Keyword::kTan, Keyword::kAtan,
                    Keyword::kTanh,       Keyword::kAtanh,        Keyword::kLn,  Keyword::kLog})) {
      return;
    }
  }
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
    case Keyword::kBicubicPatch:
      parse_bicubic_patch(parser);
      return true;
    case Keyword::kJuliaFractal:
      parse_julia_fractal(parser);
      return true;
    case Keyword::kParametric:
      parse_parametric(parser);
      return true;
    default:
      return false;
  }
}

}  // namespace dioptre::pov
