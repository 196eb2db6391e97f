// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/functions/program_builder.h"

#include <algorithm>
#include <bit>

#include "dioptre/core/expression_eval.h"
#include "dioptre/shading/functions/function_table.h"
#include "dioptre/shading/functions/internal_function_table.h"

namespace dioptre {
namespace {

/// Formulas within formulas, and their steps in all, beyond which calls remain calls.
constexpr std::uint32_t kDeepest = 64;
constexpr std::size_t kMostSteps = 10000;

using Code = Step::Code;
constexpr auto kFromConstant = ProgramBuilder::Value::From::kConstant;

}  // namespace

ProgramBuilder::ProgramBuilder(const FunctionTable& table, std::uint32_t parameter_count)
    : table_(table), parameter_count_(parameter_count) {}

ProgramBuilder::Value ProgramBuilder::constant(double v) {
  const auto [place, is_new] = constant_places_.try_emplace(
      std::bit_cast<std::uint64_t>(v), static_cast<std::uint32_t>(constants_.size()));
  if (is_new) constants_.push_back(v);
  return {kFromConstant, place->second};
}

ProgramBuilder::Value ProgramBuilder::parameter(std::uint32_t index) const {
  return {Value::From::kParameter, index};
}

std::optional<double> ProgramBuilder::known(Value v) const {
  if (v.from != kFromConstant) return std::nullopt;
  return constants_[v.index];
}

ProgramBuilder::Value ProgramBuilder::add(Draft draft) {
  const auto [place, is_new] =
      known_drafts_.try_emplace(draft, static_cast<std::uint32_t>(drafts_.size()));
  if (is_new) drafts_.push_back(std::move(draft));
  return {Value::From::kInstruction, place->second};
}

ProgramBuilder::Value ProgramBuilder::apply(Code code, Value a, Value b) {
  const auto p = known(a), q = known(b);
  if (p && q) return constant(evaluate_operator(code, *p, *q));
  if (code == Code::kSqrt) return root(a);
  const bool squares = (code == Code::kMultiply && a == b) || (code == Code::kPow && q == 2.0);
  if (squares) return add({Kind::kSquare, code, {a}});
  return add({Kind::kOperator, code, {a, b}});
}

const ProgramBuilder::Draft* ProgramBuilder::draft_of(Value v, Kind kind, Code code) const {
  if (v.from != Value::From::kInstruction) return nullptr;
  const Draft& draft = drafts_[v.index];
  return draft.kind == kind && (kind == Kind::kSquare || draft.code == code) ? &draft : nullptr;
}

/// What is squared in x^2 + y^2 + z^2 or the first terms of it, in order.
bool ProgramBuilder::add_squares(Value sum, std::vector<Value>& out) const {
  if (const Draft* square = draft_of(sum, Kind::kSquare, Code::kMultiply)) {
    out.push_back(square->operands[0]);
    return true;
  }
  const Draft* both = draft_of(sum, Kind::kOperator, Code::kAdd);
  if (!both || out.size() > 3) return false;
  const bool ends = draft_of(both->operands[1], Kind::kSquare, Code::kMultiply) != nullptr;
  return ends && add_squares(both->operands[0], out) && add_squares(both->operands[1], out);
}

/// A square root, or the norm whose square a is.
ProgramBuilder::Value ProgramBuilder::root(Value a) {
  std::vector<Value> v;
  if (!add_squares(a, v) || v.size() < 2 || v.size() > 3) {
    return add({Kind::kOperator, Code::kSqrt, {a, constant(0)}});
  }
  if (v.size() == 2) v.push_back(constant(0));
  return add({Kind::kNorm, Code::kSqrt, std::move(v)});
}

ProgramBuilder::Value ProgramBuilder::select(const Value (&operands)[4]) {
  if (const auto sign = known(operands[0])) {
    return operands[*sign < 0 ? 1 : *sign > 0 ? 3 : 2];
  }
  return add({Kind::kSelect, Code::kSelect, {operands[0], operands[1], operands[2], operands[3]}});
}

ProgramBuilder::Value ProgramBuilder::call(FunctionId function, std::span<const Value> arguments) {
  const Expression* body = table_.formula(function);
  if (body && !body->steps.empty() && depth_ < kDeepest && steps_ < kMostSteps) {
    return put_in_place(*body, arguments);
  }
  if (const auto number = table_.internal_number(function)) {
    if (const auto value = internal(*number, arguments)) return *value;
  }
  return add({Kind::kCall, Code::kCall, {arguments.begin(), arguments.end()}, 0, function});
}

ProgramBuilder::Value ProgramBuilder::put_in_place(const Expression& body,
                                                   std::span<const Value> arguments) {
  ++depth_;
  steps_ += body.steps.size();
  std::vector<Value> done;
  done.reserve(body.steps.size());
  for (const Step& step : body.steps) done.push_back(step_value(body, step, arguments, done));
  --depth_;
  return done.back();
}

ProgramBuilder::Value ProgramBuilder::step_value(const Expression& body, const Step& step,
                                                 std::span<const Value> arguments,
                                                 const std::vector<Value>& done) {
  switch (step.code) {
    case Code::kConstant:
      return constant(step.value);
    case Code::kParameter:
      return step.a < arguments.size() ? arguments[step.a] : constant(0);
    case Code::kSelect:
      return select({done[step.a], done[step.b], done[step.c], done[step.extra]});
    case Code::kCall: {
      std::vector<Value> inner;
      for (std::uint32_t k = 0; k < step.b; ++k) {
        inner.push_back(done[body.arguments[step.a + k]]);
      }
      return call(step.function, inner);
    }
    case Code::kSum:
    case Code::kProduct: {
      std::vector<Value> operands{done[step.a], done[step.b]};
      operands.insert(operands.end(), arguments.begin(), arguments.end());
      return add({Kind::kLoop, step.code, std::move(operands), 0, step.function});
    }
    case Code::kNegate:
    case Code::kNot:
      return apply(step.code, done[step.a]);
    default: {
      const bool unary = step.code > Code::kNot && step.code <= Code::kTanh;
      return unary ? apply(step.code, done[step.a]) : apply(step.code, done[step.a], done[step.b]);
    }
  }
}

std::uint32_t ProgramBuilder::place(Value v) const {
  const auto constants = static_cast<std::uint32_t>(constants_.size());
  if (v.from == kFromConstant) return v.index;
  if (v.from == Value::From::kParameter) return constants + v.index;
  return constants + parameter_count_ + v.index;
}

/// The instructions that the result needs, with their operands renumbered, and the result's.
std::vector<ProgramBuilder::Draft> ProgramBuilder::needed_drafts(Value& result) const {
  std::vector<bool> needed(drafts_.size());
  const auto need = [&](Value v) {
    if (v.from == Value::From::kInstruction) needed[v.index] = true;
  };
  need(result);
  for (std::size_t i = drafts_.size(); i-- > 0;) {
    if (needed[i]) std::for_each(drafts_[i].operands.begin(), drafts_[i].operands.end(), need);
  }
  std::vector<Draft> out;
  std::vector<std::uint32_t> places(drafts_.size());
  const auto renumber = [&](Value& v) {
    if (v.from == Value::From::kInstruction) v.index = places[v.index];
  };
  for (std::size_t i = 0; i < drafts_.size(); ++i) {
    if (!needed[i]) continue;
    places[i] = static_cast<std::uint32_t>(out.size());
    out.push_back(drafts_[i]);
    std::for_each(out.back().operands.begin(), out.back().operands.end(), renumber);
  }
  renumber(result);
  return out;
}

FunctionProgram::Code ProgramBuilder::finish(Value result) {
  FunctionProgram::Code code;
  code.parameter_count = parameter_count_;
  for (const Draft& draft : needed_drafts(result)) {
    Instruction i{draft.kind, draft.code, 0, 0, 0, draft.extra, draft.function};
    std::vector<std::uint32_t> places;
    for (const Value v : draft.operands) places.push_back(place(v));
    const auto first = static_cast<std::uint32_t>(code.arguments.size());
    const auto count = static_cast<std::uint32_t>(places.size());
    if (draft.kind == Kind::kCall) {
      i.a = first, i.b = count;
      code.arguments.insert(code.arguments.end(), places.begin(), places.end());
    } else if (draft.kind == Kind::kLoop) {
      i.a = places[0], i.b = places[1], i.c = first, i.extra = count - 2;
      code.arguments.insert(code.arguments.end(), places.begin() + 2, places.end());
    } else {
      std::uint32_t* const operands[] = {&i.a, &i.b, &i.c, &i.extra};
      for (std::uint32_t k = 0; k < count; ++k) *operands[k] = places[k];
    }
    code.instructions.push_back(i);
  }
  code.constants = constants_;
  code.result = place(result);
  return code;
}

FunctionProgram::Code compile_function(const FunctionTable& table, FunctionId function,
                                       std::uint32_t parameter_count) {
  ProgramBuilder builder(table, parameter_count);
  std::vector<ProgramBuilder::Value> parameters;
  for (std::uint32_t k = 0; k < parameter_count; ++k) parameters.push_back(builder.parameter(k));
  const ProgramBuilder::Value result = builder.call(function, parameters);
  return builder.finish(result);
}

}  // namespace dioptre
