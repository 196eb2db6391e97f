// SPDX-License-Identifier: Apache-2.0
// polygon, prism, blob and text.
#include <cmath>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kMostPoints = std::int64_t{1} << 26;

/// Points in the x-y plane cut into closed outlines: each goes on until its first point comes back.
Polygon parse_polygon(Parser& parser, bool& drawn) {
  const SourcePosition where = parser.position();
  const std::int64_t count = parse_whole(parser, 0, kMostPoints);
  if (count < 3) parser.fail_at(where, "a polygon needs at least three points");
  Polygon polygon;
  std::vector<Vec3> outline;
  const auto close = [&] {
    if (outline.size() >= 3) polygon.outlines.push_back(std::move(outline));
    outline.clear();
  };
  for (std::int64_t i = 0; i < count; ++i) {
    parser.skip_comma();
    const Vec3 point = parser.parse_vec3();
    if (!outline.empty() && point == outline.front()) {
      close();
    } else {
      outline.push_back(point);
    }
  }
  if (!outline.empty()) parser.warn("the last outline of the polygon is open: it is closed");
  close();
  if (polygon.outlines.empty()) {
    parser.warn("the polygon has no area: it is left out");
    drawn = false;
  }
  return polygon;
}

Text parse_text(Parser& parser, bool& drawn) {
  Text text;
  if (parser.accept(Keyword::kInternal)) {
    static constexpr const char* kFonts[] = {"timrom.ttf", "cyrvetic.ttf", "crystal.ttf",
                                             "povlogo.ttf"};
    const std::int64_t number = parse_whole(parser, 0, 1000);
    text.font = parser.find_file(kFonts[number >= 1 && number <= 4 ? number - 1 : 0]);
  } else {
    if (!parser.accept(Keyword::kTtf)) parser.fail_expected("ttf or internal");
    text.font = parser.find_font(parser.parse_file_name());
  }
  parser.skip_comma();
  text.text = parser.parse_string();
  parser.skip_comma();
  text.thickness = parser.parse_float();
  parser.skip_comma();
  text.offset = parser.parse_vec3();
  if (text.text.empty()) drawn = false;
  return text;
}

/// `{ a, b, radius, [strength] S ... }` of one component, with its own texture and transforms.
BlobComponent parse_blob_component(Parser& parser, bool cylinder, Object& object) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after the kind of the component");
  BlobComponent part;
  part.cylinder = cylinder;
  part.a = parser.parse_vec3();
  parser.skip_comma();
  part.b = cylinder ? parser.parse_vec3() : part.a;
  parser.skip_comma();
  part.radius = parser.parse_float();
  parser.skip_comma();
  parser.accept(Keyword::kStrength);
  part.strength = parser.parse_float();
  parser.skip_comma();
  TextureId texture;
  while (!parser.accept('}')) {
    const Keyword keyword = keyword_at(parser);
    if (const auto by = parse_transforms(parser)) {
      part.transform = then(part.transform, *by);
      if (texture) texture = transformed(parser, texture, *by);
    } else if (parser.accept(Keyword::kTexture)) {
      const TextureId next = parse_texture(parser);
      texture = texture ? layered(parser, texture, next) : next;
    } else if (keyword == Keyword::kPigment || keyword == Keyword::kNormal ||
               keyword == Keyword::kFinish) {
      parser.next();
      texture = change_texture(parser, keyword, texture ? texture : default_texture(parser));
    } else {
      parser.fail_expected("a texture, a transformation or '}'");
    }
  }
  if (texture) {
    part.texture = static_cast<std::uint32_t>(object.part_textures.size());
    object.part_textures.push_back(texture);
  }
  return part;
}

}  // namespace

void parse_blob(Parser& parser, Item& item) {
  Blob blob;
  const SourcePosition where = parser.position();
  for (;;) {
    if (parser.accept(Keyword::kThreshold)) {
      blob.threshold = parser.parse_float();
    } else if (parser.accept(Keyword::kSphere)) {
      blob.components.push_back(parse_blob_component(parser, false, item.object));
    } else if (parser.accept(Keyword::kCylinder)) {
      blob.components.push_back(parse_blob_component(parser, true, item.object));
    } else if (parser.accept(Keyword::kComponent)) {
      BlobComponent part;
      part.strength = parser.parse_float();
      parser.skip_comma();
      part.radius = parser.parse_float();
      parser.skip_comma();
      part.a = part.b = parser.parse_vec3();
      blob.components.push_back(part);
    } else if (!parser.accept(',')) {
      break;
    }
  }
  if (blob.components.empty()) parser.fail_at(where, "the blob has no components");
  item.object.geometry = ShapeData{std::move(blob)};
}

bool parse_composite_shape(Parser& parser, Keyword keyword, Item& item) {
  switch (keyword) {
    case Keyword::kPolygon:
      item.object.geometry = ShapeData{parse_polygon(parser, item.drawn)};
      return true;
    case Keyword::kText:
      item.object.geometry = ShapeData{parse_text(parser, item.drawn)};
      return true;
    case Keyword::kBlob:
      parse_blob(parser, item);
      return true;
    case Keyword::kPrism:
      parse_prism(parser, item);
      return true;
    case Keyword::kMesh:
      parse_mesh(parser, item);
      return true;
    case Keyword::kMesh2:
      parse_mesh2(parser, item);
      return true;
    case Keyword::kUnion:
    case Keyword::kComposite:  // an old name of it
    case Keyword::kMerge:
    case Keyword::kIntersection:
    case Keyword::kDifference:
      parse_csg(parser, keyword, item);
      return true;
    default:
      return false;
  }
}

}  // namespace dioptre::pov
