// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "dioptre/core/scalar_field.h"
#include "dioptre/scene/function.h"
#include "dioptre/shading/functions/spline_function.h"
#include "dioptre/shading/patterns/pattern_evaluator.h"
#include "dioptre/shading/pigments/pigment_evaluator.h"

namespace dioptre {

/// All functions of a scene, by id.
class FunctionTable final : public ScalarFields {
 public:
  /// Makes all functions of the scene ready. The table must not move afterwards.
  void compile(const Scene& scene, const PigmentTable& pigments, const PatternServices& services);

  /// The value for given arguments: missing ones are 0, further ones are ignored. Total: NaN where
  /// there is no value. 0 for no function.
  double call(FunctionId id, std::span<const double> arguments) const;

  /// The function as a field of up to three arguments.
  std::unique_ptr<const ScalarField> field(FunctionId id) const override;

  /// The formula that the function is, if it is one.
  const Expression* formula(FunctionId id) const { return body_as<Expression>(id); }
  /// The number of the built-in function that it is, if it is one.
  std::optional<std::uint32_t> internal_number(FunctionId id) const;
  /// Bounds of its values that hold everywhere.
  Interval range_of(FunctionId id) const;

 private:
  struct PigmentPart {
    PigmentId pigment;
    std::uint32_t component;
  };
  using Body = std::variant<Expression, InternalFunction, std::unique_ptr<PatternEvaluator>,
                            PigmentPart, SplineEvaluator>;
  template <class T>
  const T* body_as(FunctionId id) const {
    return id.index < functions_.size() ? std::get_if<T>(&functions_[id.index]) : nullptr;
  }
  double value(const Expression& body, std::span<const double> arguments) const;
  double value(const PigmentPart& part, std::span<const double> arguments) const;

  const PigmentTable* pigments_ = nullptr;
  std::vector<Body> functions_;
};

}  // namespace dioptre
