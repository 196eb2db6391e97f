// SPDX-License-Identifier: Apache-2.0
// translate, rotate, scale, matrix and transform.
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

Affine parse_scale(Parser& parser) {
  Vec3 by = parser.parse_vec3();
  bool changed = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (by[axis] != 0) continue;
    by[axis] = 1;
    changed = true;
  }
  if (changed) parser.warn("scaling by 0 is taken as scaling by 1");
  return scaling(by);
}

Affine parse_matrix(Parser& parser) {
  parser.expect('<', "to begin the twelve numbers of a matrix");
  double v[12];
  for (double& number : v) {
    number = parser.parse_float();
    parser.skip_comma();
  }
  parser.expect('>', "to end the twelve numbers of a matrix");
  bool changed = false;
  for (std::size_t column = 0; column < 3; ++column) {
    if (v[column] != 0 || v[3 + column] != 0 || v[6 + column] != 0) continue;
    v[4 * column] = 1;
    changed = true;
  }
  if (changed) parser.warn("a column of the matrix is zero: read as scaling by 1");
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, {v[9], v[10], v[11]}};
}

/// One transformation, if one is next.
std::optional<Affine> parse_transform(Parser& parser) {
  if (parser.accept(Keyword::kTranslate)) return translation(parser.parse_vec3());
  if (parser.accept(Keyword::kRotate)) return rotation(parser.parse_vec3());
  if (parser.accept(Keyword::kScale)) return parse_scale(parser);
  if (parser.accept(Keyword::kMatrix)) return parse_matrix(parser);
  if (!parser.accept(Keyword::kTransform)) return std::nullopt;
  if (parser.at('{')) return parse_transform_block(parser);
  const auto map = take<Affine>(parser);
  if (!map) parser.fail_expected("the name of a transformation, or '{'");
  return map;
}

}  // namespace

std::optional<Affine> parse_transforms(Parser& parser) {
  const SourcePosition where = parser.position();
  std::optional<Affine> all;
  while (const std::optional<Affine> one = parse_transform(parser)) {
    all = all ? then(*all, *one) : *one;
    parser.skip_comma();
  }
  if (all && !is_finite(all->x + all->y + all->z + all->o)) {
    parser.fail_at(where, "the transformation is not finite");
  }
  if (all && !inverse(*all)) {
    parser.fail_at(where, "the transformation flattens what it moves: it has no inverse",
                   "its three axes must not lie in a plane, nor be too small or too large");
  }
  return all;
}

Affine parse_transform_block(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after transform");
  Affine all;
  bool inverted = false;  // wherever it stands and however often: the whole is inverted (measured)
  while (!parser.accept('}')) {
    if (const auto map = take<Affine>(parser)) {
      all = then(all, *map);
    } else if (parser.accept(Keyword::kInverse)) {
      inverted = true;
    } else if (const auto map = parse_transforms(parser)) {
      all = then(all, *map);
    } else {
      parser.fail_expected("a transformation or '}'");
    }
  }
  if (!inverted) return all;
  const std::optional<Affine> undone = inverse(all);
  if (!undone) parser.fail("the transformation has no inverse");
  return *undone;
}

}  // namespace dioptre::pov
