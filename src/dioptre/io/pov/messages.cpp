// SPDX-License-Identifier: Apache-2.0
// How the interpreter says what is wrong.
#include "dioptre/io/pov/interpreter.h"
#include "dioptre/io/spelling.h"

namespace dioptre::pov {
namespace {

constexpr std::size_t kMostCallers = 5;
constexpr std::size_t kLongestLine = 1 << 16;  ///< a longer one, made by a program, is not shown

std::string at_place(const std::string& file, SourcePosition at) {
  return file + ':' + std::to_string(at.line) + ':' + std::to_string(at.column);
}

}  // namespace

Diagnostic Interpreter::diagnostic(Severity severity, SourcePosition where,
                                   std::string message) const {
  Diagnostic d;
  d.severity = severity;
  d.message = std::move(message);
  if (where.file >= programs_.size()) return d;
  const Program& program = *programs_[where.file];
  d.file = program.name;
  d.line = where.line;
  d.column = where.column;
  const std::string_view line = program.line(where.line);
  if (line.size() <= kLongestLine) d.source_line = line;
  std::size_t said = 0;
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
    if (++said > kMostCallers) {
      d.notes.push_back("... and " + std::to_string(frames_.size() - kMostCallers) +
                        " more levels");
      break;
    }
    const std::string place = at_place(programs_[frame->called.file]->name, frame->called);
    if (frame->macro) {
      d.notes.push_back("in macro " + symbols_.name(frame->macro->name) + " called at " + place);
    } else {
      d.notes.push_back("included from " + place);
    }
  }
  return d;
}

void Interpreter::fail_at(SourcePosition where, std::string message, std::string how_to_mend) {
  Failure failure{diagnostic(Severity::kError, where, std::move(message))};
  if (!how_to_mend.empty()) failure.diagnostic.notes.push_back(std::move(how_to_mend));
  throw failure;
}

void Interpreter::fail(std::string message, std::string how_to_mend) {
  const SourcePosition where = ready_ ? current_->position : cursor_->position;
  fail_at(where, std::move(message), std::move(how_to_mend));
}

void Interpreter::fail_expected(std::string_view what) {
  const Token token = peek();
  const bool unknown = token.kind == Token::Kind::kName && token.index >= kKeywordCount &&
                       !scopes_.find(token.index);
  std::string note;
  if (unknown) note = unknown_name(token.index);
  if (token.kind == Token::Kind::kEnd) note = open_brackets();
  fail_at(token.position, "expected " + std::string(what) + ", found " + found(token),
          std::move(note));
}

void Interpreter::fail_undeclared(SourcePosition where, Symbol name) {
  fail_at(where, "'" + symbols_.name(name) + "' is not declared", meant(name, "did you mean '"));
}

std::string Interpreter::unknown_name(Symbol name) const {
  return "nothing of that name has been declared" + meant(name, "; did you mean '");
}

/// Asks whether the declared name, or the reserved word, that is most like this one was meant.
/// Reserved words begin with a small letter, so that a name with a capital is none of them.
std::string Interpreter::meant(Symbol name, std::string_view question) const {
  const std::string& written = symbols_.name(name);
  const bool capital = !written.empty() && written[0] >= 'A' && written[0] <= 'Z';
  std::size_t best = written.size();
  const std::string* found = nullptr;
  for (Symbol known = 0; known < symbols_.size(); ++known) {
    if (known < kKeywordCount ? capital : !scopes_.find(known)) continue;
    if (known == name || !is_misspelling(written, symbols_.name(known))) continue;
    const std::size_t distance = edit_distance(written, symbols_.name(known));
    if (distance >= best) continue;
    best = distance;
    found = &symbols_.name(known);
  }
  return found ? std::string(question) + *found + "'?" : std::string();
}

/// At the end of the file: which bracket still waits for its end.
std::string Interpreter::open_brackets() const {
  if (open_.empty()) return {};
  const Bracket& last = open_.back();
  return std::string("the '") + last.character + "' at " +
         at_place(programs_[last.position.file]->name, last.position) + " has no '" +
         (last.character == '{' ? '}' : ')') + "'";
}

void Interpreter::expect(char c, std::string_view why) {
  if (accept(c)) return;
  std::string what{'\'', c, '\''};
  if (!why.empty()) (what += ' ') += why;
  fail_expected(what);
}

void Interpreter::warn(std::string message, std::string how_to_mend) {
  warn_at(ready_ ? current_->position : cursor_->position, std::move(message),
          std::move(how_to_mend));
}

void Interpreter::warn_at(SourcePosition where, std::string message, std::string how_to_mend) {
  if (!is_new(message, where.file, where.line)) return;
  Diagnostic d = diagnostic(Severity::kWarning, where, std::move(message));
  if (!how_to_mend.empty()) d.notes.push_back(std::move(how_to_mend));
  diagnostics_.report(std::move(d));
}

void Interpreter::forgive(SourcePosition where, std::string message, std::string how_to_mend) {
  if (options_.strict) fail_at(where, std::move(message), std::move(how_to_mend));
  warn_at(where, std::move(message), std::move(how_to_mend));
}

void Interpreter::not_rendered(std::string_view feature) {
  warn_once(peek().position, std::string(feature) + " is not rendered yet: ignored");
}

void Interpreter::warn_once(SourcePosition where, const std::string& message) {
  if (!is_new(message, where.file, 0)) return;
  diagnostics_.report(diagnostic(Severity::kWarning, where, message));
}

bool Interpreter::is_new(const std::string& message, std::uint32_t file, std::uint32_t line) {
  std::string key = std::to_string(file) + ':' + std::to_string(line) + ':' + message;
  return said_.insert(std::move(key)).second;
}

std::string Interpreter::found(const Token& token) const {
  switch (token.kind) {
    case Token::Kind::kEnd:
      return "the end of the file";
    case Token::Kind::kNumber:
      return "a number";
    case Token::Kind::kString:
      return "a string";
    case Token::Kind::kDirective:
      return "'#" + symbols_.name(token.index) + "'";
    case Token::Kind::kName:
      return "'" + symbols_.name(token.index) + "'";
    case Token::Kind::kPunctuation:
      break;
  }
  switch (token.punctuation) {
    case 'l':
      return "'<='";
    case 'g':
      return "'>='";
    case 'n':
      return "'!='";
    default:
      return std::string("'") + token.punctuation + "'";
  }
}

void Interpreter::fail_token(const Token& token) {
  switch (token.punctuation) {
    case kUnterminatedString:
      fail_at(token.position, "a string has no closing '\"'");
    case kUnterminatedComment:
      fail_at(token.position, "a comment has no closing '*/'");
    case kBadNumber:
      fail_at(token.position, "a number is too large");
    case kWideText:
      fail_at(token.position, "the file is in UTF-16", "save it as UTF-8");
    case kTooManyTokens:
      fail_at(token.position, "more words than the memory allowed for the scene can hold",
              "raise the limit with --max-scene-bytes");
    default:
      break;
  }
  if (token.index > ' ' && token.index < 0x7f) {
    fail_at(token.position, std::string("the character '") + static_cast<char>(token.index) +
                                "' has no meaning here");
  }
  fail_at(token.position,
          "the byte " + std::to_string(token.index) + " has no meaning outside a string");
}

}  // namespace dioptre::pov
