// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

/// More steps make more pieces than are allowed.
constexpr std::int64_t kMostSteps = 20;

std::uint32_t parse_steps(Parser& parser) {
  return static_cast<std::uint32_t>(parse_whole(parser, 0, kMostSteps));
}

}  // namespace

/// The type says how POV-Ray keeps the pieces; the picture is the same (measured).
BicubicPatch parse_bicubic_patch(Parser& parser) {
  BicubicPatch patch;
  for (;;) {
    if (parser.accept(Keyword::kType)) {
      parser.parse_float();
    } else if (parser.accept(Keyword::kFlatness)) {
      patch.flatness = parser.parse_float();
    } else if (parser.accept(Keyword::kUSteps)) {
      patch.u_steps = parse_steps(parser);
    } else if (parser.accept(Keyword::kVSteps)) {
      patch.v_steps = parse_steps(parser);
    } else if (parser.accept(Keyword::kUvVectors)) {
      for (Vec2& uv : patch.uv_corners) {
        uv = parser.parse_vec2();
        parser.skip_comma();
      }
    } else if (!parser.accept(',')) {
      break;
    }
  }
  for (Vec3& point : patch.points) {
    point = parser.parse_vec3();
    parser.skip_comma();
  }
  return patch;
}

}  // namespace dioptre::pov
