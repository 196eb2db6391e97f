// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/functions/function_table.h"

#include <limits>

#include "dioptre/core/expression_eval.h"
#include "dioptre/shading/functions/function_program.h"
#include "dioptre/shading/functions/internal_function_table.h"

namespace dioptre {
namespace {

double argument(std::span<const double> arguments, std::size_t i) {
  return i < arguments.size() ? arguments[i] : 0;
}

Vec3 point(std::span<const double> arguments) {
  return {argument(arguments, 0), argument(arguments, 1), argument(arguments, 2)};
}

double component_of(const PigmentColor& c, std::uint32_t component) {
  switch (component) {
    case 0:
      return c.color.r;
    case 1:
      return c.color.g;
    case 2:
      return c.color.b;
    case 3:
      return c.filter;
    case 4:
      return c.transmit;
    case 5:
      return gray(c.color);
    default:  // heights of 16 bits: red counts whole steps, green parts of one
      return (255.0 * c.color.r + c.color.g) / 256;
  }
}

}  // namespace

void FunctionTable::compile(const Scene& scene, const PigmentTable& pigments,
                            const PatternServices& services) {
  pigments_ = &pigments;
  functions_.reserve(scene.functions.size());
  for (const Function& function : scene.functions) {
    if (const auto* expression = std::get_if<ExpressionFunction>(&function.body)) {
      functions_.emplace_back(expression->body);
    } else if (const auto* internal = std::get_if<InternalFunction>(&function.body)) {
      functions_.emplace_back(*internal);
    } else if (const auto* pattern = std::get_if<PatternFunction>(&function.body)) {
      functions_.emplace_back(std::make_unique<PatternEvaluator>(pattern->pattern, services));
    } else if (const auto* pigment = std::get_if<PigmentFunction>(&function.body)) {
      functions_.emplace_back(PigmentPart{pigment->pigment, pigment->component});
    } else {
      functions_.emplace_back(SplineEvaluator(std::get<SplineFunction>(function.body)));
    }
  }
}

double FunctionTable::call(FunctionId id, std::span<const double> arguments) const {
  if (id.index >= functions_.size()) return 0;
  const Body& body = functions_[id.index];
  if (const auto* expression = std::get_if<Expression>(&body)) return value(*expression, arguments);
  if (const auto* internal = std::get_if<InternalFunction>(&body)) {
    return internal_function(internal->number, arguments);
  }
  if (const auto* pattern = std::get_if<std::unique_ptr<PatternEvaluator>>(&body)) {
    return (*pattern)->value(point(arguments), {});
  }
  if (const auto* part = std::get_if<PigmentPart>(&body)) return value(*part, arguments);
  return std::get<SplineEvaluator>(body).at(argument(arguments, 0));
}

std::unique_ptr<const ScalarField> FunctionTable::field(FunctionId id) const {
  if (id.index >= functions_.size()) return nullptr;
  return std::make_unique<const FunctionProgram>(compile_function(*this, id, 3), *this);
}

std::optional<std::uint32_t> FunctionTable::internal_number(FunctionId id) const {
  const auto* internal = body_as<InternalFunction>(id);
  return internal ? std::optional(internal->number) : std::nullopt;
}

Interval FunctionTable::range_of(FunctionId id) const {
  const auto* pattern = body_as<std::unique_ptr<PatternEvaluator>>(id);
  return pattern && !(*pattern)->block() ? Interval{0, 1} : Interval::all();
}

double FunctionTable::value(const Expression& body, std::span<const double> arguments) const {
  const Nesting nesting;
  if (nesting.too_deep()) return std::numeric_limits<double>::quiet_NaN();
  return evaluate(body, arguments,
                  [this](FunctionId id, std::span<const double> inner) { return call(id, inner); });
}

double FunctionTable::value(const PigmentPart& part, std::span<const double> arguments) const {
  return component_of(pigments_->color(part.pigment, {point(arguments), {}, {}}), part.component);
}

}  // namespace dioptre
