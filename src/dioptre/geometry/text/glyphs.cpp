// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/text/glyphs.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <filesystem>
#include <map>
#include <memory>
#include <system_error>
#include <type_traits>
#include <utility>

namespace dioptre {
namespace {

constexpr std::size_t kMostLetters = 1'000'000;

struct LibraryDeleter {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct FaceDeleter {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using Library = std::unique_ptr<std::remove_pointer_t<FT_Library>, LibraryDeleter>;
using Face = std::unique_ptr<std::remove_pointer_t<FT_Face>, FaceDeleter>;

/// Turns FreeType's contours into curves, in em units.
struct Pencil {
  Outline outline;
  double scale = 1;
  Vec2 at;

  Vec2 point(const FT_Vector* p) const {
    return {static_cast<double>(p->x) * scale, static_cast<double>(p->y) * scale};
  }
  static int move(const FT_Vector* to, void* self) {
    auto& pencil = *static_cast<Pencil*>(self);
    pencil.at = pencil.point(to);
    pencil.outline.move_to(pencil.at);
    return 0;
  }
  int draw(const Curve& curve) {
    outline.add(curve);
    at = curve.end();
    return 0;
  }
  static int straight(const FT_Vector* to, void* self) {
    auto& pencil = *static_cast<Pencil*>(self);
    return pencil.draw(line(pencil.at, pencil.point(to)));
  }
  static int conic(const FT_Vector* a, const FT_Vector* to, void* self) {
    auto& pencil = *static_cast<Pencil*>(self);
    return pencil.draw(quadratic(pencil.at, pencil.point(a), pencil.point(to)));
  }
  static int cubed(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* self) {
    auto& pencil = *static_cast<Pencil*>(self);
    return pencil.draw(cubic(pencil.at, pencil.point(a), pencil.point(b), pencil.point(to)));
  }
};

/// The outline of the glyph in the face's slot.
Result<Outline> outline_of(FT_GlyphSlot slot, double scale) {
  if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return fail("has letters without outlines");
  Pencil pencil;
  pencil.scale = scale;
  FT_Outline_Funcs functions{};
  functions.move_to = &Pencil::move;
  functions.line_to = &Pencil::straight;
  functions.conic_to = &Pencil::conic;
  functions.cubic_to = &Pencil::cubed;
  if (FT_Outline_Decompose(&slot->outline, &functions, &pencil) != 0) {
    return fail("has a damaged letter");
  }
  pencil.outline.close();
  return std::move(pencil.outline);
}

/// Old fonts that map symbols keep them in a private block, or have no Unicode map at all.
FT_UInt glyph_index(FT_Face face, char32_t code) {
  const FT_UInt glyph = FT_Get_Char_Index(face, code);
  return glyph == 0 && code < 0x100 ? FT_Get_Char_Index(face, 0xf000 + code) : glyph;
}

class GlyphReader {
 public:
  GlyphReader(FT_Face face, const Text& text)
      : face_(face), text_(text), scale_(1.0 / face->units_per_EM) {}

  Result<GlyphRun> read(const std::vector<char32_t>& codes) {
    Vec3 pen;
    FT_UInt previous = 0;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      const FT_UInt glyph = glyph_index(face_, codes[i]);
      const auto letter = letter_of(glyph);
      if (!letter) return tl::unexpected<Error>(letter.error());
      pen.x += i == 0 ? -letter->bearing : kerning(previous, glyph);
      if (!run_.outlines[letter->outline].curves().empty()) {
        run_.glyphs.push_back({letter->outline, pen});
      }
      pen.x += letter->advance;
      pen += Vec3{text_.offset.x, text_.offset.y, 0};
      previous = glyph;
    }
    return std::move(run_);
  }

 private:
  struct Letter {
    std::uint32_t outline = 0;
    double advance = 0;
    double bearing = 0;  ///< from the pen to the outline's left end
  };

  Result<Letter> letter_of(FT_UInt glyph) {
    if (const auto known = letters_.find(glyph); known != letters_.end()) return known->second;
    if (FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0) {
      return fail("has a damaged letter");
    }
    Result<Outline> outline = outline_of(face_->glyph, scale_);
    if (!outline) return tl::unexpected<Error>(outline.error());
    Letter letter;
    letter.outline = static_cast<std::uint32_t>(run_.outlines.size());
    letter.advance = static_cast<double>(face_->glyph->metrics.horiAdvance) * scale_;
    letter.bearing = static_cast<double>(face_->glyph->metrics.horiBearingX) * scale_;
    run_.outlines.push_back(std::move(*outline));
    letters_.emplace(glyph, letter);
    return letter;
  }

  double kerning(FT_UInt left, FT_UInt right) const {
    FT_Vector by{};
    if (left == 0 || FT_Get_Kerning(face_, left, right, FT_KERNING_UNSCALED, &by) != 0) return 0;
    return static_cast<double>(by.x) * scale_;
  }

  FT_Face face_;
  const Text& text_;
  double scale_;
  GlyphRun run_;
  std::map<FT_UInt, Letter> letters_;
};

}  // namespace

Result<GlyphRun> load_glyphs(const Text& text) {
  const std::vector<char32_t> codes = decode_utf8(text.text);
  if (codes.size() > kMostLetters) return fail("text has over a million letters");
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(text.font, ignored)) {
    return fail("cannot read the font '" + text.font + "'");
  }
  FT_Library raw_library = nullptr;
  if (FT_Init_FreeType(&raw_library) != 0) return fail("cannot start the font reader");
  const Library library(raw_library);
  FT_Face raw_face = nullptr;
  if (FT_New_Face(library.get(), text.font.c_str(), 0, &raw_face) != 0) {
    return fail("'" + text.font + "' is not a font that can be read");
  }
  const Face face(raw_face);
  if (!FT_IS_SCALABLE(face) || face->units_per_EM == 0) {
    return fail("'" + text.font + "' has no outlines");
  }
  if (face->charmap == nullptr && face->num_charmaps > 0) {
    FT_Set_Charmap(face.get(), face->charmaps[0]);
  }
  Result<GlyphRun> run = GlyphReader(face.get(), text).read(codes);
  if (!run) return fail("font '" + text.font + "' " + run.error().message);
  return run;
}

}  // namespace dioptre
