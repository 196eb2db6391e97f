// SPDX-License-Identifier: Apache-2.0
// Numbers, vectors and the operators between them.
#include <cmath>

#include "dioptre/core/expression_eval.h"
#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

double apply(char op, double a, double b) {
  switch (op) {
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    case '/':
      return a / b;
    case '<':
      return a < b;
    case '>':
      return a > b;
    case 'l':
      return a <= b || are_equal(a, b);
    case 'g':
      return a >= b || are_equal(a, b);
    case '=':
      return are_equal(a, b);
    case 'n':
      return !are_equal(a, b);
    case '&':
      return is_true(a) && is_true(b);
    default:
      return is_true(a) || is_true(b);
  }
}

}  // namespace

int component_place(const Token& token) {
  if (token.kind != Token::Kind::kName || token.index >= kKeywordCount) return -1;
  switch (static_cast<Keyword>(token.index)) {
    case Keyword::kX:
    case Keyword::kU:
    case Keyword::kRed:
      return 0;
    case Keyword::kY:
    case Keyword::kV:
    case Keyword::kGreen:
      return 1;
    case Keyword::kZ:
    case Keyword::kBlue:
      return 2;
    case Keyword::kT:
    case Keyword::kFilter:
      return 3;
    case Keyword::kTransmit:
      return 4;
    case Keyword::kGray:
      return 5;
    default:
      return -1;
  }
}

Numeric Interpreter::combine(char op, const Numeric& a, const Numeric& b) {
  if (op == '/') {
    const bool zero = b.size == 1 ? b.v[0] == 0 : false;
    if (zero) warn("division by zero");
  }
  if (a.size == 1 && b.size == 1) return number(apply(op, a.v[0], b.v[0]));
  const std::uint8_t size = std::max(a.size, b.size);
  const Numeric left = promoted(a, size), right = promoted(b, size);
  Numeric result;
  result.size = size;
  result.color = a.color || b.color;
  for (std::uint8_t i = 0; i < size; ++i) result.v[i] = apply(op, left.v[i], right.v[i]);
  return result;
}

double Interpreter::as_float(const Numeric& n, SourcePosition where) {
  if (n.size != 1) {
    fail_at(where, "expected a number, found a " + std::string(n.color ? "colour" : "vector"),
            "take one of its components, as in V.x");
  }
  return n.v[0];
}

Numeric Interpreter::sum() {
  Numeric value = product();
  for (;;) {
    const Token& token = peek();
    if (token.kind != Token::Kind::kPunctuation) return value;
    const char op = token.punctuation;
    if (op != '+' && op != '-') return value;
    next();
    if (value.size == 1) {
      const Numeric right = product();
      if (right.size == 1) {
        value.v[0] = op == '+' ? value.v[0] + right.v[0] : value.v[0] - right.v[0];
      } else {
        value = combine(op, value, right);
      }
    } else {
      value = combine(op, value, product());
    }
  }
}

Numeric Interpreter::product() {
  Numeric value = factor();
  for (;;) {
    const Token& token = peek();
    if (token.kind != Token::Kind::kPunctuation) return value;
    const char op = token.punctuation;
    if (op != '*' && op != '/') return value;
    next();
    value = combine(op, value, factor());
  }
}

Numeric Interpreter::factor() {
  bool negative = false, negated = false;
  int signs = 0;
  for (;;) {
    const Token& token = peek();
    if (token.is('-')) {
      negative = !negative;
    } else if (token.is('!')) {
      negated = true;
      break;
    } else if (!token.is('+')) {
      break;
    }
    next();
    ++signs;
  }
  Numeric value;
  if (negated) {
    const Nesting guard(*this);
    next();
    value = factor();
    for (std::uint8_t i = 0; i < value.size; ++i) value.v[i] = !is_true(value.v[i]);
  } else {
    value = primary();
    if (peek().is('.')) value = component(value);
  }
  if (negative) {
    for (std::uint8_t i = 0; i < value.size; ++i) value.v[i] = -value.v[i];
  }
  return value;
}

