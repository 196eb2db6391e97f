// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "dioptre/core/expression.h"

namespace dioptre {

/// Two numbers count as equal, and a number as false, within this distance: the scene language's
/// own tolerance.
constexpr double kEqualityTolerance = 1e-10;
inline bool is_true(double v) { return !(std::fabs(v) < kEqualityTolerance); }
inline bool are_equal(double a, double b) {
  return a == b || std::fabs(a - b) < kEqualityTolerance;
}

/// The most rounds that a sum or product in a function runs.
constexpr double kMostRounds = 1e7;

/// The value of a step of one or two operands, whose values are a and b.
inline double evaluate_operator(Step::Code code, double a, double b) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  using C = Step::Code;
  switch (code) {
    case C::kAdd:
      return a + b;
    case C::kSubtract:
      return a - b;
    case C::kMultiply:
      return a * b;
    case C::kDivide:
      return a / b;
    case C::kNegate:
      return -a;
    case C::kLess:
      return a < b;
    case C::kLessEqual:
      return a <= b || are_equal(a, b);
    case C::kGreater:
      return a > b;
    case C::kGreaterEqual:
      return a >= b || are_equal(a, b);
    case C::kEqual:
      return are_equal(a, b);
    case C::kNotEqual:
      return !are_equal(a, b);
    case C::kAnd:
      return is_true(a) && is_true(b);
    case C::kOr:
      return is_true(a) || is_true(b);
    case C::kNot:
      return !is_true(a);
    case C::kAbs:
      return std::fabs(a);
    case C::kAcos:
      return std::acos(a);
    case C::kAcosh:
      return std::acosh(a);
    case C::kAsin:
      return std::asin(a);
    case C::kAsinh:
      return std::asinh(a);
    case C::kAtan:
      return std::atan(a);
    case C::kAtanh:
      return std::atanh(a);
    case C::kCeil:
      return std::ceil(a);
    case C::kCos:
      return std::cos(a);
    case C::kCosh:
      return std::cosh(a);
    case C::kDegrees:
      return a / kDegree;
    case C::kExp:
      return std::exp(a);
    case C::kFloor:
      return std::floor(a);
    case C::kInt:
      return std::trunc(a);
    case C::kLn:
      return std::log(a);
    case C::kLog:
      return std::log10(a);
    case C::kRadians:
      return a * kDegree;
    case C::kSin:
      return std::sin(a);
    case C::kSinh:
      return std::sinh(a);
    case C::kSqrt:
      return std::sqrt(a);
    case C::kTan:
      return std::tan(a);
    case C::kTanh:
      return std::tanh(a);
    case C::kAtan2:
      return std::atan2(a, b);
    case C::kDiv:
      return std::trunc(a / b);
    case C::kMin:
      return a < b ? a : b;
    case C::kMax:
      return a > b ? a : b;
    case C::kMod:
      return std::fmod(a, b);
    case C::kPow:
      return std::pow(a, b);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

namespace detail {

template <class Call>
double accumulate_rounds(const Step& step, std::span<const double> args, double from, double to,
                         Call& call) {
  std::array<double, 65> inner{};
  const std::size_t outer = std::min<std::size_t>(args.size(), inner.size() - 1);
  std::copy_n(args.begin(), outer, inner.begin());
  const bool sum = step.code == Step::Code::kSum;
  double result = sum ? 0 : 1;
  if (!(to - from < kMostRounds)) return std::numeric_limits<double>::quiet_NaN();
  for (double i = from; i <= to; i += 1) {
    inner[outer] = i;
    const double value = call(step.function, std::span<const double>(inner.data(), outer + 1));
    result = sum ? result + value : result * value;
  }
  return result;
}

template <class Call>
double call_function(const Expression& e, const Step& step, const double* value, Call& call) {
  std::array<double, 64> args;
  const std::size_t count = std::min<std::size_t>(step.b, args.size());
  for (std::size_t k = 0; k < count; ++k) args[k] = value[e.arguments[step.a + k]];
  return call(step.function, std::span<const double>(args.data(), count));
}

template <class Call>
void evaluate_steps(const Expression& e, std::span<const double> args, double* value, Call& call) {
  for (std::size_t i = 0; i < e.steps.size(); ++i) {
    const Step& s = e.steps[i];
    switch (s.code) {
      case Step::Code::kConstant:
        value[i] = s.value;
        break;
      case Step::Code::kParameter:
        value[i] = s.a < args.size() ? args[s.a] : 0;
        break;
      case Step::Code::kSelect:
        value[i] = value[value[s.a] < 0 ? s.b : value[s.a] > 0 ? s.extra : s.c];
        break;
      case Step::Code::kCall:
        value[i] = call_function(e, s, value, call);
        break;
      case Step::Code::kSum:
      case Step::Code::kProduct:
        value[i] = accumulate_rounds(s, args, value[s.a], value[s.b], call);
        break;
      default:
        value[i] = evaluate_operator(s.code, value[s.a], value[s.b]);
    }
  }
}

}  // namespace detail

/// The value of an expression of at least one step for given parameters (missing ones are 0).
/// `call(Id<Function>, std::span<const double>)` gives the value of another function. Allocates
/// only if there are more than 64 steps. Total: any arguments give a number, perhaps NaN.
template <class Call>
double evaluate(const Expression& e, std::span<const double> args, Call&& call) {
  constexpr std::size_t kFew = 64;
  const std::size_t count = e.steps.size();
  if (count == 0) return 0;
  if (count <= kFew) {
    double value[kFew];
    detail::evaluate_steps(e, args, value, call);
    return value[count - 1];
  }
  const auto value = std::make_unique_for_overwrite<double[]>(count);
  detail::evaluate_steps(e, args, value.get(), call);
  return value[count - 1];
}

}  // namespace dioptre
