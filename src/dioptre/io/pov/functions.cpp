// SPDX-License-Identifier: Apache-2.0
// User functions and splines: reading them and calling them.
#include <cmath>

#include "dioptre/core/expression_eval.h"
#include "dioptre/io/pov/function_compiler.h"
#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

constexpr std::size_t kMostParameters = 56;
constexpr std::uint32_t kMostCalls = 1024;
const std::vector<std::string> kCoordinates{"x", "y", "z"};

}  // namespace

FunctionId Interpreter::add_function(const std::string& name,
                                     const std::vector<std::string>& parameters,
                                     Function::Body body) {
  return append(scene_.functions, Function{name, parameters, std::move(body)});
}

FunctionId Interpreter::parse_function() {
  std::shared_ptr<const FunctionValue> function;
  const Value* value = operand();
  if (value && get_if<const FunctionValue>(*value)) {
    function = std::get<std::shared_ptr<const FunctionValue>>(*value);
    next();
  } else if (at('{') || at('(')) {
    auto parameters = at('(') ? parse_parameters() : kCoordinates;
    expect('{', "before the body of the function");
    // An identifier alone between the braces is that function.
    const Value* inner = operand();
    if (inner && get_if<const FunctionValue>(*inner) && cursor_[pending_ ? 0 : 1].is('}')) {
      function = std::get<std::shared_ptr<const FunctionValue>>(*inner);
      next();
      next();
    } else {
      function = parse_function_body("", std::move(parameters));
    }
  } else {
    fail_expected("a function: its name or { ... }");
  }
  if (function->components.size() == 1) return function->components[0];
  if (function->gray) return function->gray;
  fail("expected a function whose value is a number");
}

/// After and with the keyword `function`.
std::shared_ptr<const FunctionValue> Interpreter::parse_function_value(const std::string& name) {
  next();
  const Value* value = operand();
  if (value && get_if<const FunctionValue>(*value)) {
    auto function = std::get<std::shared_ptr<const FunctionValue>>(*value);
    next();
    return function;
  }
  auto parameters = at('(') ? parse_parameters() : kCoordinates;
  expect('{', "before the body of the function");
  return parse_function_body(name, std::move(parameters));
}

std::vector<std::string> Interpreter::parse_parameters() {
  next();
  std::vector<std::string> parameters;
  while (!raw().is(')')) {
    parameters.push_back(symbols_.name(raw_identifier("the name of a parameter or ')'")));
    if (raw().is(',')) skip_raw();
    if (parameters.size() > kMostParameters) fail("a function has at most 56 parameters");
  }
  ready_ = false;
  next();
  return parameters;
}

/// After the opening brace; takes the closing one.
std::shared_ptr<const FunctionValue> Interpreter::parse_function_body(
    const std::string& name, std::vector<std::string> parameters) {
  const Nesting guard(*this);
  std::shared_ptr<const FunctionValue> result;
  if (at(Keyword::kPigment)) {
    result = color_function(name);
  } else if (at(Keyword::kSpline)) {
    result = spline_function(name);
  } else if (at(Keyword::kTransform)) {
    result = transform_function(name);
  } else {
    auto function = std::make_shared<FunctionValue>();
    Function::Body body;
    if (accept(Keyword::kInternal)) {
      expect('(', "after internal");
      const double number = float_argument();
      expect(')', "after the number of the internal function");
      if (!(number >= 0 && number < 1000)) fail("there is no internal function of this number");
      body = InternalFunction{static_cast<std::uint32_t>(number)};
      function->internal = true;
    } else if (accept(Keyword::kPattern)) {
      body = PatternFunction{parse_pattern_block(*this)};
    } else {
      body = ExpressionFunction{FunctionCompiler(*this, name, parameters).compile()};
    }
    function->components.push_back(add_function(name, parameters, std::move(body)));
    function->parameters = std::move(parameters);
    result = std::move(function);
  }
  expect('}', "after the body of the function");
  return result;
}