Numeric Interpreter::component(Numeric n) {
  while (accept('.')) {
    const Token token = peek();
    const int place = component_place(token);
    if (place < 0) fail_expected("x, y, z, t, u, v, red, green, blue, filter, transmit or gray");
    if (n.size == 1) fail("a number has no components");
    next();
    if (place == 5) {
      n = number(0.297 * n.v[0] + 0.589 * n.v[1] + 0.114 * (n.size > 2 ? n.v[2] : 0));
    } else {
      n = number(place < n.size ? n.v[static_cast<std::size_t>(place)] : 0);
    }
  }
  return n;
}

Numeric Interpreter::primary() {
  const Token& token = peek();
  switch (token.kind) {
    case Token::Kind::kNumber: {
      const double value = token.number;
      next();
      return number(value);
    }
    case Token::Kind::kName:
      return token.index < kKeywordCount ? keyword_value(static_cast<Keyword>(token.index))
                                         : name_value();
    case Token::Kind::kPunctuation:
      if (token.punctuation == '(') return parenthesised();
      if (token.punctuation == '<') return vector_literal();
      break;
    default:
      break;
  }
  fail_expected("a number or vector");
}

/// The value of the identifier at the next token, its subscripts taken; null if it has none.
const Value* Interpreter::operand() {
  if (pending_) return &pending_value_;
  const Token& token = peek();
  if (token.kind != Token::Kind::kName || token.index < kKeywordCount) return nullptr;
  Binding* binding = scopes_.find(token.index);
  if (!binding || !is_set(binding->value)) return nullptr;
  if (binding->deprecated) warn_deprecated(*binding);
  if (!std::holds_alternative<std::shared_ptr<Array>>(binding->value) || !cursor_[1].is('[')) {
    return &binding->value;
  }
  const Token name = token;
  ready_ = false;
  ++cursor_;
  Subscripts subscripts;
  parse_subscripts(subscripts);
  const Value* place = locate(binding->value, subscripts, name.position, false);
  if (!is_set(*place)) {
    fail_at(name.position, "this element of " + symbols_.name(name.index) + " has no value yet",
            "#ifdef (ARRAY[I]) asks whether it has one");
  }
  pending_value_ = *place;
  pending_binding_ = binding;
  pending_subscripts_ = subscripts;
  pending_token_ = name;
  pending_ = true;
  current_ = &pending_token_;
  ready_ = true;
  return &pending_value_;
}

Numeric Interpreter::name_value() {
  const Value* value = operand();
  if (!value) {
    const Token token = peek();
    fail_undeclared(token.position, token.index);
  }
  if (const Numeric* n = std::get_if<Numeric>(value)) {
    const Numeric copy = *n;
    next();
    return copy;
  }
  if (const auto* function = std::get_if<std::shared_ptr<const FunctionValue>>(value)) {
    const auto keep = *function;
    next();
    return call_function(*keep);
  }
  if (const auto* spline = std::get_if<std::shared_ptr<const Spline>>(value)) {
    const auto keep = *spline;
    next();
    return call_spline(*keep);
  }
  fail("expected a number or vector, found the " + std::string(type_name(*value)) + " '" +
       symbols_.name(peek().index) + "'");
}

Numeric Interpreter::parenthesised() {
  const Nesting guard(*this);
  next();
  const Numeric value = full();
  expect(')', "to close the parenthesis");
  return value;
}

Numeric Interpreter::vector_literal() {
  const Nesting guard(*this);
  next();
  Numeric vector;
  vector.size = 0;
  while (!at('>')) {
    if (vector.size == 5) fail_expected("'>' after five components");
    vector.v[vector.size++] = parse_float();
    skip_comma();
  }
  if (vector.size < 2) fail("a vector needs at least two components");
  next();
  return vector;
}

Numeric Interpreter::relation() {
  double strings = 0;
  if (string_relation(strings)) return number(strings);
  Numeric value = sum();
  for (;;) {
    const Token& token = peek();
    if (token.kind != Token::Kind::kPunctuation) return value;
    const char op = token.punctuation;
    if (op != '<' && op != '>' && op != 'l' && op != 'g' && op != '=' && op != 'n') return value;
    next();
    value = combine(op, value, sum());
  }
}

