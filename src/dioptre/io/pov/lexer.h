// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dioptre/io/pov/symbols.h"
#include "dioptre/io/pov/token.h"

namespace dioptre::pov {

/// A string literal: with its escapes replaced, and as written (for file names, where a backslash
/// is a separator).
struct Literal {
  std::string text;
  std::string written;
  bool bad_escape = false;
};

/// A file as tokens, with what is needed to leap over branches and loops.
struct Program {
  static constexpr std::uint32_t kNowhere = 0xffffffff;
  std::string name;  ///< as shown in messages
  std::string text;
  std::vector<std::uint32_t> lines;  ///< where each line begins in the text
  std::vector<Token> tokens;         ///< the last one is kEnd
  std::vector<Literal> literals;
  /// For #if, #ifdef, #ifndef, #elseif, #switch, #case, #range and #else: the token of the next
  /// branch or of the #end.
  std::vector<std::uint32_t> branch;
  /// For everything that #end ends: the token of that #end.
  std::vector<std::uint32_t> end;

  /// The text of a line, from 1, without its end.
  std::string_view line(std::uint32_t number) const;
};

// Tokens that stand for what cannot be read; they are errors only where they are met.
constexpr char kStrayCharacter = '\x01';      ///< `index` is the byte
constexpr char kUnterminatedString = '\x02';  ///< no closing quote
constexpr char kUnterminatedComment = '\x03';
constexpr char kBadNumber = '\x04';      ///< out of range
constexpr char kWideText = '\x06';       ///< the file is in UTF-16
constexpr char kTooManyTokens = '\x05';  ///< the rest is left out

/// Cuts a text into tokens, at most about `most_tokens`. Never fails: what cannot be read becomes a
/// token that says so.
Program lex(std::string name, std::string text, std::uint32_t file, Symbols& symbols,
            std::uint64_t most_tokens = UINT64_MAX);

}  // namespace dioptre::pov
