// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "dioptre/scene/function.h"
#include "dioptre/shading/functions/spline_function.h"
#include "dioptre/shading/patterns/pattern_evaluator.h"
#include "dioptre/shading/pigments/pigment_evaluator.h"

namespace dioptre {

/// All functions of a scene, by id.
class FunctionTable {
 public:
  /// Makes all functions of the scene ready. The table must not move afterwards.
  void compile(const Scene& scene, const PigmentTable& pigments, const PatternServices& services);

  /// The value for given arguments: missing ones are 0, further ones are ignored. Total: NaN where
  /// there is no value. 0 for no function.
  double call(FunctionId id, std::span<const double> arguments) const;

 private:
  struct PigmentPart {
    PigmentId pigment;
    std::uint32_t component;
  };
  using Body = std::variant<Expression, InternalFunction, std::unique_ptr<PatternEvaluator>,
                            PigmentPart, SplineEvaluator>;
  double value(const Expression& body, std::span<const double> arguments) const;
  double value(const PigmentPart& part, std::span<const double> arguments) const;

  const PigmentTable* pigments_ = nullptr;
  std::vector<Body> functions_;
};

}  // namespace dioptre
