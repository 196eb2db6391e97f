// SPDX-License-Identifier: Apache-2.0
// #declare, #local, #undef and the values that can be declared.
#include <cmath>

#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {

std::string_view Interpreter::type_name(const Value& value) const {
  if (const Numeric* n = std::get_if<Numeric>(&value)) {
    return n->size == 1 ? "number" : n->color ? "colour" : "vector";
  }
  static constexpr std::string_view kNames[] = {"nothing", "number",   "string", "array",
                                                "macro",   "function", "spline", "file"};
  if (value.index() < std::size(kNames)) return kNames[value.index()];
  static constexpr std::string_view kDescribed[] = {
      "object",     "light",       "texture",    "pigment",   "normal",      "finish",
      "interior",   "material",    "camera",     "transform", "fog",         "sky sphere",
      "colour map", "pigment map", "normal map", "slope map", "texture map", "thing"};
  return kDescribed[std::get<DescribedPtr>(value)->index()];
}

Interpreter::Target Interpreter::parse_target(bool local) {
  if (raw().is(Keyword::kDeprecated)) return parse_deprecated_target(local);
  Target target;
  target.local = local;
  target.scope = scopes_.level();
  target.position = raw().position;
  target.name = new_name("the name to declare");
  if (raw().is('[')) parse_subscripts(target.subscripts);
  return target;
}

/// After `deprecated`: perhaps `once` and a text, then the target.
Interpreter::Target Interpreter::parse_deprecated_target(bool local) {
  skip_raw();
  Target target;
  const bool once = raw().is(Keyword::kOnce);
  if (once) skip_raw();
  std::string text;
  if (raw().kind == Token::Kind::kString) text = parse_string();
  target = parse_target(local);
  target.deprecated = true;
  target.deprecated_once = once;
  target.deprecation =
      text.empty() ? symbols_.name(target.name) + " was declared deprecated" : text;
  return target;
}

/// A name that gets a meaning. An author's name wins over a reserved word that is not needed to
/// write expressions: the word may be newer than the scene.
Symbol Interpreter::new_name(std::string_view what) {
  const SourcePosition where = raw().position;
  const Symbol name = raw_identifier(what);
  if (name >= kKeywordCount) return name;
  const auto k = static_cast<Keyword>(name);
  const std::optional<double> variable = built_in_variable(k);
  if (!variable && (keyword_begins_expression(k) || is_color_keyword(k))) {
    fail_at(where, "'" + symbols_.name(name) + "' is a reserved word: it cannot be declared",
            "give it another name");
  }
  const bool free =
      k == Keyword::kAtand || k == Keyword::kSqr || k == Keyword::kCube || variable.has_value();
  if (!free) {
    forgive(where,
            "'" + symbols_.name(name) + "' is a reserved word: from here on it is the scene's name",
            "give it another name");
  }
  const Symbol fresh = symbols_.free_keyword(name);
  if (variable) {
    Binding& binding = scopes_.global(fresh);
    binding.value = number(*variable);
    binding.assigned = true;
  }
  for (const auto& program : programs_) {
    for (Token& token : program->tokens) {
      if (token.is(k)) token.index = fresh;
    }
  }
  return fresh;
}

void Interpreter::run_declare(bool local) {
  Target target = parse_target(local);
  if (!raw().is('=')) {
    fail_at(raw().position, "expected '=' after the name, found " + found(raw()),
            "write #declare NAME = VALUE;");
  }
  skip_raw();
  const auto depth = value_depth_;
  const auto blocks = value_blocks_, frames = value_frames_;
  const auto begin = value_begin_;
  value_depth_ = depth_;
  value_blocks_ = blocks_.size();
  value_frames_ = frames_.size();
  value_begin_ = taken_;
  Value value = parse_value(target.name);
  end_declaration(value, target);
  value_depth_ = depth;
  value_blocks_ = blocks;
  value_frames_ = frames;
  value_begin_ = begin;
  // A token that was held back as the end of the value is looked at anew.
  if (!pending_) ready_ = false;
  assign(target, std::move(value));
}

