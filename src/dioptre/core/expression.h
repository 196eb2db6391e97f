// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/id.h"

namespace dioptre {

struct Function;

/// One step of an expression. Its result is known by its place in Expression::steps; `a`, `b`, `c`
/// are places of earlier steps unless said otherwise.
struct Step {
  enum class Code : std::uint8_t {
    kConstant,   ///< value
    kParameter,  ///< parameter number a
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kNegate,
    kLess,
    kLessEqual,
    kGreater,
    kGreaterEqual,
    kEqual,
    kNotEqual,
    kAnd,
    kOr,
    kNot,  ///< 1 or 0
    kAbs,
    kAcos,
    kAcosh,
    kAsin,
    kAsinh,
    kAtan,
    kAtanh,
    kCeil,
    kCos,
    kCosh,
    kDegrees,
    kExp,
    kFloor,
    kInt,
    kLn,
    kLog,
    kRadians,
    kSin,
    kSinh,
    kSqrt,
    kTan,
    kTanh,
    kAtan2,
    kDiv,
    kMin,
    kMax,
    kMod,
    kPow,
    kSelect,  ///< value of b if a < 0, of c if a = 0, of step number `extra` if a > 0
    kCall,    ///< function `function`, arguments: the steps arguments[a .. a+b)
    kSum,
    kProduct,  ///< over i from a to b by 1, of `function`, whose last parameter is i and
               ///< whose first are this expression's own parameters
  };
  Code code = Code::kConstant;
  std::uint32_t a = 0, b = 0, c = 0, extra = 0;
  double value = 0;
  Id<Function> function;
  bool operator==(const Step&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("code", self.code);
    visit("a", self.a);
    visit("b", self.b);
    visit("c", self.c);
    visit("extra", self.extra);
    visit("value", self.value);
    visit("function", self.function);
  }
};

/// A user function's body as a flat list: the last step is the result. Data only; it can be run on
/// numbers, on intervals, or on batches.
struct Expression {
  std::vector<Step> steps;
  std::vector<std::uint32_t> arguments;  ///< of the calls, as places of steps
  bool operator==(const Expression&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("steps", self.steps);
    visit("arguments", self.arguments);
  }
};

}  // namespace dioptre
