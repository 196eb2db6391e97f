// SPDX-License-Identifier: Apache-2.0
// texture { ... }
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

/// Whether another texture may lie over or under this one.
bool is_layers(const Texture& texture) {
  return std::holds_alternative<LayeredTexture>(texture.data);
}

/// Brings the placement of the texture into its layers, so that each may be changed alone.
void settle(Texture& texture) {
  auto* layers = std::get_if<LayeredTexture>(&texture.data);
  if (!layers) return;
  for (TextureLayer& layer : layers->layers) {
    layer.transform = then(layer.transform, texture.transform);
  }
  texture.transform = {};
}

/// Before a normal that is new: it is not moved by what has moved the pigment.
void settle_pigment(Parser& parser, TextureLayer& layer) {
  if (layer.normal || layer.transform == Affine{}) return;
  if (layer.pigment) layer.pigment = transformed(parser, layer.pigment, layer.transform);
  layer.transform = {};
}

/// `pigment`, `normal` or `finish`, the keyword taken.
void change_layer(Parser& parser, Keyword keyword, TextureLayer& layer) {
  if (keyword == Keyword::kPigment) {
    layer.pigment = parse_pigment(parser, layer.pigment);
  } else if (keyword == Keyword::kFinish) {
    layer.finish = parse_finish(parser, layer.finish);
  } else {
    settle_pigment(parser, layer);
    layer.normal = parse_normal(parser, layer.normal);
  }
}

/// The name of a pigment, normal or finish, which stands for the whole of it.
bool change_layer_by_name(Parser& parser, TextureLayer& layer) {
  if (const auto pigment = take<PigmentId>(parser)) {
    layer.pigment = *pigment;
  } else if (const auto finish = take<Finish>(parser)) {
    layer.finish = *finish;
  } else if (const auto normal = take<NormalId>(parser)) {
    settle_pigment(parser, layer);
    layer.normal = *normal;
  } else {
    return false;
  }
  return true;
}

/// Reads the contents of one texture.
class TextureParser {
 public:
  TextureParser(Parser& parser, Texture base) : parser_(parser), texture_(std::move(base)) {
    settle(texture_);
    if (const auto* map = std::get_if<TextureMap>(&texture_.data)) {
      pattern_ = map->pattern;
      entries_ = map->entries;
      kind_ = Kind::kMap;
    } else if (const auto* average = std::get_if<AverageTexture>(&texture_.data)) {
      entries_ = average->entries;
      kind_ = Kind::kAverage;
    } else if (!is_layers(texture_)) {
      kind_ = Kind::kWhole;
    }
  }

  /// Up to the closing character, which is not taken.
  Texture parse(char close) {
    while (!parser_.at(close)) {
      if (parser_.accept(',')) continue;
      if (!parse_one()) parser_.fail_expected("a texture, a modifier or the end of the texture");
    }
    return finish();
  }

 private:
  enum class Kind : std::uint8_t { kLayers, kMap, kAverage, kWhole };

  bool parse_one() {
    const Keyword keyword = keyword_at(parser_);
    switch (keyword) {
      case Keyword::kPigment:
      case Keyword::kNormal:
      case Keyword::kFinish:
        parser_.next();
        change_layer(parser_, keyword, layer());
        return true;
      case Keyword::kTextureMap:
        parser_.next();
        entries_ = parse_texture_map(parser_);
        if (kind_ != Kind::kAverage) kind_ = Kind::kMap;
        return true;
      case Keyword::kAverage:
        parser_.next();
        kind_ = Kind::kAverage;
        return true;
      case Keyword::kMaterialMap:
        parser_.next();
        parse_material_map();
        return true;
      case Keyword::kTiles:
        parser_.next();
        parse_tiles();
        return true;
      case Keyword::kUvMapping:
        parser_.next();
        uv_ = parser_.parse_flag();
        return true;
      default:
        return (kind_ == Kind::kLayers && change_layer_by_name(parser_, layer())) ||
               parse_pattern();
    }
  }

  bool parse_pattern() {
    if (kind_ == Kind::kLayers || kind_ == Kind::kMap || kind_ == Kind::kAverage) {
      if (const auto block = parse_pattern_kind(parser_, pattern_)) {
        kind_ = Kind::kMap;
        if (block->parts > 0) parse_list(block->parts);
        if (block->in_braces) parser_.expect('}', "after the list of the object pattern");
        return true;
      }
    }
    if (kind_ == Kind::kMap) return parse_pattern_modifier(parser_, pattern_);
    if (const auto by = parse_transforms(parser_)) {
      move(*by);
      return true;
    }
    // Without a pattern, waves and warps have nothing to act on.
    return parse_pattern_modifier(parser_, pattern_);
  }

  void move(const Affine& by) {
    if (kind_ == Kind::kLayers) {
      for (TextureLayer& layer : std::get<LayeredTexture>(texture_.data).layers) {
        layer.transform = then(layer.transform, by);
      }
    } else {
      texture_.transform = then(texture_.transform, by);
    }
  }

  void parse_list(std::size_t parts) {
    entries_.clear();
    while (entries_.size() < parts && parser_.accept(Keyword::kTexture)) {
      entries_.push_back({static_cast<double>(entries_.size()), parse_texture(parser_)});
      parser_.skip_comma();
    }
    for (std::size_t i = entries_.size(); i < parts; ++i) {
      entries_.push_back({static_cast<double>(i), default_texture(parser_)});
    }
  }

