// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/spelling.h"

#include <gtest/gtest.h>

namespace dioptre {
namespace {

TEST(Spelling, DistanceCountsSingleLetters) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("pigmet", "pigment"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("Width", "WIDTH"), 0u);
}

TEST(Spelling, DistanceIsTheSameBothWays) {
  for (const char* a : {"sphere", "speher", "shpere", "x"}) {
    for (const char* b : {"sphere", "torus", ""}) {
      EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
    }
  }
}

TEST(Spelling, OnlyLikeWordsAreMisspellings) {
  EXPECT_TRUE(is_misspelling("pigmet", "pigment"));
  EXPECT_TRUE(is_misspelling("decalre", "declare"));
  EXPECT_FALSE(is_misspelling("Foo", "fog"));
  EXPECT_FALSE(is_misspelling("Radius", "radiosity"));
}

}  // namespace
}  // namespace dioptre
