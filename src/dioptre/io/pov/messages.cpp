// SPDX-License-Identifier: Apache-2.0
// How the interpreter says what is wrong.
#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

constexpr std::size_t kMostCallers = 5;

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
  d.source_line = program.line(where.line);
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
  fail_at(token.position, "expected " + std::string(what) + ", found " + found(token),
          unknown ? "nothing of that name has been declared" : "");
}

void Interpreter::expect(char c, std::string_view why) {
  if (accept(c)) return;
  std::string what = std::string("'") + c + "'";
  if (!why.empty()) what += " " + std::string(why);
  fail_expected(what);
}

void Interpreter::warn(std::string message, std::string how_to_mend) {
  const SourcePosition where = ready_ ? current_->position : cursor_->position;
  Diagnostic d = diagnostic(Severity::kWarning, where, std::move(message));
  if (!said_.insert(d.file + ':' + std::to_string(d.line) + d.message).second) return;
  if (!how_to_mend.empty()) d.notes.push_back(std::move(how_to_mend));
  diagnostics_.report(std::move(d));
}

void Interpreter::not_rendered(std::string_view feature) {
  const std::string message = std::string(feature) + " is not rendered yet: ignored";
  const SourcePosition where = peek().position;
  Diagnostic d = diagnostic(Severity::kWarning, where, message);
  if (said_.insert(d.file + ": " + message).second) diagnostics_.report(std::move(d));
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

void Interpreter::over_budget(std::string what, std::string_view option) {
  const SourcePosition where = ready_ ? current_->position : cursor_->position;
  fail_at(where, "more than " + what, "raise the limit with --" + std::string(option));
}

}  // namespace dioptre::pov
