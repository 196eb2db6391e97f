// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/interval_jet.h"

#include <gtest/gtest.h>

#include <random>

#include "dioptre/core/expression_eval.h"

namespace dioptre {
namespace {

using Code = Step::Code;

class IntervalJetLaws : public testing::TestWithParam<int> {
 protected:
  Code code_ = static_cast<Code>(GetParam());
  std::mt19937_64 random_{static_cast<std::uint64_t>(GetParam())};

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  /// start + t step for t in [0, width].
  struct Line {
    double start, step, width;
    double at(double share) const { return start + share * width * step; }
    IntervalJet jet() const {
      const double p = at(0), q = at(1);
      if (step == 0) return IntervalJet::constant(start);
      return {widen({std::min(p, q), std::max(p, q)}), interval_of(step)};
    }
  };
  Line line(double width) {
    const double size = std::exp(uniform(-3, 2));
    const double start = uniform(-size, size);
    const bool still = uniform(0, 1) < 0.2, whole = uniform(0, 1) < 0.2;
    return {whole ? std::round(start) : start, still ? 0 : uniform(-2, 2), width};
  }
};

TEST_P(IntervalJetLaws, BoundsHoldAllValuesAndSlopes) {
  int bounded = 0;
  for (int i = 0; i < 4000; ++i) {
    const double width = std::exp(uniform(-8, 1));
    const Line a = line(width), b = line(width);
    const IntervalJet jet = evaluate_operator(code_, a.jet(), b.jet());
    ASSERT_LE(jet.value.min, jet.value.max);
    ASSERT_LE(jet.slope.min, jet.slope.max);
    bounded += !is_unbounded(jet.value);
    double last = 0;
    for (int k = 0; k <= 8; ++k) {
      const double value = evaluate_operator(code_, a.at(k / 8.0), b.at(k / 8.0));
      if (std::isinf(value) || std::isinf(last)) break;
      if (std::isnan(value)) {
        ASSERT_EQ(jet.value, Interval::all());
        ASSERT_EQ(jet.slope, Interval::all());
        break;
      }
      ASSERT_TRUE(jet.value.contains(value))
          << value << " not in " << jet.value.min << " " << jet.value.max << " of " << a.at(0)
          << " to " << a.at(1) << ", " << b.at(0) << " to " << b.at(1);
      const double slope = 8 * (value - last) / width;
      const double slack = 1e-14 * 8 * (std::fabs(value) + std::fabs(last) + 1) / width;
      if (k > 0) {
        ASSERT_TRUE(jet.slope.min <= slope + slack && slope - slack <= jet.slope.max)
            << slope << " not in " << jet.slope.min << " " << jet.slope.max << " of " << a.at(0)
            << " to " << a.at(1) << ", " << b.at(0) << " to " << b.at(1);
      }
      last = value;
    }
  }
  EXPECT_GT(bounded, 100) << "bounds that say nothing";
}

TEST_P(IntervalJetLaws, NarrowStretchesHaveNarrowBounds) {
  int narrow = 0, tried = 0;
  for (int i = 0; i < 2000; ++i) {
    Line a = line(1e-9), b = line(1e-9);
    if (code_ == Code::kMod) b.step = 0;  // the one operator that bounds no other remainders
    const double value = evaluate_operator(code_, a.at(0.5), b.at(0.5));
    if (std::isnan(value) || std::isinf(value)) continue;
    ++tried;
    const IntervalJet jet = evaluate_operator(code_, a.jet(), b.jet());
    narrow += jet.value.max - jet.value.min < 1e-5 * (1 + std::fabs(value));
  }
  EXPECT_GT(narrow, 0.75 * tried);
}

INSTANTIATE_TEST_SUITE_P(All, IntervalJetLaws,
                         testing::Range(static_cast<int>(Code::kAdd),
                                        static_cast<int>(Code::kSelect)));

TEST(IntervalJet, SelectionHoldsEveryBranchThatMayBeTaken) {
  const IntervalJet minus{{-2, -1}, {1, 1}}, zero{{0, 0}, {0, 0}}, both{{-1, 1}, {1, 1}};
  const IntervalJet a{{10, 11}, {2, 2}}, b{{20, 21}, {3, 3}}, c{{30, 31}, {4, 4}};
  EXPECT_EQ(select(minus, a, b, c).value, a.value);
  EXPECT_EQ(select(zero, a, b, c).value, b.value);
  EXPECT_EQ(select(both, a, b, c).value, (Interval{10, 31}));
  EXPECT_EQ(select(both, a, b, c).slope, Interval::all());
}

TEST(IntervalJet, OddBoundsGiveBounds) {
  const double ends[] = {-kInfinity, -1e308, -1, -1e-308, 0, 5e-324, 1, 1e20, 1e308, kInfinity};
  for (int code = 0; code < static_cast<int>(Code::kSelect); ++code) {
    for (const double p : ends) {
      for (const double q : ends) {
        if (p > q) continue;
        for (const double r : ends) {
          const IntervalJet a{{p, q}, {-1, std::max(r, -1.0)}},
              b{{std::min(p, r), r}, {0, kInfinity}};
          const IntervalJet jet = evaluate_operator(static_cast<Code>(code), a, b);
          EXPECT_LE(jet.value.min, jet.value.max) << code << " " << p << " " << q << " " << r;
          EXPECT_LE(jet.slope.min, jet.slope.max) << code << " " << p << " " << q << " " << r;
        }
      }
    }
  }
}

}  // namespace
}  // namespace dioptre
