// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "dioptre/io/pov/value.h"

namespace dioptre::pov {

/// One meaning of a name. A macro's parameter may be an alias for the caller's own binding.
struct Binding {
  Value value;
  Binding* outer = nullptr;   ///< what the name meant before
  Binding* target = nullptr;  ///< of an alias
  Symbol symbol = 0;
  std::uint32_t level = 0;    ///< the scope it belongs to
  std::uint32_t aliases = 0;  ///< how many bindings have this one as their target
  bool assigned = true;       ///< false: still has the value that it was made with
  bool linked = true;         ///< false: no name leads here any more, only aliases
  bool deprecated = false, deprecated_once = false;
  std::string deprecation;  ///< what to say when it is used
};

/// Names and what they mean now. Scopes are dynamic: the newest binding of a name counts, whoever
/// asks. Looking up is one array access.
class Scopes {
 public:
  Scopes() { marks_.push_back(0); }

  /// The newest binding of a name, aliases followed; null if it has none.
  Binding* find(Symbol symbol) const {
    if (symbol >= tops_.size() || !tops_[symbol]) return nullptr;
    Binding* binding = tops_[symbol];
    return binding->target ? binding->target : binding;
  }
  /// What #declare sets: the newest binding, or a new global one.
  Binding& global(Symbol symbol);
  /// What #local sets: the binding of the given scope, made if needed. Null if that scope has been
  /// left.
  Binding* local(Symbol symbol, std::uint32_t level);
  /// Makes `symbol` in the innermost scope another name for `target`.
  void alias(Symbol symbol, Binding& target);
  /// Forgets the newest meaning of a name.
  void undefine(Symbol symbol);

  /// Keeps a binding from being reused until it is let go.
  void hold(Binding& binding) { ++binding.aliases; }
  void let_go(Binding& binding) {
    if (--binding.aliases == 0 && !binding.linked) release(binding);
  }

  void enter() { marks_.push_back(linked_.size()); }
  void leave();
  std::uint32_t level() const { return static_cast<std::uint32_t>(marks_.size() - 1); }

 private:
  Binding& link(Symbol symbol);
  void release(Binding& binding);

  std::deque<Binding> pool_;
  std::vector<Binding*> free_;
  std::vector<Binding*> tops_;      ///< by symbol
  std::vector<Symbol> linked_;      ///< in the order of linking, scopes above the global one only
  std::vector<std::size_t> marks_;  ///< where each scope begins in linked_
};

}  // namespace dioptre::pov
