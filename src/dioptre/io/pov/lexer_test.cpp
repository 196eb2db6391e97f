// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/lexer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace dioptre::pov {
namespace {

Program lexed(const std::string& text) {
  Symbols symbols;
  return lex("test", text, 0, symbols);
}

TEST(Lexer, NumbersAreTheNearestThatAreWritten) {
  std::mt19937_64 random(1);
  std::string text;
  std::vector<std::string> written{"0",
                                   ".5",
                                   "5.",
                                   "1e5",
                                   "1.e-3",
                                   "9007199254740993",
                                   "0.1234567890123456",
                                   "123456789012345678901234567890"};
  for (int i = 0; i < 20000; ++i) {
    std::string digits = std::to_string(random() >> (random() % 60));
    const std::size_t point = random() % (digits.size() + 1);
    if (random() % 4 > 0) digits.insert(point, 1, '.');
    if (digits != ".") written.push_back(digits);
  }
  for (const std::string& number : written) text += number + " ";
  const Program program = lexed(text);
  ASSERT_EQ(program.tokens.size(), written.size() + 1);
  for (std::size_t i = 0; i < written.size(); ++i) {
    EXPECT_EQ(program.tokens[i].kind, Token::Kind::kNumber) << written[i];
    EXPECT_EQ(program.tokens[i].number, std::strtod(written[i].c_str(), nullptr)) << written[i];
  }
}

TEST(Lexer, PlacesCountLinesOfAnyKindAndCharactersNotBytes) {
  const Program program = lexed("a // b\rc /* d\r\n/* e */ \n */ f\n\"\xC3\xA9\" g // end");
  ASSERT_EQ(program.tokens.size(), 6u);
  const auto at = [&](std::size_t i, std::uint32_t line, std::uint32_t column) {
    EXPECT_EQ(program.tokens[i].position.line, line) << i;
    EXPECT_EQ(program.tokens[i].position.column, column) << i;
  };
  at(0, 1, 1);
  at(1, 2, 1);
  at(2, 4, 5);
  at(3, 5, 1);
  at(4, 5, 5);
  EXPECT_EQ(program.tokens[5].kind, Token::Kind::kEnd);
}

TEST(Lexer, EqualNamesHaveOneNumber) {
  Symbols symbols;
  std::vector<Symbol> first;
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 2000; ++i) {
      const Symbol symbol = symbols.intern("name_" + std::to_string(i));
      if (round == 0) first.push_back(symbol);
      EXPECT_EQ(symbol, first[static_cast<std::size_t>(i)]);
    }
  }
  EXPECT_EQ(symbols.intern("sphere"), static_cast<Symbol>(Keyword::kSphere));
}

}  // namespace
}  // namespace dioptre::pov
