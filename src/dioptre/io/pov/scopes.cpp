// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/scopes.h"

namespace dioptre::pov {

Binding& Scopes::link(Symbol symbol) {
  if (symbol >= tops_.size()) tops_.resize(symbol + 64, nullptr);
  Binding* binding;
  if (free_.empty()) {
    binding = &pool_.emplace_back();
  } else {
    binding = free_.back();
    free_.pop_back();
  }
  binding->symbol = symbol;
  binding->level = level();
  binding->outer = tops_[symbol];
  binding->linked = true;
  tops_[symbol] = binding;
  if (level() > 0) linked_.push_back(symbol);
  return *binding;
}

Binding& Scopes::global(Symbol symbol) {
  if (Binding* existing = find(symbol)) return *existing;
  Binding& binding = link(symbol);
  if (binding.level > 0) {
    binding.level = 0;
    linked_.pop_back();
  }
  return binding;
}

Binding* Scopes::local(Symbol symbol, std::uint32_t scope) {
  if (scope > level()) return nullptr;
  if (symbol < tops_.size() && tops_[symbol] && tops_[symbol]->level >= scope) return find(symbol);
  if (scope == 0) return &global(symbol);
  return scope == level() ? &link(symbol) : nullptr;
}

void Scopes::alias(Symbol symbol, Binding& target) {
  Binding& binding = link(symbol);
  binding.target = &target;
  ++target.aliases;
}

void Scopes::release(Binding& binding) {
  if (Binding* target = binding.target) {
    if (--target->aliases == 0 && !target->linked) release(*target);
  }
  binding.linked = false;
  if (binding.aliases > 0) return;
  binding = Binding();
  free_.push_back(&binding);
}

void Scopes::undefine(Symbol symbol) {
  if (symbol >= tops_.size() || !tops_[symbol]) return;
  Binding& binding = *tops_[symbol];
  tops_[symbol] = binding.outer;
  release(binding);
}

void Scopes::leave() {
  const std::size_t mark = marks_.back();
  while (linked_.size() > mark) {
    const Symbol symbol = linked_.back();
    linked_.pop_back();
    if (tops_[symbol] && tops_[symbol]->level == level()) undefine(symbol);
  }
  marks_.pop_back();
}

}  // namespace dioptre::pov
