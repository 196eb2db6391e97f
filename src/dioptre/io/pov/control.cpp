// SPDX-License-Identifier: Apache-2.0
// Branches and loops.
#include <cmath>

#include "dioptre/core/expression_eval.h"
#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {

const Token* Interpreter::branch_of(const Token& token) {
  const std::uint32_t at =
      program_->branch[static_cast<std::size_t>(&token - program_->tokens.data())];
  if (at == Program::kNowhere) {
    fail_at(token.position, "#" + symbols_.name(token.index) + " without #end");
  }
  return &program_->tokens[at];
}

const Token* Interpreter::end_of(const Token& token) {
  const std::uint32_t at =
      program_->end[static_cast<std::size_t>(&token - program_->tokens.data())];
  if (at == Program::kNowhere) {
    fail_at(token.position, "#" + symbols_.name(token.index) + " without #end");
  }
  return &program_->tokens[at];
}

bool Interpreter::parse_condition() {
  expect('(', "before the condition");
  const Numeric value = full();
  if (value.size != 1) fail("expected a number as the condition, found a vector");
  // The directive that follows the ')' must not run before the branch is chosen: do not peek.
  if (!peek().is(')')) fail_expected("')' after the condition");
  next();
  return is_true(value.v[0]);
}

/// Goes into the branch after `token` (its condition has been read) or on to the next branch.
void Interpreter::begin_if(const Token& token, bool condition) {
  const Token* branch = branch_of(token);
  Block block;
  block.end = end_of(token);
  blocks_.push_back(block);
  if (condition) return;
  for (;;) {
    const auto keyword = static_cast<Keyword>(branch->index);
    move_to(branch + 1);
    if (keyword == Keyword::kEnd) {
      blocks_.pop_back();
      return;
    }
    if (keyword == Keyword::kElse) return;
    if (keyword != Keyword::kElseif) {
      fail_at(branch->position, "#" + symbols_.name(branch->index) + " without #switch");
    }
    if (parse_condition()) return;
    branch = branch_of(*branch);
  }
}

void Interpreter::run_if(const Token& token) { begin_if(token, parse_condition()); }

void Interpreter::run_ifdef(const Token& token, bool wanted) {
  begin_if(token, parse_defined() == wanted);
}

/// `(NAME)` or `(ARRAY[i])`: whether it has a value.
bool Interpreter::parse_defined() {
  if (!raw().is('('))
    fail_at(raw().position, "expected '(' before the name, found " + found(raw()));
  open_raw();
  const SourcePosition where = raw().position;
  const Symbol name = raw_identifier("a name");
  Binding* binding = scopes_.find(name);
  const Value* value = binding ? &binding->value : nullptr;
  if (raw().is('[')) {
    Subscripts subscripts;
    parse_subscripts(subscripts);
    if (!binding) fail_undeclared(where, name);
    value = locate(binding->value, subscripts, where, false);
  }
  expect(')', "after the name");
  return name < kKeywordCount || (value && is_set(*value));
}

/// #else, #elseif, #case or #range met while running: the branch before it is over.
void Interpreter::run_else(const Token& token) {
  Block& block = innermost(token, "#if or #switch");
  if (block.kind == Block::Kind::kIf) {
    move_to(block.end + 1);
    blocks_.pop_back();
  } else if (block.kind != Block::Kind::kSwitch) {
    fail_at(token.position, "#" + symbols_.name(token.index) + " without #if or #switch");
  } else if (static_cast<Keyword>(token.index) != Keyword::kElse) {
    case_holds(token);  // falls through, whatever the values say
  }
}

Interpreter::Block& Interpreter::innermost(const Token& token, std::string_view directive) {
  const std::size_t outer = frames_.empty() ? 0 : frames_.back().blocks;
  if (blocks_.size() <= outer) {
    fail_at(token.position,
            "#" + symbols_.name(token.index) + " without " + std::string(directive));
  }
  return blocks_.back();
}

void Interpreter::run_end(const Token& token) {
  Block& block = innermost(token, "an #if, #while, #for, #switch or #macro before it");
  switch (block.kind) {
    case Block::Kind::kIf:
    case Block::Kind::kSwitch:
      blocks_.pop_back();
      break;
    case Block::Kind::kMacro:
      leave_frame();
      break;
    case Block::Kind::kWhile:
      if (block.effects == effects_ + taken_) {
        fail_at(token.position, "this #while never ends: nothing in it changes its condition");
      }
      move_to(block.begin);
      next_round(block);
      break;
    case Block::Kind::kFor:
      next_for(block);
      break;
  }
}

void Interpreter::run_while(const Token& token) {
  Block block;
  block.kind = Block::Kind::kWhile;
  block.begin = cursor_;
  block.end = end_of(token);
  blocks_.push_back(block);
  next_round(blocks_.back());
}

