// SPDX-License-Identifier: Apache-2.0
// Strings and the functions that make them.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

constexpr double kWidestNumber = 1000;

}  // namespace

std::string shortest(double value) {
  char text[32];
  const int size = std::snprintf(text, sizeof text, "%g", value);
  return std::string(text, static_cast<std::size_t>(size));
}

double days_now() {
  constexpr double kEpoch2000 = 946684800, kSecondsPerDay = 86400;
  const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
  return (now.count() - kEpoch2000) / kSecondsPerDay;
}

bool Interpreter::at_string() {
  const Token& token = peek();
  if (token.kind == Token::Kind::kString) return true;
  if (token.kind != Token::Kind::kName) return false;
  if (token.index >= kKeywordCount) {
    const Value* value = operand();
    return value && get_if<const std::string>(*value);
  }
  switch (static_cast<Keyword>(token.index)) {
    case Keyword::kStr:
    case Keyword::kVstr:
    case Keyword::kConcat:
    case Keyword::kChr:
    case Keyword::kSubstr:
    case Keyword::kStrupr:
    case Keyword::kStrlwr:
    case Keyword::kDatetime:
    case Keyword::kInputFileName:
      return true;
    default:
      return false;
  }
}

std::string Interpreter::parse_string() {
  const Token& token = peek();
  if (token.kind == Token::Kind::kString) {
    const Literal& literal = program_->literals[token.index];
    if (literal.bad_escape) {
      fail("a string has an unknown escape in it", "write \\\\ for a backslash");
    }
    next();
    return literal.text;
  }
  if (!at_string()) fail_expected("a string");
  if (const Value* value = operand()) {
    std::string text = *get_if<const std::string>(*value);
    next();
    return text;
  }
  return string_function(static_cast<Keyword>(peek().index));
}

std::string Interpreter::parse_file_name() {
  const Token& token = peek();
  file_name_at_ = token.position;
  if (token.kind != Token::Kind::kString) return parse_string();
  std::string name = program_->literals[token.index].written;
  next();
  for (std::size_t at = 0; (at = name.find("\\\\", at)) != std::string::npos; ++at) {
    name.erase(at, 1);
  }
  return name;
}

