// SPDX-License-Identifier: Apache-2.0
// union, merge, intersection and difference.
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

CsgOperation operation_of(Keyword keyword) {
  switch (keyword) {
    case Keyword::kMerge:
      return CsgOperation::kMerge;
    case Keyword::kIntersection:
      return CsgOperation::kIntersection;
    case Keyword::kDifference:
      return CsgOperation::kDifference;
    default:
      return CsgOperation::kUnion;
  }
}

}  // namespace

void parse_csg(Parser& parser, Keyword keyword, Item& item) {
  Csg csg;
  csg.operation = operation_of(keyword);
  bool first = true;
  while (std::optional<Item> child = parse_item(parser)) {
    item.lights.insert(item.lights.end(), child->lights.begin(), child->lights.end());
    if (child->drawn && item.drawn) {
      csg.children.push_back(add_part(parser, std::move(child->object), child->where));
    } else if (first && csg.operation == CsgOperation::kDifference && child->lights.empty()) {
      item.drawn = false;
    }
    first = false;
    parser.skip_comma();
  }
  if (csg.children.empty()) item.drawn = false;
  item.object.geometry = std::move(csg);
}

}  // namespace dioptre::pov
