// SPDX-License-Identifier: Apache-2.0
// #macro and the expansion of macro calls.
#include <optional>

#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

std::string arguments_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

}  // namespace

/// The name at the next token of the program, whatever it means.
Symbol Interpreter::raw_identifier(std::string_view what) {
  const Token& token = raw();
  if (token.kind != Token::Kind::kName) {
    if (token.kind == Token::Kind::kPunctuation && token.punctuation < ' ') fail_token(token);
    fail_at(token.position, "expected " + std::string(what) + ", found " + found(token));
  }
  skip_raw();
  return token.index;
}

void Interpreter::run_macro(const Token& token) {
  auto macro = std::make_shared<Macro>();
  macro->position = raw().position;
  macro->name = new_name("the name of the macro");
  macro->program = program_;
  if (!raw().is('(')) {
    fail_at(raw().position, "expected '(' after the name of the macro, found " + found(raw()),
            "write #macro NAME() if it has no parameters");
  }
  skip_raw();
  while (!raw().is(')')) {
    macro->parameters.push_back(new_name("the name of a parameter or ')'"));
    if (raw().is(',')) skip_raw();
  }
  macro->body = static_cast<std::uint32_t>(&raw() - program_->tokens.data()) + 1;
  const Token* end = end_of(token);
  macro->end = static_cast<std::uint32_t>(end - program_->tokens.data());
  const Symbol name = macro->name;
  ++effects_;
  scopes_.global(name).value = std::shared_ptr<const Macro>(std::move(macro));
  move_to(end + 1);
}

/// A call, at the macro's name: evaluates the arguments and goes into the body. A plain identifier
/// is passed by reference.
void Interpreter::expand_macro(std::shared_ptr<const Macro> called) {
  struct Argument {
    Value value;
    Binding* reference = nullptr;
    std::optional<ElementReference> element;
  };
  const Macro& macro = *called;
  const SourcePosition where = cursor_->position;
  if (frames_.size() + nesting_ >= options_.budgets.nesting) over_nesting();
  skip_raw();
  if (!raw().is('(')) {
    fail_at(raw().position,
            "expected '(' after the macro " + symbols_.name(macro.name) + ", found " + found(raw()),
            "a call needs parentheses even without arguments");
  }
  const Nesting guard(*this);
  next();
  std::vector<Argument> arguments;
  while (!at(')')) {
    if (arguments.size() == macro.parameters.size()) {
      fail_at(where, "the macro " + symbols_.name(macro.name) + " takes " +
                         arguments_text(macro.parameters.size()) + ", found more");
    }
    Argument argument;
    const Token name = peek();
    const auto ends = [](const Token& t) { return t.is(',') || t.is(')'); };
    const bool identifier = name.kind == Token::Kind::kName && name.index >= kKeywordCount;
    if (identifier && !pending_ && ends(cursor_[1])) {
      argument.reference = scopes_.find(name.index);
      if (!operand()) {
        fail_undeclared(name.position, name.index);
      }
      next();
    } else if (identifier && operand() && pending_ && ends(*cursor_)) {
      argument.value = pending_value_;
      argument.element = ElementReference{0, pending_binding_, pending_subscripts_};
      next();
    } else {
      argument.value = parse_value(macro.parameters[arguments.size()]);
    }
    arguments.push_back(std::move(argument));
    if (!accept(',') && !at(')') && arguments.size() == macro.parameters.size()) expect(')');
  }
  if (arguments.size() < macro.parameters.size()) {
    fail_at(where, "the macro " + symbols_.name(macro.name) + " takes " +
                       arguments_text(macro.parameters.size()) + ", found " +
                       std::to_string(arguments.size()));
  }
  next();
  ++effects_;
  frames_.push_back({program_, cursor_, std::move(called), where, blocks_.size(), {}});
  scopes_.enter();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].reference) {
      scopes_.alias(macro.parameters[i], *arguments[i].reference);
      continue;
    }
    Binding* parameter = scopes_.local(macro.parameters[i], scopes_.level());
    parameter->value = std::move(arguments[i].value);
    parameter->assigned = false;
    if (arguments[i].element) {
      arguments[i].element->parameter = macro.parameters[i];
      scopes_.hold(*arguments[i].element->array);
      frames_.back().elements.push_back(*arguments[i].element);
    }
  }
  Block block;
  block.kind = Block::Kind::kMacro;
  blocks_.push_back(block);
  program_ = macro.program;
  cursor_ = program_->tokens.data() + macro.body;
  ready_ = false;
}

/// Array elements that were passed by reference get what the macro has assigned.
void Interpreter::give_back_elements(const Frame& frame) {
  for (const ElementReference& element : frame.elements) {
    Binding* parameter = scopes_.find(element.parameter);
    const bool is_array = std::holds_alternative<std::shared_ptr<Array>>(element.array->value);
    if (parameter && parameter->assigned && is_array) {
      *locate(element.array->value, element.subscripts, frame.called, true) = parameter->value;
    }
    scopes_.let_go(*element.array);
  }
}

}  // namespace dioptre::pov
