// SPDX-License-Identifier: Apache-2.0
// Patterns, their modifiers and the maps that colour them, for pigments, normals and textures.
#pragma once

#include <functional>
#include <optional>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {

/// How a block of a pattern begins that divides space into numbered parts.
struct BlockPattern {
  std::size_t parts = 0;   ///< 0: a pattern with values, not with parts
  bool in_braces = false;  ///< the list of parts follows within braces that are still open
};
/// Reads the keyword of a pattern with what belongs to it; nothing if none is next.
std::optional<BlockPattern> parse_pattern_kind(Parser& parser, Pattern& pattern);
/// How many parts a pattern divides space into; 0 if it has values.
std::size_t parts_of(const Pattern& pattern);
/// Reads one modifier of a pattern: a wave, frequency, phase, or a parameter of its kind.
bool parse_pattern_modifier(Parser& parser, Pattern& pattern);
/// Reads one change of space: transformations, turbulence or a warp.
bool parse_warp_modifier(Parser& parser, std::vector<Warp>& warps);
/// Appends a transformation to what is written so far.
void add_transform(std::vector<Warp>& warps, const Affine& by);
/// What a pixel takes while an image is decoded, at most.
inline constexpr std::uint64_t kDecodedPixelBytes = 32;
/// Takes the keyword of an image's format, if one is next, else kNotAKeyword.
Keyword take_image_format(Parser& parser);
/// The path of an image, from its name. The format tells how the name may end if it does not say:
/// how the file is read follows from its content.
std::string parse_image_path(Parser& parser, Keyword format);
/// What the pixels of an image stand for.
enum class ImageUse : std::uint8_t { kColor, kPattern, kBumps, kNumbers };
/// Reads `image_map { ... }` and its relatives, behind the keyword.
/// `other` reads what else may stand in the braces, and says whether it did.
ImageId parse_image(Parser& parser, ImageUse use, const std::function<bool()>& other = {});
/// The colours that a pattern has without a map.
std::vector<ColorEntry> default_colors(const Pattern& pattern);

/// `{ [position entry] ... }` behind the keyword of a map; an entry is read up to the bracket.
template <class Entry, class Value, class ReadEntry>
std::vector<Entry> parse_map(Parser& parser, ReadEntry read_entry) {
  const Parser::Nesting nesting(parser);
  parser.expect('{', "to begin the map");
  std::vector<Entry> entries;
  if (const auto named = take<Value>(parser)) entries = named->entries;
  while (parser.accept('[')) {
    // An average may leave out the weight.
    const double position = parser.at_expression() ? parser.parse_float() : 1;
    parser.skip_comma();
    read_entry(position, entries);
    parser.expect(']', "after the entry of the map");
    parser.skip_comma();
  }
  parser.expect('}', "after the map");
  if (entries.empty()) parser.fail("the map is empty", "give it entries, such as [0 rgb 0]");
  return entries;
}

/// A colour map behind its keyword.
std::vector<ColorEntry> parse_color_map(Parser& parser);
/// Pigments, normals and textures in a map: without braces, up to the bracket.
PigmentId parse_pigment_entry(Parser& parser);
NormalId parse_normal_entry(Parser& parser);
TextureId parse_texture_entry(Parser& parser);
std::vector<PigmentEntry> parse_pigment_map(Parser& parser);
std::vector<NormalEntry> parse_normal_map(Parser& parser);
std::vector<SlopeEntry> parse_slope_map(Parser& parser);
std::vector<TextureEntry> parse_texture_map(Parser& parser);

/// A pigment or normal moved.
PigmentId transformed(Parser& parser, PigmentId pigment, const Affine& by);
NormalId transformed(Parser& parser, NormalId normal, const Affine& by);

}  // namespace dioptre::pov