Numeric Interpreter::logical() {
  Numeric value = relation();
  for (;;) {
    const Token& token = peek();
    if (!token.is('&') && !token.is('|')) return value;
    const char op = token.punctuation;
    next();
    value = combine(op, value, relation());
  }
}

Numeric Interpreter::full() {
  const SourcePosition where = position();
  Numeric value = logical();
  if (!peek().is('?')) return value;
  const Nesting guard(*this);
  const bool condition = is_true(as_float(value, where));
  next();
  const Numeric yes = full();
  expect(':', "between the two values of '?'");
  const Numeric no = full();
  return condition ? yes : no;
}

Numeric Interpreter::parse_numeric() { return sum(); }
double Interpreter::parse_float() {
  const SourcePosition where = position();
  return as_float(sum(), where);
}
/// The digits behind a decimal comma are counted in the file: the token has only their value.
double Interpreter::parse_setting_float() {
  const double whole = parse_float();
  const bool comma = at(',') && !pending_ && cursor_[1].kind == Token::Kind::kNumber;
  if (!comma) return whole;
  const SourcePosition where = position();
  next();
  const Token digits = next();
  const std::string_view line = programs_[digits.position.file]->line(digits.position.line);
  double unit = 1;
  for (std::size_t i = digits.position.column - 1; i < line.size(); ++i) {
    if (line[i] < '0' || line[i] > '9') break;
    unit /= 10;
  }
  forgive(where, "',' is read as a decimal point", "write the number with '.'");
  return whole + digits.number * unit;
}

bool Interpreter::accept_word(std::string_view word) {
  const Token& token = peek();
  if (token.kind != Token::Kind::kName || token.index < kKeywordCount) return false;
  if (symbols_.name(token.index) != word) return false;
  next();
  return true;
}

bool Interpreter::parse_bool() { return is_true(parse_float()); }

bool Interpreter::parse_flag() {
  const Token& token = peek();
  if (token.kind == Token::Kind::kNumber || token.is('(') || token.is('-') || token.is('+') ||
      token.is('!')) {
    return parse_bool();
  }
  if (token.kind != Token::Kind::kName) return true;
  if (token.index < kKeywordCount) {
    switch (static_cast<Keyword>(token.index)) {
      case Keyword::kX:
      case Keyword::kY:
      case Keyword::kZ:
      case Keyword::kU:
      case Keyword::kV:
      case Keyword::kT:
        return true;
      default:
        return at_expression() ? parse_bool() : true;
    }
  }
  const Value* value = operand();
  return value && value_is_numeric(*value) ? parse_bool() : true;
}

Vec2 Interpreter::parse_vec2() {
  const Numeric n = promoted(sum(), 2);
  return {n.v[0], n.v[1]};
}

Vec3 Interpreter::parse_vec3() {
  const Numeric n = promoted(sum(), 3);
  return {n.v[0], n.v[1], n.v[2]};
}

bool Interpreter::value_is_numeric(const Value& value) const {
  return std::holds_alternative<Numeric>(value) || get_if<const FunctionValue>(value) ||
         get_if<const Spline>(value);
}

bool Interpreter::at_expression() {
  const Token& token = peek();
  switch (token.kind) {
    case Token::Kind::kNumber:
      return true;
    case Token::Kind::kPunctuation:
      return token.is('(') || token.is('<') || token.is('-') || token.is('+') || token.is('!');
    case Token::Kind::kName:
      break;
    default:
      return false;
  }
  if (token.index < kKeywordCount) {
    return keyword_begins_expression(static_cast<Keyword>(token.index));
  }
  const Value* value = operand();
  return value && value_is_numeric(*value);
}

const Described* Interpreter::peek_described() {
  const Value* value = operand();
  const DescribedPtr* described = value ? std::get_if<DescribedPtr>(value) : nullptr;
  return described ? described->get() : nullptr;
}

DescribedPtr Interpreter::take_described() {
  const Value* value = operand();
  const DescribedPtr* described = value ? std::get_if<DescribedPtr>(value) : nullptr;
  if (!described) return nullptr;
  DescribedPtr copy = *described;
  last_name_ = symbols_.name(peek().index);
  next();
  return copy;
}

}  // namespace dioptre::pov
