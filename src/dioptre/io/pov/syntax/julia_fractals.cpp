// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kMostIterations = std::int64_t{1} << 31;

/// Four numbers; one alone is all of them.
std::array<double, 4> parse_four(Parser& parser) {
  const Numeric n = parser.parse_numeric();
  if (n.size == 1) return {n.v[0], n.v[0], n.v[0], n.v[0]};
  return {n.v[0], n.v[1], n.v[2], n.v[3]};
}

std::optional<JuliaFunction> accept_function(Parser& parser) {
  using F = JuliaFunction;
  static constexpr std::pair<Keyword, JuliaFunction> kFunctions[] = {
      {Keyword::kSqr, F::kSqr},   {Keyword::kCube, F::kCube},
      {Keyword::kExp, F::kExp},   {Keyword::kReciprocal, F::kReciprocal},
      {Keyword::kSin, F::kSin},   {Keyword::kAsin, F::kAsin},
      {Keyword::kSinh, F::kSinh}, {Keyword::kAsinh, F::kAsinh},
      {Keyword::kCos, F::kCos},   {Keyword::kAcos, F::kAcos},
      {Keyword::kCosh, F::kCosh}, {Keyword::kAcosh, F::kAcosh},
      {Keyword::kTan, F::kTan},   {Keyword::kAtan, F::kAtan},
      {Keyword::kTanh, F::kTanh}, {Keyword::kAtanh, F::kAtanh},
      {Keyword::kLn, F::kLn},     {Keyword::kPwr, F::kPwr}};
  for (const auto& [keyword, function] : kFunctions) {
    if (parser.accept(keyword)) return function;
  }
  return std::nullopt;
}

Vec2 parse_exponent(Parser& parser) {
  Vec2 exponent;
  parser.expect('(', "after pwr");
  exponent.x = parser.parse_float();
  parser.skip_comma();
  exponent.y = parser.parse_float();
  parser.expect(')', "after the exponent");
  return exponent;
}

void parse_slice(Parser& parser, JuliaFractal& julia) {
  const SourcePosition where = parser.position();
  julia.slice_normal = parse_four(parser);
  parser.skip_comma();
  julia.slice_distance = parser.parse_float();
  if (julia.slice_normal[3] == 0) {
    parser.fail_at(where, "the fourth component of the slice's normal must not be 0");
  }
}

}  // namespace

JuliaFractal parse_julia_fractal(Parser& parser) {
  const SourcePosition where = parser.position();
  JuliaFractal julia;
  julia.parameter = parse_four(parser);
  for (;;) {
    if (parser.accept(Keyword::kQuaternion)) {
      julia.algebra = JuliaAlgebra::kQuaternion;
    } else if (parser.accept(Keyword::kHypercomplex)) {
      julia.algebra = JuliaAlgebra::kHypercomplex;
    } else if (parser.accept(Keyword::kMaxIteration)) {
      julia.max_iteration = static_cast<std::uint32_t>(parse_whole(parser, 1, kMostIterations));
    } else if (parser.accept(Keyword::kPrecision)) {
      julia.precision = std::max(parser.parse_float(), 1.0);
    } else if (parser.accept(Keyword::kSlice)) {
      parse_slice(parser, julia);
    } else if (const auto function = accept_function(parser)) {
      julia.function = *function;
      if (function == JuliaFunction::kPwr) julia.exponent = parse_exponent(parser);
    } else if (!parser.accept(',')) {
      break;
    }
  }
  if (julia.algebra == JuliaAlgebra::kQuaternion && julia.function > JuliaFunction::kCube) {
    parser.fail_at(where, "quaternions can be iterated by sqr and cube only",
                   "write hypercomplex for other functions");
  }
  return julia;
}

}  // namespace dioptre::pov
