// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

#include "dioptre/io/pov/token.h"

namespace dioptre::pov {

constexpr Symbol kKeywordCount = static_cast<Symbol>(Keyword::kNotAKeyword);

/// The names of a program, each with one number. The reserved words come first.
class Symbols {
 public:
  Symbols();
  Symbol intern(std::string_view name);
  const std::string& name(Symbol symbol) const { return names_[symbol]; }
  /// Lets a reserved word become a plain name from now on; returns its new number.
  Symbol free_keyword(Symbol keyword);
  std::size_t size() const { return names_.size(); }

 private:
  /// Eight letters at a time; names are short, and there are many.
  struct Hash {
    std::size_t operator()(std::string_view name) const;
  };

  std::deque<std::string> names_;  ///< a deque, so that the map's keys stay where they are
  std::unordered_map<std::string_view, Symbol, Hash> numbers_;
};

}  // namespace dioptre::pov
