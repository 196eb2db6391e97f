// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// Solid letters: the outlines of a font in the x-y plane, from z = 0 to z = thickness (which may
/// be negative), the first letter's left end at x = 0, its base line at y = 0, the em square 1
/// high. Letters that overlap are one solid.
struct Text {
  static constexpr const char* kName = "text";
  std::string font;  ///< path of a TrueType or OpenType file, as found by the reader
  std::string text;  ///< UTF-8
  double thickness = 1;
  Vec3 offset;  ///< x and y are added to the pen after each letter; z does nothing

  bool operator==(const Text&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("font", self.font);
    visit("text", self.text);
    visit("thickness", self.thickness);
    visit("offset", self.offset);
  }
};

/// Checks the parameters and does all work that does not depend on a ray. An error for a
/// font that cannot be read or has no outlines, and for numbers that are not finite.
Result<ShapePtr> prepare(const Text& text);

}  // namespace dioptre