/// At the condition of a #while: into its body, or behind its #end.
bool Interpreter::next_round(Block& block) {
  const Token* end = block.end;
  const std::size_t place = static_cast<std::size_t>(&block - blocks_.data());
  const std::uint64_t before = effects_;
  const bool again = parse_condition();
  if (again) {
    blocks_[place].effects = effects_ + taken_;
    if (effects_ != before) blocks_[place].effects = ~std::uint64_t{0};
  } else {
    blocks_.pop_back();
    move_to(end + 1);
  }
  return again;
}

void Interpreter::run_for(const Token& token) {
  if (!raw().is('(')) fail_at(raw().position, "expected '(' after #for, found " + found(raw()));
  open_raw();
  Block block;
  block.kind = Block::Kind::kFor;
  block.end = end_of(token);
  block.scope = scopes_.level();
  block.variable = new_name("the name of the loop's variable");
  expect(',', "after the loop's variable");
  const double first = float_argument();
  expect(',', "after the first value");
  block.last = float_argument();
  block.step = accept(',') ? float_argument() : 1;
  if (!at(')')) fail_expected("')' after the values of #for");
  if (std::fabs(block.step) < kEqualityTolerance || std::isnan(block.step)) {
    fail("the step of #for is 0", "it must lead from the first value to the last");
  }
  next();
  block.begin = cursor_;
  ++effects_;
  Binding* variable = scopes_.local(block.variable, block.scope);
  variable->value = number(first);
  const double over = (first - block.last) * (block.step > 0 ? 1 : -1);
  if (!(over < kEqualityTolerance)) {
    move_to(block.end + 1);
    return;
  }
  if (block.begin == block.end) {
    skip_empty_for(block, *variable);
    return;
  }
  blocks_.push_back(block);
}

/// A loop without a body only counts.
void Interpreter::skip_empty_for(Block& block, Binding& variable) {
  double value = std::get<Numeric>(variable.value).v[0];
  const double sign = block.step > 0 ? 1 : -1;
  while ((value - block.last) * sign < kEqualityTolerance) {
    const double following = value + block.step;
    count_step();
    if (following == value) {
      fail_at(block.end->position, "this #for never ends: its step is too small for its values");
    }
    value = following;
  }
  variable.value = number(value);
  move_to(block.end + 1);
}

void Interpreter::next_for(Block& block) {
  Binding* variable = scopes_.local(block.variable, block.scope);
  Numeric* counter = variable ? std::get_if<Numeric>(&variable->value) : nullptr;
  if (!counter || counter->size != 1) {
    fail_at(block.end->position,
            "the variable " + symbols_.name(block.variable) + " of #for is no longer a number");
  }
  const double before = counter->v[0];
  counter->v[0] += block.step;
  ++effects_;
  const double over = (counter->v[0] - block.last) * (block.step > 0 ? 1 : -1);
  if (over < kEqualityTolerance && counter->v[0] == before) {
    fail_at(block.end->position, "this #for never ends: its step is too small for its values");
  }
  if (over < kEqualityTolerance) {
    move_to(block.begin);
  } else {
    move_to(block.end + 1);
    blocks_.pop_back();
  }
}

void Interpreter::run_switch(const Token& token) {
  expect('(', "before the value of #switch");
  Block block;
  block.kind = Block::Kind::kSwitch;
  block.value = float_argument();
  block.end = end_of(token);
  if (!at(')')) fail_expected("')' after the value of #switch");
  next();
  blocks_.push_back(block);
  seek_case(branch_of(token));
}

/// Reads the values after #case or #range: whether they hold for the #switch.
bool Interpreter::case_holds(const Token& token) {
  const double value = blocks_.back().value;
  expect('(', "before the value");
  const double low = float_argument();
  double high = low;
  const bool range = static_cast<Keyword>(token.index) == Keyword::kRange;
  if (range) {
    expect(',', "after the lower value");
    high = float_argument();
  }
  if (!at(')')) fail_expected("')' after the value");
  next();
  return range ? low <= value && value <= high : are_equal(low, value);
}

/// From a branch of a #switch on: goes into the first that is true.
void Interpreter::seek_case(const Token* branch) {
  for (;;) {
    const auto keyword = static_cast<Keyword>(branch->index);
    if (keyword == Keyword::kEnd) {
      blocks_.pop_back();
      move_to(branch + 1);
      return;
    }
    move_to(branch + 1);
    if (keyword == Keyword::kElse) return;
    if (keyword == Keyword::kElseif) fail_at(branch->position, "#elseif in a #switch");
    if (case_holds(*branch)) return;
    branch = branch_of(*branch);
  }
}

/// Leaves the innermost loop, #switch or macro.
void Interpreter::run_break(const Token& token) {
  const std::size_t outer = frames_.empty() ? 0 : frames_.back().blocks;
  while (blocks_.size() > outer && blocks_.back().kind == Block::Kind::kIf) blocks_.pop_back();
  if (blocks_.size() <= outer) {
    fail_at(token.position, "#break without #switch, #while, #for or #macro");
  }
  if (blocks_.back().kind == Block::Kind::kMacro) {
    leave_frame();
    return;
  }
  const Token* end = blocks_.back().end;
  blocks_.pop_back();
  move_to(end + 1);
}

}  // namespace dioptre::pov
