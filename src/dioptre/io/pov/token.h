// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/source.h"

namespace dioptre::pov {

/// Every name of a program is interned once; the reserved words have the smallest numbers, in the
/// order of keywords.def.
using Symbol = std::uint32_t;

/// The reserved words, `kSphere` for `sphere`, `kAreaLight` for `area_light`.
enum class Keyword : std::uint16_t {
#define DIOPTRE_KEYWORD(name, text) k##name,
#include "dioptre/io/pov/keywords.def"
#undef DIOPTRE_KEYWORD
  kNotAKeyword  ///< also the number of keywords
};

/// One token of a file, made once however often it is run.
struct Token {
  enum class Kind : std::uint8_t { kEnd, kNumber, kString, kName, kPunctuation, kDirective };
  Kind kind = Kind::kEnd;
  char punctuation = 0;     ///< one of (){}[]<>,;:=+-*/?!&|. or 'l' <=, 'g' >=, 'n' !=
  std::uint32_t index = 0;  ///< kName, kDirective: symbol; kString: in the file's strings
  double number = 0;
  SourcePosition position;

  bool is(char c) const { return kind == Kind::kPunctuation && punctuation == c; }
  bool is(Keyword k) const { return kind == Kind::kName && index == static_cast<std::uint32_t>(k); }
};

}  // namespace dioptre::pov
