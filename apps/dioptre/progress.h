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
  /// `kind`: auto, plain, json or none. The line is about all `frames` of an animation together.
  explicit ProgressLine(const std::string& kind, std::int64_t frames = 1);
  /// Time counts from here instead of from the making of the line; only the first call counts.
  void start();
  /// `done` is the share from 0 to 1 of this frame, and `rays` are its rays so far. Cheap; most
  /// calls print nothing.
  void update(double done, std::uint64_t rays);
  /// Takes the line away from a terminal.
  void clear() const;
  /// Ends a frame and, with the last one, the line. Says then what it took: the rays of each kind
  /// and, of a single picture, the share of the time that went into finding what they meet.
  void finish(const RenderResult& result);

 private:
  enum class Kind { kTerminal, kPlain, kJson, kNone };
  double seconds() const;
  /// `form` with the number of the frame and how many there are; empty for a single picture.
  std::string frame_text(const char* form) const;
  void print(double done, std::uint64_t rays);
  void print_json(double done, std::uint64_t rays, const std::string& more = "") const;

  Kind kind_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool started_ = false;
  double last_ = 0;
  std::int64_t frames_ = 1, finished_ = 0;
  RayCounts rays_;  ///< of the finished frames
};

}  // namespace dioptre::app
