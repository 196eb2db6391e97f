// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace dioptre::pov {
namespace {

/// What a character can be.
enum : std::uint8_t { kDigit = 1, kLetter = 2, kBlank = 4, kMark = 8, kCommentPart = 16 };

constexpr auto kClasses = [] {
  std::array<std::uint8_t, 256> classes{};
  const auto mark = [&](std::string_view all, std::uint8_t as) {
    for (const char c : all) classes[static_cast<unsigned char>(c)] |= as;
  };
  mark("0123456789", kDigit);
  mark("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", kLetter);
  mark(" \t\f\v\x1a", kBlank);
  mark("(){}[]<>,;:=+-*/?!&|.", kMark);
  mark("/*\n\r", kCommentPart);
  return classes;
}();

bool is(char c, std::uint8_t of) { return kClasses[static_cast<unsigned char>(c)] & of; }
bool is_digit(char c) { return is(c, kDigit); }

/// A decimal number of few digits, which one division of exact numbers gives (Clinger 1990, "How to
/// read floating point numbers accurately"); false if that does not do. `digits` has at most one
/// point and nothing else.
bool read_short(std::string_view digits, double& value) {
  static constexpr double kPowers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                       1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  if (digits.size() > 16) return false;
  std::uint64_t whole = 0;
  std::size_t behind = 0;  // the point, counted from it on
  for (const char c : digits) {
    if (c == '.') {
      behind = 1;
      continue;
    }
    whole = 10 * whole + static_cast<std::uint64_t>(c - '0');
    if (behind > 0) ++behind;
  }
  if (whole >= std::uint64_t{1} << 53) return false;
  value = static_cast<double>(whole) / kPowers[behind > 0 ? behind - 1 : 0];
  return true;
}

void append_utf8(std::string& text, unsigned code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
    text += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    text += static_cast<char>(0xE0 | code >> 12);
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    text += static_cast<char>(0x80 | (code & 0x3F));
  }
}

/// Replaces the escapes of a literal.
Literal cook(std::string_view written) {
  Literal literal;
  literal.written = written;
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i] != '\\' || i + 1 >= written.size()) {
      literal.text += written[i];
      continue;
    }
    static constexpr char kNames[] = "abfnrtv0\\'\"";
    static constexpr char kBytes[] = "\a\b\f\n\r\t\v\0\\'\"";
    const char escape = written[++i];
    if (escape == 'u' && i + 4 < written.size()) {
      unsigned code = 0;
      const char* last = written.data() + i + 5;
      const auto read = std::from_chars(written.data() + i + 1, last, code, 16);
      literal.bad_escape = literal.bad_escape || read.ptr != last;
      append_utf8(literal.text, code);
      i += 4;
    } else if (const char* at = std::strchr(kNames, escape); at && escape != '\0') {
      literal.text += kBytes[at - kNames];
    } else {
      literal.bad_escape = true;
    }
  }
  return literal;
}

bool is_ascii(std::string_view text) {
  std::uint64_t all = 0;
  for (; text.size() >= sizeof all; text.remove_prefix(sizeof all)) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, text.data(), sizeof eight);
    all |= eight;
  }
  for (const char c : text) all |= static_cast<unsigned char>(c);
  return (all & 0x8080808080808080) == 0;
}

class Lexer {
 public:
  Lexer(Program& program, std::uint32_t file, Symbols& symbols)
      : program_(program), text_(program.text), file_(file), symbols_(symbols) {
    ascii_ = is_ascii(text_);
    program_.tokens.reserve(text_.size() / 6 + 16);
    program_.lines.reserve(text_.size() / 32 + 16);
  }