std::shared_ptr<const FunctionValue> Interpreter::color_function(const std::string& name) {
  next();
  const Pigment pigment = parse_pigment_block(*this);
  auto function = std::make_shared<FunctionValue>();
  function->parameters = kCoordinates;
  function->pigment = append(scene_.pigments, pigment);
  for (std::uint32_t i = 0; i < 5; ++i) {
    function->components.push_back(
        add_function(name, kCoordinates, PigmentFunction{function->pigment, i}));
  }
  function->gray = add_function(name, kCoordinates, PigmentFunction{function->pigment, 5});
  return function;
}

SplineFunction Interpreter::spline_body(const Spline& spline, std::uint32_t component) {
  SplineFunction body;
  body.kind = static_cast<std::uint32_t>(spline.kind);
  body.component = component;
  for (const Spline::Knot& knot : spline.knots) {
    body.knots.push_back({knot.at, {knot.value.begin(), knot.value.begin() + spline.size}});
  }
  return body;
}

std::shared_ptr<const FunctionValue> Interpreter::spline_function(const std::string& name) {
  auto function = std::make_shared<FunctionValue>();
  function->parameters = {"t"};
  function->spline = parse_spline();
  for (std::uint32_t i = 0; i < function->spline->size; ++i) {
    function->components.push_back(
        add_function(name, function->parameters, spline_body(*function->spline, i)));
  }
  return function;
}

/// The three coordinates of the image of a point, each a formula.
std::shared_ptr<const FunctionValue> Interpreter::transform_function(const std::string& name) {
  const DescribedPtr described = parse_described(*this);
  const Affine* map = described ? std::get_if<Affine>(described.get()) : nullptr;
  if (!map) fail_expected("a transformation");
  auto function = std::make_shared<FunctionValue>();
  function->parameters = kCoordinates;
  for (std::size_t i = 0; i < 3; ++i) {
    const double factors[] = {map->x[i], map->y[i], map->z[i]};
    Expression e;
    e.steps.push_back({});
    e.steps.back().value = map->o[i];
    std::uint32_t total = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const auto base = static_cast<std::uint32_t>(e.steps.size());
      Step factor, parameter, term, sum;
      factor.value = factors[axis];
      parameter.code = Step::Code::kParameter;
      parameter.a = axis;
      term.code = Step::Code::kMultiply;
      term.a = base;
      term.b = base + 1;
      sum.code = Step::Code::kAdd;
      sum.a = total;
      sum.b = base + 2;
      e.steps.insert(e.steps.end(), {factor, parameter, term, sum});
      total = base + 3;
    }
    function->components.push_back(
        add_function(name, kCoordinates, ExpressionFunction{std::move(e)}));
  }
  return function;
}

/// The arguments in parentheses, then the value.
Numeric Interpreter::call_function(const FunctionValue& function) {
  const Nesting guard(*this);
  expect('(', "and the arguments of the function");
  std::array<double, kMostParameters> args;
  std::size_t count = 0;
  while (!at(')')) {
    if (count == (function.internal ? args.size() : function.parameters.size())) break;
    args[count++] = float_argument();
    if (!accept(',')) break;
  }
  if (function.spline && at_spline_kind()) {
    const Spline::Kind kind = parse_spline_kind();
    expect(')', "after the arguments");
    return spline_value(*function.spline, kind, args[0]);
  }
  expect(')', "after the arguments");
  if (count != function.parameters.size() && !function.internal) {
    fail("the function takes " + std::to_string(function.parameters.size()) + " arguments, found " +
         std::to_string(count));
  }
  const std::span<const double> given(args.data(), count);
  Numeric value;
  if (function.pigment) {
    const PigmentColor c = queries().pigment(scene_, function.pigment, {args[0], args[1], args[2]});
    value.v = {c.color.r, c.color.g, c.color.b, c.filter, c.transmit};
    value.size = 5;
    value.color = true;
    return value;
  }
  value.size = static_cast<std::uint8_t>(function.components.size());
  for (std::size_t i = 0; i < function.components.size(); ++i) {
    value.v[i] = call(function.components[i], given);
  }
  return value;
}

