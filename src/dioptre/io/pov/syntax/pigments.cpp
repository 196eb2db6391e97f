// SPDX-License-Identifier: Apache-2.0
// pigment { ... }
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

/// A pigment taken apart while it is read: any part may still be replaced.
class PigmentParser {
 public:
  PigmentParser(Parser& parser, const Pigment& base) : parser_(parser) { open(base); }

  /// Up to the closing character, which is not taken.
  void parse(char close) {
    while (!parser_.at(close)) {
      if (!parse_one()) parser_.fail_expected("a pigment, a modifier or the end of the pigment");
    }
  }

  Pigment take() {
    Pigment pigment = close();
    pigment.quick_color = quick_color_;
    pigment.has_quick_color = has_quick_color_;
    if (!uv_) return pigment;
    Pigment wrapped;
    wrapped.data = UvPigment{append(parser_.scene().pigments, std::move(pigment))};
    return wrapped;
  }

 private:
  enum class Kind : std::uint8_t { kSolid, kColors, kPigments, kAverage, kImage };

  void open(const Pigment& base) {
    quick_color_ = base.quick_color;
    has_quick_color_ = base.has_quick_color;
    std::visit([this](const auto& data) { open_data(data); }, base.data);
  }
  void open_data(const SolidPigment& data) {
    kind_ = Kind::kSolid;
    color_ = data.color;
  }
  void open_data(const ColorMapPigment& data) {
    kind_ = Kind::kColors;
    pattern_ = data.pattern;
    colors_ = data.entries;
  }
  void open_data(const PigmentMapPigment& data) {
    kind_ = Kind::kPigments;
    pattern_ = data.pattern;
    pigments_ = data.entries;
  }
  void open_data(const AveragePigment& data) {
    kind_ = Kind::kAverage;
    pattern_.warps = data.warps;
    pigments_ = data.entries;
  }
  void open_data(const ImagePigment& data) {
    kind_ = Kind::kImage;
    pattern_.warps = data.warps;
    image_ = data.image;
  }
  void open_data(const UvPigment& data) {
    uv_ = true;
    const Pigment inner = at(parser_.scene().pigments, data.pigment);
    open(inner);
  }

  Pigment close() {
    Pigment pigment;
    const bool list = parts_of(pattern_) > 0;
    switch (kind_) {
      case Kind::kSolid:
        pigment.data = SolidPigment{color_};
        break;
      case Kind::kColors:
        if (colors_.empty()) colors_ = default_colors(pattern_);
        pigment.data = ColorMapPigment{std::move(pattern_), std::move(colors_), list};
        break;
      case Kind::kPigments:
        pigment.data = PigmentMapPigment{std::move(pattern_), std::move(pigments_), list};
        break;
      case Kind::kAverage:
        if (pigments_.empty()) parser_.fail("average needs a pigment_map");
        pigment.data = AveragePigment{std::move(pigments_), std::move(pattern_.warps)};
        break;
      case Kind::kImage:
        pigment.data = ImagePigment{image_, std::move(pattern_.warps)};
        break;
    }
    return pigment;
  }

  bool parse_one() {
    if (parser_.accept(',')) return true;
    if (const auto named = pov::take<PigmentId>(parser_)) {
      const Pigment base = at(parser_.scene().pigments, *named);
      *this = PigmentParser(parser_, base);
      return true;
    }
    return parse_special() || parse_map_block() || parse_kind() ||
           parse_pattern_modifier(parser_, pattern_) || parse_color();
  }

  bool parse_special() {
    switch (keyword_at(parser_)) {
      case Keyword::kAverage:
        parser_.next();
        kind_ = Kind::kAverage;
        pigments_.clear();
        return true;
      case Keyword::kImageMap:
        parser_.next();
        image_ = parse_image(parser_, ImageUse::kColor);
        kind_ = Kind::kImage;
        return true;
      case Keyword::kUvMapping:
        parser_.next();
        uv_ = parser_.parse_flag();
        return true;
      case Keyword::kQuickColor:
      case Keyword::kQuickColour:
        parser_.next();
        quick_color_ = parser_.parse_color();
        has_quick_color_ = true;
        return true;
      default:
        return false;
    }
  }

  bool parse_map_block() {
    switch (keyword_at(parser_)) {
      case Keyword::kColorMap:
      case Keyword::kColourMap:
        refuse_parts("color_map");
        parser_.next();
        colors_ = parse_color_map(parser_);
        kind_ = Kind::kColors;
        return true;
      case Keyword::kPigmentMap:
        refuse_parts("pigment_map");
        parser_.next();
        pigments_ = parse_pigment_map(parser_);
        if (kind_ != Kind::kAverage) kind_ = Kind::kPigments;
        return true;
      default:
        return false;
    }
  }

  void refuse_parts(const std::string& map) {
    if (kind_ == Kind::kAverage || parts_of(pattern_) == 0) return;
    parser_.fail("this pattern takes a list, not a " + map,
                 "write the colours or pigments one after the other");
  }

