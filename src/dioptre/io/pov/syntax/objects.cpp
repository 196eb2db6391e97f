// SPDX-License-Identifier: Apache-2.0
// Object statements: what is in the braces of a shape, and how it gets into the scene.
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

void move_clips(Parser& parser, std::vector<ObjectId>& clips, const Affine& by) {
  for (ObjectId& id : clips) {
    Object moved = at(parser.scene().objects, id);
    transform_object(parser, moved, by);
    id = add_part(parser, std::move(moved));
  }
}

/// The normals of smooth height fields are mixed where the field has been scaled (measured).
void scale_smooth_normals(Object& object) {
  auto* shape = std::get_if<ShapeData>(&object.geometry);
  auto* field = shape ? std::get_if<HeightField>(shape) : nullptr;
  if (!field || !field->smooth) return;
  const Affine& to_parent = object.transform;
  const Vec3 scale{length(to_parent.vector({1, 0, 0})), length(to_parent.vector({0, 1, 0})),
                   length(to_parent.vector({0, 0, 1}))};
  const bool usable = is_finite(scale) && scale.x > 0 && scale.y > 0 && scale.z > 0;
  field->smooth_scale = usable ? scale : Vec3{1, 1, 1};
}

bool begins_object(Keyword keyword) {
  switch (keyword) {
    case Keyword::kSphere:
    case Keyword::kBox:
    case Keyword::kCylinder:
    case Keyword::kCone:
    case Keyword::kPlane:
    case Keyword::kTorus:
    case Keyword::kDisc:
    case Keyword::kQuadric:
    case Keyword::kCubic:
    case Keyword::kQuartic:
    case Keyword::kPoly:
    case Keyword::kPolynomial:
    case Keyword::kTriangle:
    case Keyword::kSmoothTriangle:
    case Keyword::kMesh:
    case Keyword::kMesh2:
    case Keyword::kPolygon:
    case Keyword::kPrism:
    case Keyword::kBlob:
    case Keyword::kText:
    case Keyword::kUnion:
    case Keyword::kComposite:
    case Keyword::kMerge:
    case Keyword::kIntersection:
    case Keyword::kDifference:
    case Keyword::kSuperellipsoid:
    case Keyword::kLathe:
    case Keyword::kSor:
    case Keyword::kSphereSweep:
    case Keyword::kBicubicPatch:
    case Keyword::kHeightField:
    case Keyword::kJuliaFractal:
    case Keyword::kIsosurface:
    case Keyword::kParametric:
    case Keyword::kOvus:
      return true;
    default:
      return false;
  }
}

/// An object that is not drawn is declared as a union of nothing.
bool is_nothing(const Object& object) {
  const auto* csg = std::get_if<Csg>(&object.geometry);
  return csg && csg->children.empty();
}

/// An item by its name, if that is next.
std::optional<Item> take_item(Parser& parser) {
  const Described* described = parser.peek_described();
  if (!described) return std::nullopt;
  Item item;
  if (std::holds_alternative<Object>(*described)) {
    item.object = std::get<Object>(*parser.take_described());
    if (item.object.name.empty()) item.object.name = parser.last_name();
    item.drawn = !is_nothing(item.object);
  } else if (std::holds_alternative<LightsValue>(*described)) {
    const DescribedPtr taken = parser.take_described();
    const LightsValue& value = std::get<LightsValue>(*taken);
    item.lights = value.lights;
    item.drawn = value.object.has_value();
    if (value.object) item.object = *value.object;
  } else {
    return std::nullopt;
  }
  return item;
}

/// `{ IDENTIFIER modifiers }` or `{ shape {...} modifiers }` behind `object`.
Item parse_object_block(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after object");
  Item item = parse_object(parser);
  parse_object_modifiers(parser, item);
  return item;
}

/// A shape behind its keyword; its parameters may be taken over from an object of that name.
Item parse_shape_block(Parser& parser, Keyword keyword) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', std::string("after ") + std::string(text_of(keyword)));
  const bool holds_others = keyword == Keyword::kUnion || keyword == Keyword::kComposite ||
                            keyword == Keyword::kMerge || keyword == Keyword::kIntersection ||
                            keyword == Keyword::kDifference;
  std::optional<Item> item = holds_others ? std::nullopt : take_item(parser);
  if (!item) {
    item.emplace();
    parse_shape(parser, keyword, *item);
  }
  parse_object_modifiers(parser, *item);
  return std::move(*item);
}

}  // namespace

ObjectId add_part(Parser& parser, Object object, SourcePosition where) {
  auto& places = parser.source_map().objects;
  places.resize(parser.scene().objects.size());
  places.push_back(where);
  const ObjectId id = append(parser.scene().objects, std::move(object));
  parser.check_levels();
  return id;
}

void transform_object(Parser& parser, Object& object, const Affine& by) {
  object.transform = then(object.transform, by);
  scale_smooth_normals(object);
  if (object.texture || object.interior_texture) {
    object.texture_transform = then(object.texture_transform, by);
  }
  move_clips(parser, object.clipped_by, by);
}

void transform_item(Parser& parser, Item& item, const Affine& by) {
  if (item.drawn) transform_object(parser, item.object, by);
  for (Light& light : item.lights) transform_light(light, by);
}

namespace {

std::optional<Item> parse_placeless_item(Parser& parser) {
  if (std::optional<Item> item = take_item(parser)) return item;
  const Keyword keyword = keyword_at(parser);
  if (keyword == Keyword::kObject) {
    parser.next();
    return parse_object_block(parser);
  }
  if (keyword == Keyword::kLightSource) {
    parser.next();
    return parse_light(parser);
  }
  if (keyword == Keyword::kLightGroup) {
    parser.next();
    return parse_light_group(parser);
  }
  if (!begins_object(keyword)) return std::nullopt;
  parser.next();
  return parse_shape_block(parser, keyword);
}

}  // namespace

std::optional<Item> parse_item(Parser& parser) {
  const SourcePosition where = parser.position();
  std::optional<Item> item = parse_placeless_item(parser);
  if (item) item->where = where;
  return item;
}

Item parse_object(Parser& parser) {
  std::optional<Item> item = parse_item(parser);
  if (!item) parser.fail_expected("an object");
  return std::move(*item);
}

Described to_described(Item item) {
  if (!item.lights.empty()) {
    LightsValue value{std::move(item.lights), std::nullopt};
    if (item.drawn) value.object = std::move(item.object);
    return value;
  }
  if (!item.drawn) item.object.geometry = Csg{};
  return std::move(item.object);
}

void add_root(Parser& parser, Item item) {
  Scene& scene = parser.scene();
  scene.lights.insert(scene.lights.end(), item.lights.begin(), item.lights.end());
  if (!item.drawn) return;
  if (!item.object.texture) item.object.texture = default_texture(parser);
  scene.roots.push_back(add_part(parser, std::move(item.object), item.where));
}

ObjectId register_object(Parser& parser, const Object& object) { return add_part(parser, object); }

}  // namespace dioptre::pov
