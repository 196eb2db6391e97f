// SPDX-License-Identifier: Apache-2.0
// What may follow the parameters of an object.
#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

/// Reads the modifiers of one object.
class Modifiers {
 public:
  Modifiers(Parser& parser, Item& item) : parser_(parser), item_(item), object_(item.object) {}

  /// Up to the closing brace, which is taken.
  void parse() {
    while (!parser_.accept('}')) {
      if (parser_.accept(',') || parse_placement() || parse_look() || parse_flag()) continue;
      parser_.fail_expected("an object modifier or '}'");
    }
    take_ior_of_finish();
  }

 private:
  bool parse_placement() {
    if (const auto by = parse_transforms(parser_)) {
      transform_item(parser_, item_, *by);
      for (Object& bound : bounds_) transform_object(parser_, bound, *by);
      return true;
    }
    if (parser_.accept(Keyword::kClippedBy)) {
      parse_clips();
      return true;
    }
    if (parser_.accept(Keyword::kBoundedBy)) {
      parse_bounds();
      return true;
    }
    return false;
  }

  bool parse_look() {
    const Keyword keyword = keyword_at(parser_);
    switch (keyword) {
      case Keyword::kTexture:
        parser_.next();
        add_texture(parse_texture(parser_));
        return true;
      case Keyword::kPigment:
      case Keyword::kNormal:
      case Keyword::kFinish:
        parser_.next();
        settle_textures();
        object_.texture = change_texture(
            parser_, keyword, object_.texture ? object_.texture : default_texture(parser_));
        return true;
      case Keyword::kInteriorTexture:
        parser_.next();
        settle_textures();
        set_interior_texture(parse_interior_texture(parser_));
        return true;
      case Keyword::kInterior:
        parser_.next();
        object_.interior = parse_interior(parser_, object_.interior);
        return true;
      case Keyword::kMaterial:
        parser_.next();
        wear(parse_material(parser_, {}));
        return true;
      case Keyword::kPhotons:
        parser_.next();
        parse_photons(parser_);
        return true;
      default:
        return false;
    }
  }

  bool parse_flag() {
    switch (keyword_at(parser_)) {
      case Keyword::kInverse:
        parser_.next();
        object_.inverse = !object_.inverse;
        return true;
      case Keyword::kHollow:
        object_.has_hollow = true;
        return flag(object_.hollow);
      case Keyword::kNoShadow:
        return flag(object_.no_shadow);
      case Keyword::kNoImage:
        return flag(object_.no_image);
      case Keyword::kNoReflection:
        return flag(object_.no_reflection);
      case Keyword::kDoubleIlluminate:
        return flag(object_.double_illuminate);
      case Keyword::kUvMapping:
        return flag(object_.uv_mapping);
      case Keyword::kSturm:
        return sturm();
      case Keyword::kOpen:
        return open();
      case Keyword::kSplitUnion:
        return split_union();
      case Keyword::kHierarchy:
      case Keyword::kNoRadiosity:
        return ignored_flag();
      case Keyword::kCutawayTextures:
        parser_.not_rendered("cutaway_textures");
        return ignored_flag();
      case Keyword::kRadiosity:
        return radiosity();
      case Keyword::kUvVectors:
        return uv_vectors();
      default:
        return quick_colors();
    }
  }

  bool flag(bool& value) {
    parser_.next();
    value = parser_.parse_flag();
    return true;
  }

  bool ignored_flag() {
    bool ignored = false;
    return flag(ignored);
  }

  /// How often radiosity looks at the object.
  bool radiosity() {
    parser_.next();
    parser_.expect('{', "after radiosity");
    if (parser_.accept(Keyword::kImportance)) parser_.parse_float();
    parser_.expect('}', "after the importance");
    return true;
  }

  bool sturm() {
    bool on = false;
    flag(on);
    if (auto* shape = std::get_if<ShapeData>(&object_.geometry)) {
      if (auto* poly = std::get_if<Poly>(shape)) poly->sturm = on;
      if (auto* prism = std::get_if<Prism>(shape)) prism->sturm = on;
      if (auto* blob = std::get_if<Blob>(shape)) blob->sturm = on;
      if (auto* lathe = std::get_if<Lathe>(shape)) lathe->sturm = on;
      if (auto* sor = std::get_if<Sor>(shape)) sor->sturm = on;
    }
    return true;
  }

