// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/scalar_field.h"
#include "dioptre/scene/function.h"

namespace dioptre {

class FunctionTable;

/// A function with all formulas that it calls put in their places: one flat list of instructions.
/// Equal parts are computed once and parts without parameters not at all.
class FunctionProgram final : public ScalarField {
 public:
  /// What an instruction does beyond the operators of expressions.
  enum class Kind : std::uint8_t {
    kOperator,
    kSquare,
    kNorm,    ///< of (a, b, c)
    kSelect,  ///< as Step::Code::kSelect
    kNoise,   ///< of generator number `extra` at (a, b, c)
    kCall,    ///< of a function that is no formula, with arguments[a .. a+b)
    kLoop,    ///< Step::Code::kSum or kProduct over a to b, with arguments[c .. c+extra)
  };
  /// Its result is register first_result + its place; a, b, c and extra are registers unless said
  /// otherwise.
  struct Instruction {
    Kind kind = Kind::kOperator;
    Step::Code code = Step::Code::kConstant;
    std::uint32_t a = 0, b = 0, c = 0, extra = 0;
    FunctionId function;
    auto operator<=>(const Instruction&) const = default;
  };
  /// Registers are the constants, then the parameters, then the results.
  struct Code {
    std::vector<double> constants;
    std::uint32_t parameter_count = 0;
    std::vector<Instruction> instructions;
    std::vector<std::uint32_t> arguments;
    std::uint32_t result = 0;
  };

  /// The table answers calls; it must outlive the program.
  FunctionProgram(Code code, const FunctionTable& table);

  double value(std::span<const double> arguments) const override;
  IntervalJet range(std::span<const IntervalJet> arguments) const override;

 private:
  void run(double* registers) const;
  void run(IntervalJet* registers) const;
  double call(const Instruction& i, const double* registers) const;
  double loop(const Instruction& i, const double* registers) const;

  Code code_;
  const FunctionTable& table_;
  std::uint32_t first_result_;
  std::size_t register_count_;
};

/// The program of a function of at most `parameter_count` arguments.
FunctionProgram::Code compile_function(const FunctionTable& table, FunctionId function,
                                       std::uint32_t parameter_count);

}  // namespace dioptre
