// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/symbols.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace dioptre::pov {
namespace {

constexpr const char* kKeywords[] = {
#define DIOPTRE_KEYWORD(name, text) text,
#include "dioptre/io/pov/keywords.def"
#undef DIOPTRE_KEYWORD
};

}  // namespace

std::size_t Symbols::Hash::operator()(std::string_view name) const {
  std::uint64_t hash = name.size();
  while (!name.empty()) {
    std::uint64_t letters = 0;
    const std::size_t count = std::min(name.size(), sizeof letters);
    std::memcpy(&letters, name.data(), count);
    hash = (hash ^ letters) * 0x9E3779B97F4A7C15;
    hash ^= hash >> 32;
    name.remove_prefix(count);
  }
  return hash;
}

Symbols::Symbols() {
  numbers_.reserve(4 * std::size(kKeywords));
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