  TextureLayer& layer() {
    if (kind_ != Kind::kLayers) {
      parser_.fail("a pigment, normal or finish cannot be changed in a texture of textures");
    }
    auto& layers = std::get<LayeredTexture>(texture_.data).layers;
    if (layers.empty()) layers.emplace_back();
    return layers.back();
  }

  void parse_material_map() {
    MaterialMap map;
    // The image ends where the textures begin, inside the same braces.
    map.image = parse_image_and_textures(parser_, map.textures);
    texture_.data = std::move(map);
    kind_ = Kind::kWhole;
  }

  static ImageId parse_image_and_textures(Parser& parser, std::vector<TextureId>& textures);

  /// An old spelling of checker with textures, the second of which gets the even cells (measured).
  void parse_tiles() {
    const Parser::Nesting nesting(parser_);
    parser_.expect('{', "after tiles");
    pattern_ = {};
    pattern_.data = Checker{};
    kind_ = Kind::kMap;
    entries_.clear();
    for (int i = 0; i < 2; ++i) {
      if (!parser_.accept(Keyword::kTexture)) parser_.fail_expected("texture");
      TextureId texture = parse_texture(parser_);
      while (parser_.accept(Keyword::kTexture)) {
        texture = layered(parser_, texture, parse_texture(parser_));
      }
      entries_.insert(entries_.begin(), {1.0 - i, texture});
      if (i == 0 && !parser_.accept(Keyword::kTile2)) parser_.fail_expected("tile2");
    }
    parser_.expect('}', "after tile2");
  }

  Texture finish() {
    const bool list = parts_of(pattern_) > 0;
    if (kind_ == Kind::kMap) {
      if (entries_.empty()) parser_.fail("a patterned texture needs a texture_map");
      texture_.data = TextureMap{std::move(pattern_), std::move(entries_), list};
    } else if (kind_ == Kind::kAverage) {
      if (entries_.empty()) parser_.fail("average needs a texture_map");
      texture_.data = AverageTexture{std::move(entries_)};
    }
    if (!uv_) return std::move(texture_);
    Texture wrapped;
    wrapped.data = UvTexture{append(parser_.scene().textures, std::move(texture_))};
    return wrapped;
  }

  Parser& parser_;
  Texture texture_;
  Kind kind_ = Kind::kLayers;
  Pattern pattern_;
  std::vector<TextureEntry> entries_;
  bool uv_ = false;
};

ImageId TextureParser::parse_image_and_textures(Parser& parser, std::vector<TextureId>& textures) {
  const auto parse_entry = [&] {
    if (!parser.accept(Keyword::kTexture)) return false;
    textures.push_back(parse_texture(parser));
    return true;
  };
  return parse_image(parser, ImageUse::kNumbers, parse_entry);
}

/// The contents of a texture; a lone name keeps its texture as it is.
TextureId parse_contents(Parser& parser, char close) {
  TextureId base;
  if (const auto named = take<TextureId>(parser)) {
    base = *named;
    if (parser.at(close)) return base;
  } else {
    base = default_texture(parser);
  }
  Texture begin = at(parser.scene().textures, base);
  return append_once(parser.scene().textures, TextureParser(parser, std::move(begin)).parse(close));
}

}  // namespace

TextureId default_texture(Parser& parser) {
  Scene& scene = parser.scene();
  if (!scene.default_texture) {
    LayeredTexture layers;
    layers.layers.emplace_back();
    layers.layers[0].pigment = append(scene.pigments, Pigment{});
    scene.default_texture = append(scene.textures, Texture{std::move(layers), {}});
  }
  return scene.default_texture;
}

TextureId parse_texture(Parser& parser) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after texture");
  const TextureId texture = parse_contents(parser, '}');
  parser.next();
  return texture;
}

TextureId parse_texture_entry(Parser& parser) {
  const Parser::Nesting nesting(parser);
  if (!parser.at(Keyword::kTexture)) return parse_contents(parser, ']');
  TextureId texture;
  while (parser.accept(Keyword::kTexture)) {
    const TextureId next = parse_texture(parser);
    texture = texture ? layered(parser, texture, next) : next;
  }
  return texture;
}

TextureId parse_interior_texture(Parser& parser) { return parse_texture(parser); }

TextureId change_texture(Parser& parser, Keyword keyword, TextureId id) {
  Texture texture = at(parser.scene().textures, id);
  settle(texture);
  auto* layers = std::get_if<LayeredTexture>(&texture.data);
  if (!layers) {
    parser.fail("a pigment, normal or finish cannot be changed in a texture of textures");
  }
  if (layers->layers.empty()) layers->layers.emplace_back();
  change_layer(parser, keyword, layers->layers.back());
  return append_once(parser.scene().textures, std::move(texture));
}

TextureId transformed(Parser& parser, TextureId id, const Affine& by) {
  Texture texture = at(parser.scene().textures, id);
  texture.transform = then(texture.transform, by);
  return append_once(parser.scene().textures, std::move(texture));
}

TextureId layered(Parser& parser, TextureId below, TextureId above) {
  Texture texture = at(parser.scene().textures, below);
  Texture top = at(parser.scene().textures, above);
  settle(texture);
  settle(top);
  auto* layers = std::get_if<LayeredTexture>(&texture.data);
  const auto* added = std::get_if<LayeredTexture>(&top.data);
  if (!layers || !added) {
    parser.fail("a texture of textures cannot be layered",
                "write the layers into the entries of its map");
  }
  layers->layers.insert(layers->layers.end(), added->layers.begin(), added->layers.end());
  return append_once(parser.scene().textures, std::move(texture));
}

}  // namespace dioptre::pov
