// SPDX-License-Identifier: Apache-2.0
// normal { ... }
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

/// The normal of the default texture, if any: what the entries of a normal_map and of a
/// list begin with (measured).
NormalId default_normal(Parser& parser) {
  const Scene& scene = parser.scene();
  const auto* layers =
      std::get_if<LayeredTexture>(&at(scene.textures, default_texture(parser)).data);
  return layers && !layers->layers.empty() ? layers->layers.front().normal : NormalId{};
}

/// A normal taken apart while it is read: any part may still be replaced.
class NormalParser {
 public:
  NormalParser(Parser& parser, const Normal& base) : parser_(parser) { open(base); }

  /// Up to the closing character, which is not taken.
  void parse(char close) {
    while (!parser_.at(close)) {
      if (!parse_one()) parser_.fail_expected("a normal, a modifier or the end of the normal");
    }
  }

  Normal take() {
    Normal normal = common_;
    close(normal);
    if (!uv_) return normal;
    Normal wrapped;
    wrapped.data = UvNormal{append(parser_.scene().normals, std::move(normal))};
    return wrapped;
  }

 private:
  enum class Kind : std::uint8_t { kPattern, kMap, kAverage, kImage };

  void open(const Normal& base) {
    common_ = base;
    std::visit([this](const auto& data) { open_data(data); }, base.data);
  }
  void open_data(const PatternNormal& data) {
    kind_ = Kind::kPattern;
    pattern_ = data.pattern;
    slopes_ = data.slope_map;
    amount_ = data.amount;
  }
  void open_data(const NormalMapNormal& data) {
    kind_ = Kind::kMap;
    pattern_ = data.pattern;
    normals_ = data.entries;
  }
  void open_data(const AverageNormal& data) {
    kind_ = Kind::kAverage;
    pattern_.warps = data.warps;
    normals_ = data.entries;
  }
  void open_data(const BumpMapNormal& data) {
    kind_ = Kind::kImage;
    pattern_.warps = data.warps;
    image_ = data.image;
    amount_ = data.amount;
  }
  void open_data(const UvNormal& data) {
    uv_ = true;
    const Normal inner = at(parser_.scene().normals, data.normal);
    open(inner);
  }

  void close(Normal& normal) {
    const bool list = parts_of(pattern_) > 0;
    switch (kind_) {
      case Kind::kPattern:
        normal.data = PatternNormal{std::move(pattern_), std::move(slopes_), amount_};
        break;
      case Kind::kMap:
        normal.data = NormalMapNormal{std::move(pattern_), std::move(normals_), list};
        break;
      case Kind::kAverage:
        if (normals_.empty()) parser_.fail("average needs a normal_map");
        normal.data = AverageNormal{std::move(normals_), std::move(pattern_.warps)};
        break;
      case Kind::kImage:
        normal.data = BumpMapNormal{image_, amount_, std::move(pattern_.warps)};
        break;
    }
  }

  bool parse_one() {
    if (parser_.accept(',')) return true;
    if (const auto named = pov::take<NormalId>(parser_)) {
      open(at(parser_.scene().normals, *named));
      return true;
    }
    if (parse_size()) return true;
    if (parser_.accept(Keyword::kNoBumpScale)) {
      common_.no_bump_scale = parser_.parse_flag();
    } else if (parser_.accept(Keyword::kAccuracy)) {
      common_.accuracy = parser_.parse_float();
    } else if (parser_.accept(Keyword::kUvMapping)) {
      uv_ = parser_.parse_flag();
    } else {
      return parse_map_block() || parse_kind() || parse_pattern_modifier(parser_, pattern_);
    }
    return true;
  }

  bool parse_size() {
    if (!parser_.accept(Keyword::kBumpSize)) return false;
    common_.bump_size = parser_.parse_float();
    common_.has_bump_size = true;
    return true;
  }