  void run(std::uint64_t most_tokens) {
    program_.lines.push_back(0);
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = counted_ = 3;
    if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")) {
      add(Token::Kind::kPunctuation).punctuation = kWideText;
      at_ = text_.size();
    }
    while (skip_blanks()) {
      if (program_.tokens.size() >= most_tokens) {
        add(Token::Kind::kPunctuation).punctuation = kTooManyTokens;
        break;
      }
      token();
    }
    if (in_comment_) add(Token::Kind::kPunctuation).punctuation = kUnterminatedComment;
    add(Token::Kind::kEnd);
  }

 private:
  char look() const { return text_[at_]; }  // the text ends with 0
  char look(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  void new_line() {
    program_.lines.push_back(static_cast<std::uint32_t>(at_));
    counted_ = at_;
    column_ = 1;
  }
  /// Skips white space and comments; false at the end of the text.
  bool skip_blanks() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (is(c, kBlank)) {
        ++at_;
      } else if (c == '\n' || c == '\r') {
        at_ += c == '\r' && look(1) == '\n' ? 2 : 1;
        new_line();
      } else if (c == '/' && look(1) == '/') {
        skip_line();
      } else if (c == '/' && look(1) == '*') {
        skip_comment();
      } else {
        return true;
      }
    }
    return false;
  }
  /// Goes to the end of the line.
  void skip_line() {
    const std::string_view rest = std::string_view(text_).substr(at_);
    const std::string_view line = rest.substr(0, rest.find('\n'));
    at_ += std::min(line.size(), line.find('\r'));
  }
  void skip_comment() {
    const SourcePosition begin = position();
    int depth = 0;
    while (true) {
      while (at_ < text_.size() && !is(text_[at_], kCommentPart)) ++at_;
      if (at_ >= text_.size()) break;
      if (look() == '/' && look(1) == '*') {
        ++depth;
        at_ += 2;
      } else if (look() == '*' && look(1) == '/') {
        at_ += 2;
        if (--depth == 0) return;
      } else if (look() == '\n' || look() == '\r') {
        at_ += look() == '\r' && look(1) == '\n' ? 2 : 1;
        new_line();
      } else {
        ++at_;
      }
    }
    in_comment_ = true;
    comment_ = begin;
  }
  /// The place of the next character; columns count characters, not bytes.
  SourcePosition position() {
    if (ascii_) {
      column_ += static_cast<std::uint32_t>(at_ - counted_);
      counted_ = at_;
    }
    for (; counted_ < at_; ++counted_) {
      if ((static_cast<unsigned char>(text_[counted_]) & 0xC0) != 0x80) ++column_;
    }
    return {file_, static_cast<std::uint32_t>(program_.lines.size()), column_};
  }
  Token& add(Token::Kind kind) {
    Token& token = program_.tokens.emplace_back();
    token.kind = kind;
    token.position = in_comment_ ? comment_ : position();
    return token;
  }
  void token() {
    const char c = look();
    if (is_digit(c) || (c == '.' && is_digit(look(1)))) {
      number();
    } else if (is(c, kLetter)) {
      Token& token = add(Token::Kind::kName);
      token.index = symbols_.intern(name());
    } else if (c == '"') {
      string();
    } else if (c == '#') {
      directive();
    } else {
      punctuation();
    }
  }
  std::string_view name() {
    const std::size_t begin = at_;
    while (is(look(), kLetter | kDigit)) ++at_;
    return std::string_view(text_).substr(begin, at_ - begin);
  }
  void number() {
    Token& token = add(Token::Kind::kNumber);
    const std::size_t begin = at_;
    while (is_digit(look())) ++at_;
    if (look() == '.') {
      ++at_;
      while (is_digit(look())) ++at_;
    }
    const std::string_view plain = std::string_view(text_).substr(begin, at_ - begin);
    if (look() == 'e' || look() == 'E') {
      const std::size_t sign = look(1) == '+' || look(1) == '-' ? 2 : 1;
      if (is_digit(look(sign))) {
        at_ += sign;
        while (is_digit(look())) ++at_;
      }
    }
    if (plain.size() == at_ - begin && read_short(plain, token.number)) return;
    const auto read = std::from_chars(text_.data() + begin, text_.data() + at_, token.number);
    if (read.ec == std::errc::result_out_of_range) {
      token.number = std::strtod(std::string(text_, begin, at_ - begin).c_str(), nullptr);
      if (std::isinf(token.number)) {
        token.kind = Token::Kind::kPunctuation;
        token.punctuation = kBadNumber;
      }
    }
  }
  void string() {
    Token& token = add(Token::Kind::kString);
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"') {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      if (text_[at_] == '\n') {
        ++at_;
        new_line();
      } else {
        ++at_;
      }
    }
    if (at_ >= text_.size()) {
      token.kind = Token::Kind::kPunctuation;
      token.punctuation = kUnterminatedString;
      return;
    }
    token.index = static_cast<std::uint32_t>(program_.literals.size());
    program_.literals.push_back(cook(std::string_view(text_).substr(begin, at_ - begin)));
    ++at_;
  }
  void directive() {
    Token& token = add(Token::Kind::kDirective);
    ++at_;
    while (look() == ' ' || look() == '\t') ++at_;
    token.index = symbols_.intern(name());
  }
  void punctuation() {
    Token& token = add(Token::Kind::kPunctuation);
    const char c = look(), d = look(1);
    ++at_;
    token.punctuation = c;
    if (d == '=' && (c == '<' || c == '>' || c == '!')) {
      token.punctuation = c == '<' ? 'l' : c == '>' ? 'g' : 'n';
      ++at_;
    } else if (!is(c, kMark)) {
      token.punctuation = kStrayCharacter;
      token.index = static_cast<unsigned char>(c);
    }
  }

  Program& program_;
  const std::string& text_;
  const std::uint32_t file_;
  Symbols& symbols_;
  bool ascii_;
  std::size_t at_ = 0;
  std::size_t counted_ = 0;  ///< columns are counted up to here
  std::uint32_t column_ = 1;
  bool in_comment_ = false;
  SourcePosition comment_;
};