/// Numbers end with a semicolon; behind anything else it may be there.
void Interpreter::end_declaration(const Value& value, const Target& target) {
  if (!pending_ && raw().is(';')) {
    skip_raw();
    return;
  }
  // A macro that gave the value has to come to its end before the semicolon is seen.
  const bool within_macro = frames_.size() > value_frames_;
  const bool numeric = std::holds_alternative<Numeric>(value);
  if ((numeric || within_macro) && accept(';')) return;
  if (!numeric) return;
  if (version_given_ && version_ < 3.5) return;
  forgive(target.position,
          "the declaration of " + symbols_.name(target.name) + " has no ';' at its end");
}

void Interpreter::assign(const Target& target, Value value) {
  ++effects_;
  if (target.subscripts.count > 0) {
    Binding* binding = scopes_.find(target.name);
    if (!binding) fail_undeclared(target.position, target.name);
    Value* place = locate(binding->value, target.subscripts, target.position, true);
    deepen(*std::get<std::shared_ptr<Array>>(binding->value), value,
           static_cast<std::uint32_t>(target.subscripts.count));
    *place = std::move(value);
    binding->assigned = true;
    return;
  }
  Binding* binding = target.local ? scopes_.local(target.name, target.scope) : nullptr;
  if (!binding) binding = &scopes_.global(target.name);
  binding->value = std::move(value);
  binding->assigned = true;
  binding->deprecated = target.deprecated;
  if (target.deprecated) {
    binding->deprecated_once = target.deprecated_once;
    binding->deprecation = target.deprecation;
  }
}

void Interpreter::warn_deprecated(Binding& binding) {
  Diagnostic d = diagnostic(Severity::kWarning, cursor_->position, binding.deprecation);
  count_message(d.message.size() + d.source_line.size());
  diagnostics_.report(std::move(d));
  if (binding.deprecated_once) binding.deprecated = false;
}

void Interpreter::run_undef() {
  const SourcePosition where = raw().position;
  const Symbol name = raw_identifier("the name to forget");
  ++effects_;
  Binding* binding = raw().is('[') ? scopes_.find(name) : nullptr;
  if (binding) {
    Subscripts subscripts;
    parse_subscripts(subscripts);
    *locate(binding->value, subscripts, where, true) = {};
  } else {
    scopes_.undefine(name);
  }
  if (raw().is(';')) skip_raw();
}

/// Any value that may stand behind an equals sign, in an array or as an argument.
Value Interpreter::parse_value(Symbol name) {
  const Token& token = peek();
  if (token.is(Keyword::kArray)) return parse_array();
  if (token.is(Keyword::kFunction)) return parse_function_value(symbols_.name(name));
  if (token.is(Keyword::kSpline)) return parse_spline();
  if (const Value* value = operand()) {
    if (!value_is_numeric(*value) && !std::holds_alternative<DescribedPtr>(*value)) {
      if (at_string()) return std::make_shared<const std::string>(parse_string());
      Value copy = *value;
      next();
      return copy;
    }
    const bool callable = get_if<const FunctionValue>(*value) || get_if<const Spline>(*value);
    if (callable && !cursor_[pending_ ? 0 : 1].is('(')) {
      Value copy = *value;
      next();
      return copy;
    }
  }
  if (at_string()) return std::make_shared<const std::string>(parse_string());
  if (at_color_keyword()) return stored(color_terms());
  if (at_expression()) return stored(sum());
  if (DescribedPtr described = parse_described(*this)) return described;
  fail_expected("a value");
}

/// After `array`: the sizes, then perhaps the elements.
Value Interpreter::parse_array() {
  next();
  auto array = std::make_shared<Array>();
  std::uint64_t total = 1;
  while (at('[')) {
    next();
    const double size = float_argument();
    if (!(size >= 1)) fail("an array needs at least one element", "write array[SIZE]");
    constexpr double kLargest = 4294967295;
    array->sizes.push_back(static_cast<std::uint32_t>(std::min(size, kLargest)));
    if (array->sizes.size() > 5) fail("an array has at most 5 dimensions");
    total *= array->sizes.back();
    check_elements(total);
    expect(']', "after the size");
  }
  if (array->sizes.empty()) return counted_array();
  array->elements.resize(total);
  if (!pending_ && peek().is('{')) {
    std::size_t place = 0;
    fill_array(*array, 0, place);
  }
  return array;
}

