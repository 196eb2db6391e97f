// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "dioptre/core/expression.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/ids.h"
#include "dioptre/scene/pattern.h"

namespace dioptre {

/// A formula.
struct ExpressionFunction {
  static constexpr const char* kName = "expression";
  Expression body;
  bool operator==(const ExpressionFunction&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("body", self.body);
  }
};

/// One of the built-in f_... functions, by its number in functions.inc.
struct InternalFunction {
  static constexpr const char* kName = "internal";
  std::uint32_t number = 0;
  bool operator==(const InternalFunction&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("number", self.number);
  }
};

/// The value of a pattern at (x, y, z).
struct PatternFunction {
  static constexpr const char* kName = "pattern";
  Pattern pattern;
  bool operator==(const PatternFunction&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pattern", self.pattern);
  }
};

/// One component of a pigment at (x, y, z).
struct PigmentFunction {
  static constexpr const char* kName = "pigment";
  PigmentId pigment;
  std::uint32_t component = 0;  ///< 0 to 4: red, green, blue, filter, transmit; 5: grey; 6: hf
  bool operator==(const PigmentFunction&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("pigment", self.pigment);
    visit("component", self.component);
  }
};

/// A value of a spline at a place.
struct SplineKnot {
  double at = 0;
  std::vector<double> value;
  bool operator==(const SplineKnot&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("at", self.at);
    visit("value", self.value);
  }
};

/// One component of a spline at the first parameter.
struct SplineFunction {
  static constexpr const char* kName = "spline";
  std::uint32_t kind = 0;  ///< linear, quadratic, cubic, natural
  std::vector<SplineKnot> knots;
  std::uint32_t component = 0;
  bool operator==(const SplineFunction&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("kind", self.kind);
    visit("knots", self.knots);
    visit("component", self.component);
  }
};

/// A user function of numbers to a number. Parameters are passed in order.
struct Function {
  using Body = std::variant<ExpressionFunction, InternalFunction, PatternFunction, PigmentFunction,
                            SplineFunction>;
  std::string name;
  std::vector<std::string> parameters;
  Body body;
  bool operator==(const Function&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("name", self.name);
    visit("parameters", self.parameters);
    visit("body", self.body);
  }
};

}  // namespace dioptre
