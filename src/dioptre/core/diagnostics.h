// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dioptre {

enum class Severity : std::uint8_t { kNote, kWarning, kError };

/// One message about the user's input, ready to print.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string file;                ///< empty: about no file
  std::uint32_t line = 0;          ///< from 1; 0: about the whole file
  std::uint32_t column = 0;        ///< from 1, in characters
  std::string message;             ///< one line, lower case, no full stop
  std::string source_line;         ///< the text of the line, without its end
  std::vector<std::string> notes;  ///< "in macro Foo called at scene.pov:3:1", how to mend it
};

/// The text shown to people:
///
///   ring.pov:12:9: error: torus needs two numbers, found '}'
///    12 |   torus { 1 }
///       |             ^
///       = note: write torus { MAJOR, MINOR }
///
/// Control characters of the source line are shown as spaces; a line of over 160 characters is cut
/// around the column. Ends with a newline.
std::string to_text(const Diagnostic& diagnostic);

/// Where readers report; keeps everything in order and may pass each message on at once.
class Diagnostics {
 public:
  Diagnostics() = default;
  explicit Diagnostics(std::function<void(const Diagnostic&)> sink) : sink_(std::move(sink)) {}

  void report(Diagnostic diagnostic);
  bool has_errors() const { return errors_ > 0; }
  const std::vector<Diagnostic>& all() const { return all_; }

 private:
  std::function<void(const Diagnostic&)> sink_;
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
};

}  // namespace dioptre
