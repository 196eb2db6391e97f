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
  std::uniform_real_distribution<double> u(-3, 3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> expected(1 + trial % 6);
    for (double& r : expected) r = u(random);
    std::sort(expected.begin(), expected.end());
    bool apart = true;
    for (std::size_t i = 1; i < expected.size(); ++i) apart &= expected[i] - expected[i - 1] > 0.05;
    if (!apart) continue;
    const auto found = polynomial_roots(polynomial_with(expected), {-4, 4});
    ASSERT_EQ(found.count, expected.size());
    for (std::size_t i = 0; i < found.count; ++i) {
      EXPECT_NEAR(found.t[i], expected[i], 16 * found.error[i] + 1e-9);
    }
  }
}

TEST(PolynomialRoots, ADoubleRootIsFoundTwiceOrNotAtAll) {
  EXPECT_EQ(polynomial_roots(polynomial_with({1, 1}), {-4, 4}).count % 2, 0u);
  EXPECT_EQ(polynomial_roots(polynomial_with({1, 1, 2}), {-4, 4}).count % 2, 1u);
}

TEST(PolynomialRoots, TheIntervalLimitsTheRoots) {
  const auto c = polynomial_with({-1, 0.5, 2});
  EXPECT_EQ(polynomial_roots(c, {0, 1}).count, 1u);
  EXPECT_EQ(polynomial_roots(c, {1, 0}).count, 0u);
}

TEST(PolynomialRoots, TheBoundHoldsAllRoots) {
  for (const auto& roots : {std::vector<double>{1000, -3}, {0.001, 5, -77}}) {
    const double bound = root_bound(polynomial_with(roots));
    for (const double r : roots) EXPECT_LE(std::fabs(r), bound);
  }
}

TEST(PolynomialRoots, OddInputFindsNothing) {
  EXPECT_EQ(polynomial_roots({}, {-1, 1}).count, 0u);
  EXPECT_EQ(polynomial_roots(std::vector<double>{0, 0, 0}, {-1, 1}).count, 0u);
  EXPECT_EQ(polynomial_roots(std::vector<double>{1, NAN}, {-1, 1}).count, 0u);
}

}  // namespace
}  // namespace dioptre
