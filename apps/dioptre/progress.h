// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "dioptre/integrators/render_image.h"

namespace dioptre::app {

/// Tells how far a render is, on the standard error: one line that is rewritten on a terminal,
/// plain lines every few seconds elsewhere, or a JSON object per line.
class ProgressLine {
 public:
  /// `kind`: auto, plain, json or none.
  explicit ProgressLine(const std::string& kind);
  /// `done` is a share from 0 to 1. Cheap; most calls print nothing.
  void update(double done, std::uint64_t rays);
  /// Takes the line away from a terminal.
  void clear() const;
  /// Ends the line and says what it took: the rays of each kind, and the share of the time that
  /// went into finding what they meet.
  void finish(const RenderResult& result);

 private:
  enum class Kind { kTerminal, kPlain, kJson, kNone };
  double seconds() const;
  void print(double done, std::uint64_t rays);
  void print_json(double done, std::uint64_t rays, const std::string& more = "") const;

  Kind kind_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double last_ = 0;
};

}  // namespace dioptre::app