  bool open() {
    bool on = false;
    flag(on);
    if (auto* shape = std::get_if<ShapeData>(&object_.geometry)) {
      if (auto* prism = std::get_if<Prism>(shape)) prism->open = on;
      if (auto* cylinder = std::get_if<Cylinder>(shape)) cylinder->open = on;
      if (auto* cone = std::get_if<Cone>(shape)) cone->open = on;
      if (auto* sor = std::get_if<Sor>(shape)) sor->open = on;
    }
    return true;
  }

  bool split_union() {
    bool on = true;
    flag(on);
    if (auto* csg = std::get_if<Csg>(&object_.geometry)) csg->split_union = on;
    return true;
  }

  /// Texture coordinates of the corners of a patch or triangle.
  bool uv_vectors() {
    parser_.next();
    parser_.not_rendered("uv_vectors of one triangle or patch");
    while (parser_.at('<')) {
      parser_.parse_vec2();
      parser_.skip_comma();
    }
    return true;
  }

  /// An old spelling: a colour right in an object is for quick renders.
  /// An ior in the finish of the top layer stands for one in the interior (measured).
  void take_ior_of_finish() {
    if (!object_.texture) return;
    const auto* layers =
        std::get_if<LayeredTexture>(&at(parser_.scene().textures, object_.texture).data);
    if (!layers || layers->layers.empty() || layers->layers.back().finish.ior == 0) return;
    Interior interior;
    if (object_.interior) interior = at(parser_.scene().interiors, object_.interior);
    interior.ior = layers->layers.back().finish.ior;
    interior.has_ior = true;
    object_.interior = append(parser_.scene().interiors, interior);
  }

  bool quick_colors() {
    if (!parser_.accept(Keyword::kColor) && !parser_.accept(Keyword::kColour)) return false;
    parser_.parse_color();
    parser_.warn("a colour in an object without pigment does nothing");
    return true;
  }

  /// Bakes the moves so far into the textures, so that new ones begin where they are written.
  void settle_textures() {
    if (object_.texture_transform == Affine{}) return;
    if (object_.texture) {
      object_.texture = transformed(parser_, object_.texture, object_.texture_transform);
    }
    if (object_.interior_texture) {
      object_.interior_texture =
          transformed(parser_, object_.interior_texture, object_.texture_transform);
    }
    object_.texture_transform = {};
  }

  void add_texture(TextureId texture) {
    settle_textures();
    object_.texture = object_.texture ? layered(parser_, object_.texture, texture) : texture;
  }

  void set_interior_texture(TextureId texture) {
    object_.interior_texture =
        object_.interior_texture ? layered(parser_, object_.interior_texture, texture) : texture;
  }

  void wear(const MaterialValue& material) {
    if (material.texture) add_texture(material.texture);
    if (material.interior_texture) {
      settle_textures();
      set_interior_texture(material.interior_texture);
    }
    if (material.interior) object_.interior = material.interior;
  }

  void parse_clips() {
    const Parser::Nesting nesting(parser_);
    parser_.expect('{', "after clipped_by");
    if (parser_.accept(Keyword::kBoundedBy)) {
      if (bounds_.empty()) parser_.fail("the object has no bounded_by before this clipped_by");
      for (const Object& bound : bounds_) object_.clipped_by.push_back(add_part(parser_, bound));
    }
    while (!parser_.accept('}')) {
      Item clip = parse_object(parser_);
      if (clip.drawn)
        object_.clipped_by.push_back(add_part(parser_, std::move(clip.object), clip.where));
      parser_.skip_comma();
    }
  }

  /// Bounds only help other renderers; they matter where `clipped_by { bounded_by }` names them.
  void parse_bounds() {
    const Parser::Nesting nesting(parser_);
    parser_.expect('{', "after bounded_by");
    if (parser_.accept(Keyword::kClippedBy)) {
      for (const ObjectId id : object_.clipped_by)
        bounds_.push_back(at(parser_.scene().objects, id));
    }
    while (!parser_.accept('}')) {
      Item bound = parse_object(parser_);
      if (bound.drawn) bounds_.push_back(std::move(bound.object));
      parser_.skip_comma();
    }
  }

  Parser& parser_;
  Item& item_;
  Object& object_;
  std::vector<Object> bounds_;
};

}  // namespace

void parse_object_modifiers(Parser& parser, Item& item) { Modifiers(parser, item).parse(); }

}  // namespace dioptre::pov