/// The value of a function of the scene. Formulas are evaluated here, patterns by the renderer.
double Interpreter::call(FunctionId id, std::span<const double> args) {
  const Function& function = at_id(id);
  const auto* formula = std::get_if<ExpressionFunction>(&function.body);
  if (!formula) {
    if (const auto* spline = std::get_if<SplineFunction>(&function.body)) {
      return spline_component_value(*spline, args.empty() ? 0 : args[0]);
    }
    return queries().call(scene_, id, args);
  }
  if (++calls_ > kMostCalls) fail("functions call each other more than 1024 deep");
  const double value = evaluate(formula->body, args, [this](FunctionId inner, auto inner_args) {
    count_step();
    return call(inner, inner_args);
  });
  --calls_;
  return value;
}

double Interpreter::spline_component_value(const SplineFunction& function, double at) {
  Spline spline;
  spline.kind = static_cast<Spline::Kind>(function.kind);
  for (const SplineKnot& knot : function.knots) {
    Spline::Knot k;
    k.at = knot.at;
    k.value[0] = function.component < knot.value.size() ? knot.value[function.component] : 0;
    spline.knots.push_back(k);
  }
  spline.finish();
  return evaluate(spline, spline.kind, at)[0];
}

bool Interpreter::at_spline_kind() {
  return at(Keyword::kLinearSpline) || at(Keyword::kQuadraticSpline) || at(Keyword::kCubicSpline) ||
         at(Keyword::kNaturalSpline);
}

Spline::Kind Interpreter::parse_spline_kind() {
  const Token token = next();
  return token.is(Keyword::kLinearSpline)      ? Spline::Kind::kLinear
         : token.is(Keyword::kQuadraticSpline) ? Spline::Kind::kQuadratic
         : token.is(Keyword::kCubicSpline)     ? Spline::Kind::kCubic
                                               : Spline::Kind::kNatural;
}

/// `spline { [IDENTIFIER] [KIND] at, value, ... }`, at the keyword.
std::shared_ptr<const Spline> Interpreter::parse_spline() {
  const Nesting guard(*this);
  next();
  expect('{', "after spline");
  auto spline = std::make_shared<Spline>();
  if (const Value* value = operand()) {
    if (const Spline* other = get_if<const Spline>(*value); other && !cursor_[1].is('(')) {
      *spline = *other;
      next();
      skip_comma();
    }
  }
  if (at_spline_kind()) {
    spline->kind = parse_spline_kind();
    skip_comma();
  }
  while (!at('}')) {
    Spline::Knot knot;
    knot.at = parse_float();
    skip_comma();
    Numeric n = sum();
    if (n.size == 1) n = promoted(n, 2);  // (measured)
    knot.value = promoted(n, 5).v;
    spline->size = std::max(spline->size, n.size);
    if (!std::isfinite(knot.at)) fail("a place of a spline is not finite");
    const bool behind = spline->knots.empty() || spline->knots.back().at < knot.at;
    charge(sizeof knot * (behind ? 1 : spline->knots.size()));
    spline->insert(knot);
    skip_comma();
    if (spline->knots.size() > options_.budgets.array_elements) {
      over_budget(std::to_string(options_.budgets.array_elements) + " points in a spline",
                  "max-array-elements");
    }
  }
  next();
  spline->finish();
  return spline;
}

Numeric Interpreter::spline_value(const Spline& spline, Spline::Kind kind, double at) {
  Numeric value;
  value.size = spline.size;
  value.v = evaluate(spline, kind, at);
  return value;
}

Numeric Interpreter::call_spline(const Spline& spline) {
  const Nesting guard(*this);
  expect('(', "and the place on the spline");
  const double at = float_argument();
  Spline::Kind kind = spline.kind;
  if (accept(',')) {
    if (!at_spline_kind()) fail_expected("a kind of spline");
    kind = parse_spline_kind();
  }
  expect(')', "after the place on the spline");
  if (spline.knots.empty()) fail("the spline has no points");
  return spline_value(spline, kind, at);
}

}  // namespace dioptre::pov
