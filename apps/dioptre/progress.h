// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace dioptre::app {

/// Tells how far a render is, on the standard error: one line that is rewritten on a terminal,
/// plain lines every few seconds elsewhere, or a JSON object per line.
class ProgressLine {
 public:
  /// `kind`: auto, plain, json or none.
  explicit ProgressLine(const std::string& kind);
  /// `done` is a share from 0 to 1. Cheap; most calls print nothing.
  void update(double done, std::uint64_t rays);
  /// Ends the line and says what it took.
  void finish(std::uint64_t rays);

 private:
  enum class Kind { kTerminal, kPlain, kJson, kNone };
  double seconds() const;
  void print(double done, std::uint64_t rays);

  Kind kind_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double last_ = 0;
};

}  // namespace dioptre::app