/// `array { ... }` and `array mixed { ... }` of POV-Ray 3.8: as large as its elements are many,
/// which may be lists in braces themselves.
std::shared_ptr<Array> Interpreter::counted_array() {
  const Nesting guard(*this);
  const Token& token = peek();
  const bool mixed = token.kind == Token::Kind::kName && symbols_.name(token.index) == "mixed";
  if (!mixed && !token.is('{')) fail_expected("'[' and the size of the array");
  if (!newer_language_) {
    forgive(token.position, "an array without a size is of POV-Ray 3.8", "write array[SIZE]");
  }
  if (mixed) next();
  expect('{', "before the elements");
  auto array = std::make_shared<Array>();
  while (!at('}')) {
    check_elements(array->elements.size() + 1);
    Value element = at('{') ? Value(counted_array()) : parse_value(0);
    deepen(*array, element, 1);
    array->elements.push_back(std::move(element));
    skip_comma();
  }
  if (array->elements.empty()) fail("an array needs at least one element", "write array[SIZE]");
  next();
  array->sizes.push_back(static_cast<std::uint32_t>(array->elements.size()));
  return array;
}

void Interpreter::fill_array(Array& array, std::size_t dimension, std::size_t& place) {
  const Nesting guard(*this);
  expect('{', "before the elements");
  std::size_t stride = 1;
  for (std::size_t d = dimension + 1; d < array.sizes.size(); ++d) stride *= array.sizes[d];
  const std::size_t last = place + stride * array.sizes[dimension];
  while (!at('}')) {
    if (place >= last) {
      fail("more elements than the " + std::to_string(array.sizes[dimension]) + " of the array");
    }
    if (dimension + 1 < array.sizes.size()) {
      fill_array(array, dimension + 1, place);
    } else {
      array.elements[place] = parse_value(0);
      deepen(array, array.elements[place++], 1);
    }
    skip_comma();
  }
  next();
  place = last;
}

/// Arrays within arrays are counted, so that none is too deep to be let go of.
void Interpreter::deepen(Array& array, const Value& element, std::uint32_t levels) {
  const Array* inner = get_if<Array>(element);
  if (!inner) return;
  array.depth = std::max(array.depth, inner->depth + levels);
  if (array.depth > options_.budgets.nesting) over_nesting();
}

/// `[i][j]...` at the next tokens.
void Interpreter::parse_subscripts(Subscripts& subscripts) {
  const Nesting guard(*this);
  while (raw().is('[')) {
    if (subscripts.count == subscripts.at.size()) fail("more subscripts than any array has");
    skip_raw();
    const bool held = pending_;
    pending_ = false;
    ++depth_;
    const double at = float_argument();
    --depth_;
    pending_ = held;
    if (!peek().is(']')) fail_expected("']' after the subscript");
    skip_raw();
    subscripts.at[subscripts.count++] = at;
  }
}

/// The element that the subscripts lead to. For a change, arrays on the way that others share are
/// copied first.
Value* Interpreter::locate(Value& root, const Subscripts& subscripts, SourcePosition where,
                           bool for_change) {
  Value* value = &root;
  std::size_t used = 0;
  while (used < subscripts.count) {
    auto* holder = std::get_if<std::shared_ptr<Array>>(value);
    if (!holder) {
      fail_at(where, "expected an array before '[', found a " + std::string(type_name(*value)));
    }
    if (for_change && holder->use_count() > 1) {
      check_elements((*holder)->elements.size());
      *holder = std::make_shared<Array>(**holder);
    }
    Array& array = **holder;
    if (subscripts.count - used < array.sizes.size()) {
      fail_at(where, "expected " + std::to_string(array.sizes.size()) + " subscripts, found " +
                         std::to_string(subscripts.count - used));
    }
    std::size_t place = 0;
    for (const std::uint32_t size : array.sizes) {
      const double at = subscripts.at[used++];
      if (!(at > -1 && at < size)) {
        fail_at(where,
                "the subscript " + shortest(std::trunc(at)) +
                    " is outside the array, whose size is " + std::to_string(size),
                "subscripts count from 0");
      }
      place = place * size + static_cast<std::size_t>(at);
    }
    value = &array.elements[place];
  }
  return value;
}

}  // namespace dioptre::pov