std::string Interpreter::string_function(Keyword k) {
  const Nesting guard(*this);
  next();
  if (k == Keyword::kInputFileName) return programs_.front()->name;
  expect('(', "after the name of the function");
  std::string text;
  switch (k) {
    case Keyword::kStr: {
      const double value = float_argument();
      expect(',', "between the arguments");
      const double length = float_argument();
      expect(',', "between the arguments");
      text = formatted(value, length, float_argument());
      break;
    }
    case Keyword::kVstr:
      text = vector_string();
      break;
    case Keyword::kConcat:
      text = concatenation();
      break;
    case Keyword::kChr:
      text = character();
      break;
    case Keyword::kSubstr:
      text = substring();
      break;
    case Keyword::kDatetime:
      text = date_and_time();
      break;
    default:
      text = parse_string();
      for (char& c : text) {
        if (k == Keyword::kStrupr && c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
        if (k == Keyword::kStrlwr && c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
      }
  }
  expect(')', "after the arguments");
  return text;
}

std::string Interpreter::concatenation() {
  std::string text = parse_string();
  while (accept(',')) {
    const std::string more = parse_string();
    check_string(text.size() + more.size());
    text += more;
  }
  return text;
}

/// As C's printf: at least |length| characters, filled up with zeros if it is negative; `precision`
/// decimals, 6 if it is negative.
std::string Interpreter::formatted(double value, double length, double precision) {
  if (!(std::fabs(length) <= kWidestNumber && std::fabs(precision) <= kWidestNumber)) {
    fail("a number cannot be written with more than " +
         std::to_string(static_cast<int>(kWidestNumber)) + " characters");
  }
  const int width = static_cast<int>(std::fabs(length));
  const int decimals = precision < 0 ? 6 : static_cast<int>(precision);
  char text[2500];
  const int size = length < 0 ? std::snprintf(text, sizeof text, "%0*.*f", width, decimals, value)
                              : std::snprintf(text, sizeof text, "%*.*f", width, decimals, value);
  return std::string(text, static_cast<std::size_t>(size));
}

std::string Interpreter::vector_string() {
  const double wanted = float_argument();
  expect(',', "between the arguments");
  const int count = !(wanted > 2) ? 2 : wanted >= 5 ? 5 : static_cast<int>(wanted);
  Numeric n = full();
  if (n.size > count && !n.color) {
    fail("the vector has " + std::to_string(n.size) + " components, more than the " +
         std::to_string(count) + " to be written");
  }
  // A number is the first component here, not all of them (measured).
  if (n.size > 1) n = promoted(n, 5);
  expect(',', "between the arguments");
  const std::string separator = parse_string();
  expect(',', "between the arguments");
  const double length = float_argument();
  expect(',', "between the arguments");
  const double precision = float_argument();
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += separator;
    text += formatted(n.v[static_cast<std::size_t>(i)], length, precision);
    check_string(text.size());
  }
  return text;
}

std::string Interpreter::substring() {
  const std::string text = parse_string();
  expect(',', "between the arguments");
  const double first = std::trunc(float_argument());
  expect(',', "between the arguments");
  const double count = std::trunc(float_argument());
  if (!(first >= 1 && count >= 0 && first - 1 + count <= static_cast<double>(text.size()))) {
    fail("substr reaches outside the string, which has " + std::to_string(text.size()) +
             " characters",
         "the first character has the number 1");
  }
  return text.substr(static_cast<std::size_t>(first) - 1, static_cast<std::size_t>(count));
}

std::string Interpreter::character() {
  const double code = std::trunc(float_argument());
  if (!(code >= 0 && code <= 0xFFFF)) fail("chr needs a number from 0 to 65535");
  const auto c = static_cast<unsigned>(code);
  if (c < 0x80) return std::string(1, static_cast<char>(c));
  std::string text;
  if (c >= 0x800) text += static_cast<char>(0xE0 | c >> 12);
  text += static_cast<char>(c >= 0x800 ? 0x80 | (c >> 6 & 0x3F) : 0xC0 | c >> 6);
  text += static_cast<char>(0x80 | (c & 0x3F));
  return text;
}

/// Days since 2000 as a date and time of Greenwich.
std::string Interpreter::date_and_time() {
  const double days = float_argument();
  const std::string format = accept(',') ? parse_string() : "%Y-%m-%d %H:%M:%SZ";
  constexpr double kEpoch2000 = 946684800, kSecondsPerDay = 86400, kMostDays = 3e6;
  if (!(std::fabs(days) < kMostDays)) fail("datetime needs days within some thousand years");
  const auto seconds =
      static_cast<std::time_t>(std::floor(kEpoch2000 + days * kSecondsPerDay + 0.5));
  std::tm time{};
  gmtime_r(&seconds, &time);
  char text[512];
  return std::string(text, std::strftime(text, sizeof text, format.c_str(), &time));
}

double Interpreter::strings_compared() {
  const std::string a = parse_string();
  expect(',', "between the arguments");
  const int order = a.compare(parse_string());
  return order < 0 ? -1 : order > 0;
}

/// `STRING = STRING` and the like, as in a condition.
bool Interpreter::string_relation(double& result) {
  if (!at_string()) return false;
  const std::string a = parse_string();
  const Token op = next();
  if (op.kind != Token::Kind::kPunctuation)
    fail_at(op.position, "expected a comparison of strings");
  const int order = a.compare(parse_string());
  switch (op.punctuation) {
    case '<':
      result = order < 0;
      break;
    case '>':
      result = order > 0;
      break;
    case 'l':
      result = order <= 0;
      break;
    case 'g':
      result = order >= 0;
      break;
    case '=':
      result = order == 0;
      break;
    case 'n':
      result = order != 0;
      break;
    default:
      fail_at(op.position, "expected a comparison of strings, found " + found(op));
  }
  return true;
}

}  // namespace dioptre::pov