bool opens_block(Keyword k) {
  switch (k) {
    case Keyword::kIf:
    case Keyword::kIfdef:
    case Keyword::kIfndef:
    case Keyword::kSwitch:
    case Keyword::kWhile:
    case Keyword::kFor:
    case Keyword::kMacro:
      return true;
    default:
      return false;
  }
}
bool begins_branch(Keyword k) {
  return k == Keyword::kElse || k == Keyword::kElseif || k == Keyword::kCase ||
         k == Keyword::kRange;
}

/// Fills `branch` and `end`: each opening directive is chained to its branches and its #end.
void match_blocks(Program& program) {
  program.branch.assign(program.tokens.size(), Program::kNowhere);
  program.end.assign(program.tokens.size(), Program::kNowhere);
  std::vector<std::vector<std::uint32_t>> open;
  for (std::uint32_t i = 0; i < program.tokens.size(); ++i) {
    if (program.tokens[i].kind != Token::Kind::kDirective) continue;
    const Keyword k = program.tokens[i].index < kKeywordCount
                          ? static_cast<Keyword>(program.tokens[i].index)
                          : Keyword::kNotAKeyword;
    if (opens_block(k)) {
      open.push_back({i});
    } else if (begins_branch(k) && !open.empty()) {
      program.branch[open.back().back()] = i;
      open.back().push_back(i);
    } else if (k == Keyword::kEnd && !open.empty()) {
      program.branch[open.back().back()] = i;
      for (const std::uint32_t part : open.back()) program.end[part] = i;
      open.pop_back();
    }
  }
}

}  // namespace

std::string_view Program::line(std::uint32_t number) const {
  if (number == 0 || number > lines.size()) return {};
  const std::string_view rest = std::string_view(text).substr(lines[number - 1]);
  std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
  if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  return line;
}

Program lex(std::string name, std::string text, std::uint32_t file, Symbols& symbols,
            std::uint64_t most_tokens) {
  Program program;
  program.name = std::move(name);
  program.text = std::move(text);
  Lexer(program, file, symbols).run(most_tokens);
  match_blocks(program);
  return program;
}

}  // namespace dioptre::pov
