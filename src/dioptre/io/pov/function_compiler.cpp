// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/function_compiler.h"

#include "dioptre/core/expression_eval.h"

namespace dioptre::pov {
namespace {

constexpr std::size_t kMostSteps = 1 << 20;
constexpr std::size_t kMostParameters = 56;

}  // namespace

std::optional<Step::Code> math_code(Keyword k) {
  using C = Step::Code;
  switch (k) {
    case Keyword::kAbs:
      return C::kAbs;
    case Keyword::kAcos:
      return C::kAcos;
    case Keyword::kAcosh:
      return C::kAcosh;
    case Keyword::kAsin:
      return C::kAsin;
    case Keyword::kAsinh:
      return C::kAsinh;
    case Keyword::kAtan:
      return C::kAtan;
    case Keyword::kAtanh:
      return C::kAtanh;
    case Keyword::kAtan2:
      return C::kAtan2;
    case Keyword::kCeil:
      return C::kCeil;
    case Keyword::kCos:
      return C::kCos;
    case Keyword::kCosh:
      return C::kCosh;
    case Keyword::kDegrees:
      return C::kDegrees;
    case Keyword::kDiv:
      return C::kDiv;
    case Keyword::kExp:
      return C::kExp;
    case Keyword::kFloor:
      return C::kFloor;
    case Keyword::kInt:
      return C::kInt;
    case Keyword::kLn:
      return C::kLn;
    case Keyword::kLog:
      return C::kLog;
    case Keyword::kMod:
      return C::kMod;
    case Keyword::kPow:
      return C::kPow;
    case Keyword::kRadians:
      return C::kRadians;
    case Keyword::kSin:
      return C::kSin;
    case Keyword::kSinh:
      return C::kSinh;
    case Keyword::kSqrt:
      return C::kSqrt;
    case Keyword::kTan:
      return C::kTan;
    case Keyword::kTanh:
      return C::kTanh;
    default:
      return std::nullopt;
  }
}

bool has_two_arguments(Step::Code code) {
  return code == Step::Code::kAtan2 || code == Step::Code::kDiv || code == Step::Code::kMod ||
         code == Step::Code::kPow;
}

Expression FunctionCompiler::compile() {
  const Place result = logical_or();
  // The result is the last step.
  if (result + 1 != expression_.steps.size()) add(Step::Code::kAdd, result, constant(0));
  return std::move(expression_);
}

FunctionCompiler::Place FunctionCompiler::constant(double value) {
  const Place place = add(Step::Code::kConstant);
  expression_.steps[place].value = value;
  return place;
}

FunctionCompiler::Place FunctionCompiler::add(Step::Code code, Place a, Place b) {
  std::vector<Step>& steps = expression_.steps;
  if (steps.size() >= kMostSteps) in_.fail("a function has more than 1048576 steps");
  const auto is_constant = [&](Place p) { return steps[p].code == Step::Code::kConstant; };
  const bool plain =
      code != Step::Code::kConstant && code != Step::Code::kParameter && code < Step::Code::kSelect;
  Step step;
  step.code = code;
  step.a = a;
  step.b = b;
  if (plain && is_constant(a) && is_constant(b)) {
    step.value = evaluate_operator(code, steps[a].value, steps[b].value);
    step.code = Step::Code::kConstant;
    step.a = step.b = 0;
    // Operands that were made for this step alone are the last ones: they go.
    while (!steps.empty() && (steps.size() - 1 == a || steps.size() - 1 == b) &&
           is_constant(static_cast<Place>(steps.size() - 1))) {
      steps.pop_back();
    }
  }
  steps.push_back(step);
  return static_cast<Place>(steps.size() - 1);
}

FunctionCompiler::Place FunctionCompiler::logical_or() {
  Place value = logical_and();
  while (in_.accept('|')) value = add(Step::Code::kOr, value, logical_and());
  return value;
}

FunctionCompiler::Place FunctionCompiler::logical_and() {
  Place value = relation();
  while (in_.accept('&')) value = add(Step::Code::kAnd, value, relation());
  return value;
}

FunctionCompiler::Place FunctionCompiler::relation() {
  Place value = sum();
  for (;;) {
    const Token& token = in_.peek();
    Step::Code code;
    if (token.is('<')) {
      code = Step::Code::kLess;
    } else if (token.is('>')) {
      code = Step::Code::kGreater;
    } else if (token.is('l')) {
      code = Step::Code::kLessEqual;
    } else if (token.is('g')) {
      code = Step::Code::kGreaterEqual;
    } else if (token.is('=')) {
      code = Step::Code::kEqual;
    } else if (token.is('n')) {
      code = Step::Code::kNotEqual;
    } else {
      return value;
    }
    in_.next();
    value = add(code, value, sum());
  }
}

FunctionCompiler::Place FunctionCompiler::sum() {
  Place value = product();
  for (;;) {
    if (in_.accept('+')) {
      value = add(Step::Code::kAdd, value, product());
    } else if (in_.accept('-')) {
      value = add(Step::Code::kSubtract, value, product());
    } else {
      return value;
    }
  }
}

FunctionCompiler::Place FunctionCompiler::product() {
  Place value = factor();
  for (;;) {
    if (in_.accept('*')) {
      value = add(Step::Code::kMultiply, value, factor());
    } else if (in_.accept('/')) {
      value = add(Step::Code::kDivide, value, factor());
    } else {
      return value;
    }
  }
}

FunctionCompiler::Place FunctionCompiler::factor() {
  bool negative = false;
  for (;;) {
    if (in_.accept('-')) {
      negative = !negative;
    } else if (!in_.accept('+')) {
      break;
    }
  }
  Place value;
  if (in_.accept('!')) {
    const Parser::Nesting guard(in_);
    const Place operand = factor();
    value = add(Step::Code::kNot, operand, operand);
  } else {
    value = primary();
  }
  return negative ? add(Step::Code::kNegate, value, value) : value;
}

std::optional<std::uint32_t> FunctionCompiler::parameter(const Token& token) const {
  const std::string& name = in_.symbols_.name(token.index);
  for (std::size_t i = parameters_.size(); i-- > 0;) {
    const std::string& p = parameters_[i];
    const bool same = p == name || (p == "x" && name == "u") || (p == "u" && name == "x") ||
                      (p == "y" && name == "v") || (p == "v" && name == "y");
    if (same) return static_cast<std::uint32_t>(i);
  }
  return std::nullopt;
}

FunctionCompiler::Place FunctionCompiler::primary() {
  const Token token = in_.peek();
  if (token.kind == Token::Kind::kNumber) {
    in_.next();
    return constant(token.number);
  }
  if (token.is('(')) return parenthesised();
  if (token.kind != Token::Kind::kName) in_.fail_expected("a number, name or '(' in the function");
  if (const auto number = parameter(token)) {
    in_.next();
    return add(Step::Code::kParameter, *number);
  }
  return token.index < kKeywordCount ? keyword(static_cast<Keyword>(token.index)) : name();
}

FunctionCompiler::Place FunctionCompiler::parenthesised() {
  const Parser::Nesting guard(in_);
  in_.next();
  const Place value = logical_or();
  in_.expect(')', "to close the parenthesis");
  return value;
}

FunctionCompiler::Place FunctionCompiler::name() {
  const Value* value = in_.operand();
  if (!value) {
    in_.fail_at(in_.peek().position,
                "'" + in_.symbols_.name(in_.peek().index) + "' is not declared",
                "a function of this name must be declared before; the f_... functions are in "
                "functions.inc");
  }
  if (const auto* function = std::get_if<std::shared_ptr<const FunctionValue>>(value)) {
    const auto keep = *function;
    in_.next();
    return call(*keep);
  }
  if (const auto* spline = std::get_if<std::shared_ptr<const Spline>>(value)) {
    const auto keep = *spline;
    in_.next();
    const std::vector<Place> args = arguments();
    return call_component(spline_component(*keep), args);
  }
  const SourcePosition where = in_.position();
  Numeric n = in_.name_value();
  if (in_.at('.')) n = in_.component(n);
  return constant(in_.as_float(n, where));
}

FunctionCompiler::Place FunctionCompiler::keyword(Keyword k) {
  if (k == Keyword::kX || k == Keyword::kY || k == Keyword::kZ || k == Keyword::kU ||
      k == Keyword::kV || k == Keyword::kT || !in_.keyword_begins_expression(k)) {
    if (k != Keyword::kSum && k != Keyword::kProd) {
      in_.fail_expected("a number, a parameter or a function in the function");
    }
  }
  const auto code = math_code(k);
  const bool steps = code || k == Keyword::kMin || k == Keyword::kMax || k == Keyword::kSelect ||
                     k == Keyword::kSum || k == Keyword::kProd;
  if (!steps) {
    const SourcePosition where = in_.position();
    return constant(in_.as_float(in_.primary(), where));
  }
  const Parser::Nesting guard(in_);
  in_.next();
  in_.expect('(', "after the name of the function");
  Place value;
  if (k == Keyword::kSelect) {
    value = select();
  } else if (k == Keyword::kMin || k == Keyword::kMax) {
    value = extremum(k == Keyword::kMin ? Step::Code::kMin : Step::Code::kMax);
  } else if (k == Keyword::kSum || k == Keyword::kProd) {
    value = rounds(k == Keyword::kSum ? Step::Code::kSum : Step::Code::kProduct);
  } else {
    const Place a = logical_or();
    Place b = a;
    if (has_two_arguments(*code)) {
      in_.expect(',', "between the arguments");
      b = logical_or();
    }
    value = add(*code, a, b);
  }
  in_.expect(')', "after the arguments");
  return value;
}

FunctionCompiler::Place FunctionCompiler::extremum(Step::Code code) {
  Place value = logical_or();
  while (in_.accept(',')) value = add(code, value, logical_or());
  return value;
}

FunctionCompiler::Place FunctionCompiler::select() {
  const Place test = logical_or();
  in_.expect(',', "between the arguments");
  const Place below = logical_or();
  in_.expect(',', "between the arguments");
  const Place zero = logical_or();
  const Place above = in_.accept(',') ? logical_or() : zero;
  const Place place = add(Step::Code::kSelect, test, below);
  expression_.steps[place].c = zero;
  expression_.steps[place].extra = above;
  return place;
}

/// `sum(i, from, to, body)`: the body becomes a function of its own, with i as its last parameter.
FunctionCompiler::Place FunctionCompiler::rounds(Step::Code code) {
  const Token variable = in_.next();
  if (variable.kind != Token::Kind::kName) {
    in_.fail_at(variable.position,
                "expected the name of the counter, found " + in_.found(variable));
  }
  in_.expect(',', "after the counter");
  const Place from = logical_or();
  in_.expect(',', "between the arguments");
  const Place to = logical_or();
  in_.expect(',', "between the arguments");
  std::vector<std::string> inner = parameters_;
  inner.push_back(in_.symbols_.name(variable.index));
  if (inner.size() > kMostParameters) in_.fail("sums in a function are nested too deep");
  FunctionCompiler body(in_, name_, inner);
  Expression expression = body.compile();
  const FunctionId function =
      in_.add_function(name_, inner, ExpressionFunction{std::move(expression)});
  const Place place = add(code, from, to);
  expression_.steps[place].function = function;
  return place;
}

std::vector<FunctionCompiler::Place> FunctionCompiler::arguments() {
  const Parser::Nesting guard(in_);
  in_.expect('(', "and the arguments of the function");
  std::vector<Place> args;
  while (!in_.at(')')) {
    args.push_back(logical_or());
    if (!in_.accept(',') && !in_.at(')')) in_.fail_expected("',' or ')' after the argument");
    if (args.size() > kMostParameters) in_.fail("a function has at most 56 parameters");
  }
  in_.next();
  return args;
}

FunctionCompiler::Place FunctionCompiler::call(const FunctionValue& function) {
  const std::vector<Place> args = arguments();
  if (args.size() != function.parameters.size() && !function.internal) {
    in_.fail("the function takes " + std::to_string(function.parameters.size()) +
             " arguments, found " + std::to_string(args.size()));
  }
  return call_component(component_function(function), args);
}

FunctionCompiler::Place FunctionCompiler::call_component(FunctionId function,
                                                         const std::vector<Place>& args) {
  const auto first = static_cast<std::uint32_t>(expression_.arguments.size());
  expression_.arguments.insert(expression_.arguments.end(), args.begin(), args.end());
  const Place place = add(Step::Code::kCall, first, static_cast<std::uint32_t>(args.size()));
  expression_.steps[place].function = function;
  return place;
}

/// A number's function itself; of a vector's, the component named after the call.
FunctionId FunctionCompiler::component_function(const FunctionValue& function) {
  if (function.components.size() == 1) return function.components[0];
  if (!in_.accept('.')) in_.fail_expected("'.' and a component of the function's vector");
  const Token token = in_.peek();
  const int place = component_place(token);
  const bool gray = place == 5 && function.gray;
  if (gray) {
    in_.next();
    return function.gray;
  }
  if (place < 0 || place >= static_cast<int>(function.components.size())) {
    in_.fail_expected("a component of the function's vector");
  }
  in_.next();
  return function.components[static_cast<std::size_t>(place)];
}

FunctionId FunctionCompiler::spline_component(const Spline& spline) {
  in_.expect('.', "and a component of the spline's vector");
  const int place = component_place(in_.peek());
  if (place < 0 || place >= spline.size) in_.fail_expected("a component of the spline's vector");
  in_.next();
  return in_.add_function(name_, {"t"}, in_.spline_body(spline, static_cast<std::uint32_t>(place)));
}

}  // namespace dioptre::pov
