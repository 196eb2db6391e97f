// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dioptre/shading/texture_evaluator.h"

namespace dioptre {
namespace {

using Code = Step::Code;

/// Formulas at random, in a scene whose first functions are noise, a ball and a pattern.
class RandomFormulas : public testing::TestWithParam<int> {
 protected:
  std::mt19937_64 random_{static_cast<std::uint64_t>(GetParam())};
  Scene scene_;

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::uint32_t below(std::size_t count) {
    return std::uniform_int_distribution<std::uint32_t>(
        0, static_cast<std::uint32_t>(count - 1))(random_);
  }

  void add_known_functions() {
    for (const std::uint32_t number : {76u, 61u, 70u, 17u, 60u}) {
      scene_.functions.push_back({"", {"x", "y", "z", "r", "s"}, InternalFunction{number}});
    }
    scene_.functions.push_back({"", {"x", "y", "z"}, PatternFunction{}});
  }

  Step random_step(Expression& body) {
    constexpr Code kCodes[] = {Code::kAdd, Code::kSubtract, Code::kMultiply, Code::kMultiply,
                               Code::kSin, Code::kCos,      Code::kMin,      Code::kMax,
                               Code::kAbs, Code::kNegate,   Code::kTanh,     Code::kAtan};
    const std::size_t count = body.steps.size();
    Step step;
    const std::uint32_t kind = below(6);
    if (kind == 0) {
      step.code = Code::kConstant, step.value = uniform(-2, 2);
    } else if (kind == 1) {
      step.code = Code::kCall, step.b = 5;
      step.a = static_cast<std::uint32_t>(body.arguments.size());
      for (int k = 0; k < 5; ++k) body.arguments.push_back(below(count));
      step.function = {below(scene_.functions.size())};
    } else {
      step.code = kCodes[below(std::size(kCodes))];
      step.a = below(count), step.b = below(count);
    }
    return step;
  }

  FunctionId add_formula() {
    Expression body;
    for (std::uint32_t k = 0; k < 3; ++k) {
      Step step;
      step.code = Code::kParameter, step.a = k;
      body.steps.push_back(step);
    }
    for (int k = 0; k < 12; ++k) body.steps.push_back(random_step(body));
    return append(scene_.functions, {"", {"x", "y", "z"}, ExpressionFunction{body}});
  }
};

TEST_P(RandomFormulas, ProgramsGiveTheValuesAndRangesHoldThem) {
  add_known_functions();
  for (int k = 0; k < 6; ++k) add_formula();
  const auto evaluator = TextureEvaluator::compile(scene_, nullptr).value();
  for (std::uint32_t f = 0; f < scene_.functions.size(); ++f) {
    const auto field = evaluator->fields().field({f});
    ASSERT_NE(field, nullptr);
    for (int i = 0; i < 60; ++i) {
      const double width = std::exp(uniform(-6, 0.5));
      double start[3], step[3];
      IntervalJet line[3];
      for (int k = 0; k < 3; ++k) {
        start[k] = uniform(-3, 3), step[k] = uniform(-1, 1);
        const double end = start[k] + width * step[k];
        line[k] = {widen({std::min(start[k], end), std::max(start[k], end)}), interval_of(step[k])};
      }
      const IntervalJet range = field->range(line);
      double last = 0;
      for (int n = 0; n <= 6; ++n) {
        const double t = width * n / 6;
        const double p[3] = {start[0] + t * step[0], start[1] + t * step[1],
                             start[2] + t * step[2]};
        const double value = field->value(p), called = evaluator->call({f}, p);
        ASSERT_NEAR(value, called, 1e-9 * (1 + std::fabs(called)));
        const double slack = 1e-12 * (1 + std::fabs(value));
        ASSERT_TRUE(range.value.min - slack <= value && value <= range.value.max + slack);
        const double slope = 6 * (value - last) / width, rounding = 12 * slack / width;
        if (n > 0) {
          ASSERT_TRUE(range.slope.min - rounding <= slope && slope <= range.slope.max + rounding);
        }
        last = value;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Many, RandomFormulas, testing::Range(0, 40));

/// Each function adds the one before it twice: 2^n terms that are all the same.
TEST(FunctionProgram, ChainsOfCallsAreShort) {
  Scene scene;
  Expression first, twice;
  first.steps.resize(1);
  first.steps[0].code = Code::kParameter;
  scene.functions.push_back({"", {"x"}, ExpressionFunction{first}});
  for (std::uint32_t k = 0; k < 30; ++k) {
    twice.arguments = {0, 0};
    twice.steps.assign(4, {});
    twice.steps[0].code = Code::kParameter;
    for (std::uint32_t call : {1u, 2u}) {
      twice.steps[call].code = Code::kCall;
      twice.steps[call].a = call - 1, twice.steps[call].b = 1;
      twice.steps[call].function = {k};
    }
    twice.steps[3].code = Code::kAdd;
    twice.steps[3].a = 1, twice.steps[3].b = 2;
    scene.functions.push_back({"", {"x"}, ExpressionFunction{twice}});
  }
  const auto evaluator = TextureEvaluator::compile(scene, nullptr).value();
  const double x = 1;
  EXPECT_EQ(evaluator->fields().field({8})->value({&x, 1}), 256);
  ASSERT_NE(evaluator->fields().field({30}), nullptr);
}

}  // namespace
}  // namespace dioptre
