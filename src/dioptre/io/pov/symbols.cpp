// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/symbols.h"

namespace dioptre::pov {
namespace {

constexpr const char* kKeywords[] = {
#define DIOPTRE_KEYWORD(name, text) text,
#include "dioptre/io/pov/keywords.def"
#undef DIOPTRE_KEYWORD
};

}  // namespace

Symbols::Symbols() {
  for (const char* keyword : kKeywords) intern(keyword);
}

Symbol Symbols::intern(std::string_view name) {
  if (const auto found = numbers_.find(name); found != numbers_.end()) return found->second;
  const Symbol symbol = static_cast<Symbol>(names_.size());
  names_.emplace_back(name);
  numbers_.emplace(names_.back(), symbol);
  return symbol;
}

Symbol Symbols::free_keyword(Symbol keyword) {
  const Symbol symbol = static_cast<Symbol>(names_.size());
  names_.push_back(names_[keyword]);
  numbers_[names_[keyword]] = symbol;
  return symbol;
}

}  // namespace dioptre::pov
