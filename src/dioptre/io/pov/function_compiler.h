// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {

/// The step that a function of one or two numbers stands for, if it is one.
std::optional<Step::Code> math_code(Keyword k);
bool has_two_arguments(Step::Code code);

/// Compiles the body of a user function: everything that is known now becomes a constant, the rest
/// steps.
class FunctionCompiler {
 public:
  FunctionCompiler(Interpreter& interpreter, std::string name, std::vector<std::string> parameters)
      : in_(interpreter), name_(std::move(name)), parameters_(std::move(parameters)) {}

  /// The expression at the next tokens, up to the closing brace or parenthesis.
  Expression compile();

 private:
  using Place = std::uint32_t;
  Place add(Step::Code code, Place a = 0, Place b = 0);
  Place constant(double value);
  Place logical_or();
  Place logical_and();
  Place relation();
  Place sum();
  Place product();
  Place factor();
  Place primary();
  Place name();
  Place keyword(Keyword k);
  Place parenthesised();
  Place call(const FunctionValue& function);
  Place call_component(FunctionId function, const std::vector<Place>& arguments);
  FunctionId component_function(const FunctionValue& function);
  FunctionId spline_component(const Spline& spline);
  Place extremum(Step::Code code);
  Place select();
  Place rounds(Step::Code code);
  std::optional<std::uint32_t> parameter(const Token& token) const;
  std::vector<Place> arguments();

  Interpreter& in_;
  std::string name_;
  std::vector<std::string> parameters_;
  Expression expression_;
};

}  // namespace dioptre::pov
