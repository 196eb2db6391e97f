// SPDX-License-Identifier: Apache-2.0
// isosurface, and the container that it has in common with parametric.
#include <cmath>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

double float_and_comma(Parser& parser) {
  const double value = parser.parse_float();
  parser.skip_comma();
  return value;
}

Vec3 vector_and_comma(Parser& parser) {
  const Vec3 value = parser.parse_vec3();
  parser.skip_comma();
  return value;
}

/// A number that must be positive; `otherwise`, with a warning, if it is not.
double parse_positive(Parser& parser, std::string_view name, double otherwise) {
  const double value = parser.parse_float();
  if (value > 0) return value;
  parser.warn(std::string(name) +
              " of the isosurface is not positive: " + std::to_string(otherwise) + " is taken");
  return otherwise;
}

std::uint32_t parse_max_trace(Parser& parser) {
  const double value = parse_positive(parser, "max_trace", 1);
  return value < 1e9 ? static_cast<std::uint32_t>(std::max(value, 1.0)) : 0;
}

bool parse_item_of(Parser& parser, Isosurface& iso) {
  const Isosurface usual;
  if (parser.accept(Keyword::kContainedBy)) {
    iso.container = parse_container(parser);
  } else if (parser.accept(Keyword::kThreshold)) {
    iso.threshold = parser.parse_float();
  } else if (parser.accept(Keyword::kAccuracy)) {
    iso.accuracy = parse_positive(parser, "accuracy", usual.accuracy);
  } else if (parser.accept(Keyword::kMaxGradient)) {
    iso.max_gradient = parse_positive(parser, "max_gradient", usual.max_gradient);
  } else if (parser.accept(Keyword::kEvaluate)) {
    iso.evaluate = true;
    iso.least_gradient = float_and_comma(parser);
    iso.overestimate = float_and_comma(parser);
    iso.attenuation = parser.parse_float();
  } else if (parser.accept(Keyword::kOpen)) {
    iso.open = true;
  } else if (parser.accept(Keyword::kMaxTrace)) {
    iso.max_trace = parse_max_trace(parser);
  } else if (parser.accept(Keyword::kAllIntersections)) {
    iso.max_trace = 0;
  } else {
    return parser.accept(',');
  }
  return true;
}

Isosurface parse_isosurface(Parser& parser) {
  Isosurface iso;
  if (!parser.accept(Keyword::kFunction)) parser.fail_expected("function");
  iso.function = parser.parse_function();
  while (parse_item_of(parser, iso)) {
  }
  return iso;
}

}  // namespace

Container parse_container(Parser& parser) {
  Container container;
  parser.expect('{', "after contained_by");
  if (parser.accept(Keyword::kSphere)) {
    container.sphere = true;
    parser.expect('{', "after sphere");
    container.center = vector_and_comma(parser);
    container.radius = std::fabs(float_and_comma(parser));
  } else if (parser.accept(Keyword::kBox)) {
    parser.expect('{', "after box");
    container.corner1 = vector_and_comma(parser);
    container.corner2 = vector_and_comma(parser);
  } else {
    parser.fail_expected("sphere or box");
  }
  parser.expect('}', "after the container");
  parser.expect('}', "after contained_by");
  return container;
}

bool parse_function_shape(Parser& parser, Keyword keyword, Item& item) {
  if (keyword != Keyword::kIsosurface) return false;
  item.object.geometry = ShapeData{parse_isosurface(parser)};
  return true;
}

}  // namespace dioptre::pov
