// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/core/vec.h"
#include "dioptre/geometry/outline/outline.h"
#include "dioptre/geometry/text/text.h"

namespace dioptre {

/// A letter of a text: which outline, and where its origin is.
struct PlacedGlyph {
  std::uint32_t outline = 0;  ///< index into GlyphRun::outlines
  Vec3 pen;
};

/// The letters of a text, blank ones left out; each different letter's outline once.
struct GlyphRun {
  std::vector<Outline> outlines;  ///< in em units
  std::vector<PlacedGlyph> glyphs;
};

/// Reads the letters of the text from its font: unhinted outlines, advances and kerning pairs, all
/// divided by the em. A letter that the font lacks shows the font's sign for that. An error for a
/// font that cannot be read, and for a text of over a million letters.
Result<GlyphRun> load_glyphs(const Text& text);

/// The code points of UTF-8 text; U+FFFD for each byte that is not part of any.
std::vector<char32_t> decode_utf8(const std::string& text);

}  // namespace dioptre
