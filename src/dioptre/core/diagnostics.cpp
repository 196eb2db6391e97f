// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/diagnostics.h"

#include <algorithm>

namespace dioptre {
namespace {

constexpr std::size_t kWidest = 160;

const char* name(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      return "error";
  }
  return "error";
}

/// The source line as it is shown, and where in it the caret goes (in characters, from 0).
struct Excerpt {
  std::string text;
  std::size_t caret;
};

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

Excerpt excerpt(const std::string& line, std::size_t column) {
  std::vector<std::string> characters;
  for (const char c : line) {
    if (continues_character(c) && !characters.empty()) {
      characters.back() += c;
    } else {
      const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
      characters.emplace_back(1, control ? ' ' : c);
    }
  }
  const std::size_t caret = std::min(column > 0 ? column - 1 : 0, characters.size());
  std::size_t first = 0, last = characters.size();
  if (characters.size() > kWidest) {
    first = caret > kWidest / 2 ? caret - kWidest / 2 : 0;
    last = std::min(first + kWidest, characters.size());
  }
  Excerpt shown{{}, caret - first};
  for (std::size_t i = first; i < last; ++i) shown.text += characters[i];
  return shown;
}

}  // namespace

std::string to_text(const Diagnostic& d) {
  std::string text;
  if (!d.file.empty()) {
    text += d.file + ':';
    if (d.line > 0) text += std::to_string(d.line) + ':';
    if (d.line > 0 && d.column > 0) text += std::to_string(d.column) + ':';
    text += ' ';
  }
  text += std::string(name(d.severity)) + ": " + d.message + '\n';
  if (d.line > 0 && !d.source_line.empty()) {
    const std::string number = std::to_string(d.line);
    const std::string margin(std::max<std::size_t>(number.size(), 3), ' ');
    const Excerpt shown = excerpt(d.source_line, d.column);
    text +=
        ' ' + std::string(margin.size() - number.size(), ' ') + number + " | " + shown.text + '\n';
    if (d.column > 0) text += ' ' + margin + " | " + std::string(shown.caret, ' ') + "^\n";
  }
  for (const std::string& note : d.notes) text += "     = note: " + note + '\n';
  return text;
}

void Diagnostics::report(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::kError) ++errors_;
  if (sink_) sink_(diagnostic);
  all_.push_back(std::move(diagnostic));
}

}  // namespace dioptre