  bool parse_kind() {
    const std::size_t parts_before = parts_of(pattern_);
    const auto block = parse_pattern_kind(parser_, pattern_);
    if (!block) return false;
    if (kind_ == Kind::kSolid || kind_ == Kind::kAverage || kind_ == Kind::kImage) {
      kind_ = Kind::kColors;
      colors_.clear();
    }
    if (block->parts > 0 || parts_before > 0) {
      kind_ = Kind::kColors;
      colors_.clear();
    }
    if (block->parts > 0) parse_list(block->parts);
    if (block->in_braces) parser_.expect('}', "after the list of the object pattern");
    return true;
  }

  /// Colours, or pigments, of the parts; those left out have the pattern's usual colours.
  void parse_list(std::size_t parts) {
    colors_ = default_colors(pattern_);
    if (parser_.at(Keyword::kPigment)) {
      kind_ = Kind::kPigments;
      pigments_.clear();
      while (pigments_.size() < parts && parser_.accept(Keyword::kPigment)) {
        pigments_.push_back({static_cast<double>(pigments_.size()), parse_pigment(parser_, {})});
        parser_.skip_comma();
      }
      fill_pigments(parts);
      return;
    }
    for (std::size_t i = 0; i < parts && parser_.at_color(); ++i) {
      colors_[i].color = parser_.parse_color();
      parser_.skip_comma();
    }
  }

  void fill_pigments(std::size_t parts) {
    for (std::size_t i = pigments_.size(); i < parts; ++i) {
      Pigment solid;
      solid.data = SolidPigment{colors_[i].color};
      pigments_.push_back({static_cast<double>(i), append(parser_.scene().pigments, solid)});
    }
  }

  bool parse_color() {
    if (!parser_.at_color()) return false;
    color_ = parser_.parse_color();
    kind_ = Kind::kSolid;
    return true;
  }

  PigmentParser& operator=(PigmentParser&& other) noexcept {
    kind_ = other.kind_;
    pattern_ = std::move(other.pattern_);
    color_ = other.color_;
    colors_ = std::move(other.colors_);
    pigments_ = std::move(other.pigments_);
    image_ = other.image_;
    uv_ = other.uv_;
    quick_color_ = other.quick_color_;
    has_quick_color_ = other.has_quick_color_;
    return *this;
  }

  Parser& parser_;
  Kind kind_ = Kind::kSolid;
  Pattern pattern_;
  PigmentColor color_;
  std::vector<ColorEntry> colors_;
  std::vector<PigmentEntry> pigments_;
  ImageId image_;
  bool uv_ = false;
  PigmentColor quick_color_;
  bool has_quick_color_ = false;
};

/// The pigment of the default texture.
PigmentId default_pigment(Parser& parser) {
  const Scene& scene = parser.scene();
  const auto* layers =
      std::get_if<LayeredTexture>(&at(scene.textures, default_texture(parser)).data);
  return layers && !layers->layers.empty() ? layers->layers[0].pigment : PigmentId{};
}

/// The contents of a pigment; a lone name keeps its pigment as it is.
PigmentId parse_contents(Parser& parser, PigmentId base, char close) {
  if (!base) base = default_pigment(parser);
  if (const auto named = take<PigmentId>(parser)) {
    base = *named;
    if (parser.at(close)) return base;
  }
  const Pigment begin = base ? at(parser.scene().pigments, base) : Pigment{};
  PigmentParser contents(parser, begin);
  contents.parse(close);
  return append_once(parser.scene().pigments, contents.take());
}

}  // namespace

PigmentId parse_pigment(Parser& parser, PigmentId base) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "after pigment");
  const PigmentId pigment = parse_contents(parser, base, '}');
  parser.next();
  return pigment;
}

PigmentId parse_pigment_entry(Parser& parser) {
  const Parser::Nesting nesting(parser);
  return parse_contents(parser, {}, ']');
}

Pigment parse_pigment_block(Parser& parser) {
  return at(parser.scene().pigments, parse_pigment(parser, {}));
}

PigmentId transformed(Parser& parser, PigmentId id, const Affine& by) {
  Pigment pigment = at(parser.scene().pigments, id);
  if (std::holds_alternative<SolidPigment>(pigment.data) ||
      std::holds_alternative<UvPigment>(pigment.data)) {
    return id;
  }
  if (auto* colors = std::get_if<ColorMapPigment>(&pigment.data)) {
    add_transform(colors->pattern.warps, by);
  } else if (auto* pigments = std::get_if<PigmentMapPigment>(&pigment.data)) {
    add_transform(pigments->pattern.warps, by);
  } else if (auto* average = std::get_if<AveragePigment>(&pigment.data)) {
    add_transform(average->warps, by);
  } else if (auto* image = std::get_if<ImagePigment>(&pigment.data)) {
    add_transform(image->warps, by);
  }
  return append_once(parser.scene().pigments, std::move(pigment));
}

}  // namespace dioptre::pov
