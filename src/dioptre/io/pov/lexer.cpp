// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/lexer.h"

#include <charconv>
#include <cmath>
#include <cstring>

namespace dioptre::pov {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool begins_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool continues_name(char c) { return begins_name(c) || is_digit(c); }

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

class Lexer {
 public:
  Lexer(Program& program, std::uint32_t file, Symbols& symbols)
      : program_(program), text_(program.text), file_(file), symbols_(symbols) {}

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
  char look(std::size_t ahead = 0) const {
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
      if (c == '\n' || c == '\r') {
        at_ += c == '\r' && look(1) == '\n' ? 2 : 1;
        new_line();
      } else if (c == ' ' || c == '\t' || c == '\f' || c == '\v' || c == '\x1a') {
        ++at_;
      } else if (c == '/' && look(1) == '/') {
        while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
      } else if (c == '/' && look(1) == '*') {
        skip_comment();
      } else {
        return true;
      }
    }
    return false;
  }
  void skip_comment() {
    const SourcePosition begin = position();
    int depth = 0;
    while (at_ < text_.size()) {
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
    for (; counted_ < at_; ++counted_) {
      if ((static_cast<unsigned char>(text_[counted_]) & 0xC0) != 0x80) ++column_;
    }
    return {file_, static_cast<std::uint32_t>(program_.lines.size()), column_};
  }
  Token& add(Token::Kind kind) {
    Token token;
    token.kind = kind;
    token.position = in_comment_ ? comment_ : position();
    return program_.tokens.emplace_back(token);
  }
  void token() {
    const char c = look();
    if (is_digit(c) || (c == '.' && is_digit(look(1)))) {
      number();
    } else if (begins_name(c)) {
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
    while (continues_name(look())) ++at_;
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
    if (look() == 'e' || look() == 'E') {
      const std::size_t sign = look(1) == '+' || look(1) == '-' ? 2 : 1;
      if (is_digit(look(sign))) {
        at_ += sign;
        while (is_digit(look())) ++at_;
      }
    }
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
    } else if (c == '\0' || !std::strchr("(){}[]<>,;:=+-*/?!&|.", c)) {
      token.punctuation = kStrayCharacter;
      token.index = static_cast<unsigned char>(c);
    }
  }

  Program& program_;
  const std::string& text_;
  const std::uint32_t file_;
  Symbols& symbols_;
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
