// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/image/read_density.h"

#include <gtest/gtest.h>

#include <string>

namespace dioptre {
namespace {

TEST(Df3, TheLengthTellsTheWidthOfTheValues) {
  const std::string header("\0\2\0\1\0\1", 6);
  for (const std::size_t width : {1u, 2u, 4u}) {
    const std::string body = std::string(width, '\xff') + std::string(width, '\0');
    const auto grid = decode_density(header + body);
    ASSERT_TRUE(grid) << width;
    EXPECT_EQ(grid->width, 2u);
    EXPECT_EQ(grid->values, (std::vector<float>{1, 0})) << width;
  }
}

TEST(Df3, WhatIsTooShortOrEmptyIsRefused) {
  EXPECT_FALSE(decode_density(""));
  EXPECT_FALSE(decode_density(std::string_view("\0\2\0\1", 4)));
  EXPECT_FALSE(decode_density(std::string_view("\0\2\0\1\0\1x", 7)));
  EXPECT_FALSE(decode_density(std::string_view("\0\0\0\1\0\1xyz", 9)));
  EXPECT_FALSE(decode_density("\xff\xff\xff\xff\xff\xff..."));
}

}  // namespace
}  // namespace dioptre
