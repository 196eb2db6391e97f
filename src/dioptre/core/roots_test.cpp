// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace dioptre {
namespace {

std::vector<double> polynomial_with(const std::vector<double>& roots) {
  std::vector<double> c{1};
  for (const double r : roots) {
    c.push_back(0);
    for (std::size_t k = c.size(); k-- > 0;) c[k] = (k > 0 ? c[k - 1] : 0) - r * c[k];
  }
  return c;
}

TEST(PolynomialRoots, FindsEverySimpleRootWithinItsErrorBound) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> u(-0.8, 0.8);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> expected(1 + trial % 6);
    for (double& r : expected) r = u(random);
    std::sort(expected.begin(), expected.end());
    bool apart = true;
    for (std::size_t i = 1; i < expected.size(); ++i) apart &= expected[i] - expected[i - 1] > 0.02;
    if (!apart) continue;
    const auto found = polynomial_roots(polynomial_with(expected), {-1, 1});
    ASSERT_EQ(found.count, expected.size());
    for (std::size_t i = 0; i < found.count; ++i) {
      EXPECT_NEAR(found.t[i], expected[i], 16 * found.error[i] + 1e-9);
    }
  }
}

TEST(PolynomialRoots, ADoubleRootIsFoundTwiceOrNotAtAll) {
  const Interval all{-1, 1};
  EXPECT_EQ(polynomial_roots(polynomial_with({0.3, 0.3}), all).count % 2, 0u);
  EXPECT_EQ(polynomial_roots(polynomial_with({0.3, 0.3, 0.7}), all).count % 2, 1u);
  EXPECT_EQ(polynomial_roots(polynomial_with({0, 0}), all).count % 2, 0u);
}

TEST(PolynomialRoots, TheIntervalLimitsTheRoots) {
  const auto c = polynomial_with({-0.9, -0.2, 0, 0.5, 2});
  const Interval cases[] = {{-1, 1},     {-kInfinity, kInfinity},
                            {0.1, 1},    {-0.5, -0.1},
                            {-0.1, 0.6}, {0.6, 1},
                            {-1, -0.95}, {5, 9},
                            {-9, -5},    {1, 0}};
  for (const Interval wanted : cases) {
    std::vector<double> expected;
    for (const double r : {-0.9, -0.2, 0.0, 0.5}) {
      if (wanted.surrounds(r)) expected.push_back(r);
    }
    const PolynomialRoots found = polynomial_roots(c, wanted);
    ASSERT_EQ(found.count, expected.size()) << wanted.min << " " << wanted.max;
    for (std::size_t i = 0; i < found.count; ++i) EXPECT_NEAR(found.t[i], expected[i], 1e-12);
    EXPECT_EQ(polynomial_roots(c, wanted, 1).count, std::min<std::size_t>(1, expected.size()));
  }
}

TEST(PolynomialRoots, TheSignBeforeTheFirstIsThatOfThePolynomial) {
  const std::vector<double> at{-0.9, -0.2, 0, 0.5};
  auto c = polynomial_with(at);
  for (const double sign : {1.0, -1.0}) {
    for (double low = -1.95; low < 1.9; low += 0.1) {
      const auto below = std::count_if(at.begin(), at.end(), [&](double r) { return r < low; });
      const bool negative = (below % 2 == 1) == (sign > 0);
      EXPECT_EQ(polynomial_roots(c, {low, kInfinity}).starts_negative, negative) << low;
    }
    for (double& v : c) v = -v;
  }
}

TEST(PolynomialRoots, TheBoundHoldsAllRoots) {
  for (const auto& roots : {std::vector<double>{1000, -3}, {0.001, 5, -77}, {0, 0, 1e-9}}) {
    const double bound = std::ldexp(1.0, root_bound_exponent(polynomial_with(roots)));
    for (const double r : roots) EXPECT_LT(std::fabs(r), bound);
  }
}

TEST(PolynomialRoots, OddInputFindsNothing) {
  EXPECT_EQ(polynomial_roots({}, {-1, 1}).count, 0u);
  EXPECT_EQ(polynomial_roots(std::vector<double>{0, 0, 0}, {-1, 1}).count, 0u);
  EXPECT_EQ(polynomial_roots(std::vector<double>{1, NAN}, {-1, 1}).count, 0u);
}

}  // namespace
}  // namespace dioptre
