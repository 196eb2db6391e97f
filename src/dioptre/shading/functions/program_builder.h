// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "dioptre/shading/functions/function_program.h"

namespace dioptre {

/// Builds a program: every value is a register, known by a number that lasts (see place()); equal
/// instructions and constants share theirs.
class ProgramBuilder {
 public:
  using Kind = FunctionProgram::Kind;
  using Instruction = FunctionProgram::Instruction;
  /// A constant, a parameter or the result of an instruction, before registers are numbered.
  struct Value {
    enum class From : std::uint8_t { kConstant, kParameter, kInstruction } from;
    std::uint32_t index;
    auto operator<=>(const Value&) const = default;
  };

  ProgramBuilder(const FunctionTable& table, std::uint32_t parameter_count);

  Value constant(double v);
  Value parameter(std::uint32_t index) const;
  /// The value of a function for some arguments; formulas are put in place.
  Value call(FunctionId function, std::span<const Value> arguments);
  FunctionProgram::Code finish(Value result);

 private:
  /// An instruction whose operands are still values.
  struct Draft {
    Kind kind = Kind::kOperator;
    Step::Code code = Step::Code::kConstant;
    std::vector<Value> operands;
    std::uint32_t extra = 0;
    FunctionId function;
    auto operator<=>(const Draft&) const = default;
  };
  Value add(Draft draft);
  Value apply(Step::Code code, Value a, Value b);
  Value apply(Step::Code code, Value a) { return apply(code, a, constant(0)); }
  Value select(const Value (&operands)[4]);
  Value put_in_place(const Expression& body, std::span<const Value> arguments);
  Value step_value(const Expression& body, const Step& step, std::span<const Value> arguments,
                   const std::vector<Value>& done);
  Value squared(Value a) { return apply(Step::Code::kMultiply, a, a); }
  Value norm(Value x, Value y);
  Value norm(Value x, Value y, Value z);
  Value noise(Value x, Value y, Value z, std::uint32_t generator);
  Value rounded_box(std::span<const Value> a);
  /// A built-in function by the formula for it, if there is one (internal_formulas.cpp).
  std::optional<Value> internal(std::uint32_t number, std::span<const Value> arguments);
  std::optional<double> known(Value v) const;
  const Draft* draft_of(Value v, Kind kind, Step::Code code) const;
  bool add_squares(Value sum, std::vector<Value>& out) const;
  Value root(Value a);
  std::vector<Draft> needed_drafts(Value& result) const;
  std::uint32_t place(Value v) const;

  const FunctionTable& table_;
  std::uint32_t parameter_count_;
  std::uint32_t depth_ = 0;
  std::size_t steps_ = 0;
  std::vector<double> constants_;
  std::map<std::uint64_t, std::uint32_t> constant_places_;  ///< by the bits of the number
  std::vector<Draft> drafts_;
  std::map<Draft, std::uint32_t> known_drafts_;
};

}  // namespace dioptre