  bool parse_map_block() {
    if (parser_.accept(Keyword::kNormalMap)) {
      normals_ = parse_normal_map(parser_);
      if (kind_ != Kind::kAverage) kind_ = Kind::kMap;
    } else if (parser_.accept(Keyword::kSlopeMap)) {
      slopes_ = parse_slope_map(parser_);
      if (kind_ != Kind::kAverage) kind_ = Kind::kPattern;
    } else if (parser_.accept(Keyword::kAverage)) {
      kind_ = Kind::kAverage;
      normals_.clear();
    } else if (parser_.accept(Keyword::kBumpMap)) {
      image_ = parse_image(parser_, ImageUse::kBumps, [this] { return parse_size(); });
      kind_ = Kind::kImage;
      parse_amount();
    } else {
      return false;
    }
    return true;
  }

  void parse_amount() {
    parser_.skip_comma();
    if (parser_.at_expression()) amount_ = parser_.parse_float();
  }

  bool parse_kind() {
    const auto block = parse_pattern_kind(parser_, pattern_);
    if (!block) return false;
    kind_ = Kind::kPattern;
    if (block->parts > 0) parse_list(block->parts);
    if (block->in_braces) parser_.expect('}', "after the list of the object pattern");
    if (kind_ == Kind::kPattern) parse_amount();
    return true;
  }

  void parse_list(std::size_t parts) {
    if (!parser_.at(Keyword::kNormal)) return;
    kind_ = Kind::kMap;
    normals_.clear();
    while (normals_.size() < parts && parser_.accept(Keyword::kNormal)) {
      normals_.push_back(
          {static_cast<double>(normals_.size()), parse_normal(parser_, default_normal(parser_))});
      parser_.skip_comma();
    }
    for (std::size_t i = normals_.size(); i < parts; ++i) {
      Normal flat;
      flat.data = PatternNormal{{}, {}, 0};
      normals_.push_back({static_cast<double>(i), append(parser_.scene().normals, flat)});
    }
  }

  Parser& parser_;
  Kind kind_ = Kind::kPattern;
  Normal common_;
  Pattern pattern_;
  std::vector<SlopeEntry> slopes_;
  std::vector<NormalEntry> normals_;
  ImageId image_;
  double amount_ = 0.5;
  bool uv_ = false;
};

/// A surface that is not disturbed.
Normal flat_normal() {
  Normal normal;
  normal.data = PatternNormal{{}, {}, 0};
  return normal;
}

/// The contents of a normal; a lone name keeps its normal as it is.
NormalId parse_contents(Parser& parser, NormalId base, char close) {
  if (const auto named = take<NormalId>(parser)) {
    base = *named;
    if (parser.at(close)) return base;
  }
  Normal begin;
  if (base) {
    begin = at(parser.scene().normals, base);
  } else if (parser.at(close)) {
    begin = flat_normal();
  }
  NormalParser contents(parser, begin);
  contents.parse(close);
  return append_once(parser.scene().normals, contents.take());
}

}  // namespace

NormalId parse_normal(Parser& parser, NormalId base) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after normal");
  const NormalId normal = parse_contents(parser, base, '}');
  parser.next();
  return normal;
}

NormalId parse_normal_entry(Parser& parser) {
  const Parser::Nesting nesting(parser);
  return parse_contents(parser, default_normal(parser), ']');
}

NormalId transformed(Parser& parser, NormalId id, const Affine& by) {
  Normal normal = at(parser.scene().normals, id);
  if (auto* pattern = std::get_if<PatternNormal>(&normal.data)) {
    add_transform(pattern->pattern.warps, by);
  } else if (auto* map = std::get_if<NormalMapNormal>(&normal.data)) {
    add_transform(map->pattern.warps, by);
  } else if (auto* average = std::get_if<AverageNormal>(&normal.data)) {
    add_transform(average->warps, by);
  } else if (auto* image = std::get_if<BumpMapNormal>(&normal.data)) {
    add_transform(image->warps, by);
  } else {
    return id;
  }
  return append_once(parser.scene().normals, std::move(normal));
}

}  // namespace dioptre::pov
