// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "dioptre/shading/functions/internal_function_table.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kNumbers = 100;

TEST(InternalFunctions, AgreeWithTheReferenceValues) {
  std::ifstream file(std::string(DIOPTRE_SOURCE_DIR) +
                     "/src/dioptre/shading/functions/internal_functions_golden.tsv");
  ASSERT_TRUE(file.is_open());
  std::string line;
  std::size_t count = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::uint32_t number = 0;
    std::string name;
    double expected = 0;
    fields >> number >> name >> expected;
    std::vector<double> arguments;
    for (double v; fields >> v;) arguments.push_back(v);
    EXPECT_EQ(internal_parameter_count(number), arguments.size()) << name;
    EXPECT_NEAR(internal_function(number, arguments), expected,
                1e-9 * std::max(1.0, std::abs(expected)))
        << line;
    ++count;
  }
  EXPECT_GT(count, 1000u);
}

TEST(InternalFunctions, MissingArgumentsCountAsZero) {
  constexpr std::array<double, 13> kArguments{0.3, 0.4, 0.5};
  for (std::uint32_t n = 0; n < kNumbers; ++n) {
    const double full = internal_function(n, kArguments);
    const double short_list = internal_function(n, std::span(kArguments).first(3));
    EXPECT_TRUE(full == short_list || (std::isnan(full) && std::isnan(short_list))) << n;
  }
}

TEST(InternalFunctions, EveryNumberOfTheIncludeFileIsKnown) {
  for (std::uint32_t n = 0; n <= 78; ++n) {
    if (n != 77) {
      EXPECT_GE(internal_parameter_count(n), 3u) << n;
    }
  }
}

TEST(InternalFunctions, UnknownNumbersGiveZero) {
  for (const std::uint32_t n : {77u, 79u, 1000u, ~0u}) {
    EXPECT_EQ(internal_parameter_count(n), 0u);
    EXPECT_EQ(internal_function(n, std::array{1.0, 2.0, 3.0}), 0);
  }
}

TEST(InternalFunctions, StrangeArgumentsAreSafe) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double v : {std::nan(""), kInfinity, -kInfinity, 1e300, -1e300, 0.0}) {
    const std::vector<double> arguments(20, v);
    for (std::uint32_t n = 0; n < kNumbers; ++n) internal_function(n, arguments);
  }
}

}  // namespace
}  // namespace dioptre
