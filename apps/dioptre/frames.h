// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "settings.h"

namespace dioptre::app {

/// Whether the settings ask for an animation: a final frame of 0 says that they do not (measured).
bool is_animation(const AppSettings& settings);

/// The last frame of the animation: one that would be before the initial frame is that (measured).
std::int32_t final_frame(const AppSettings& settings);

/// The change of the clock from frame to frame; 0 without an animation.
double clock_delta(const AppSettings& settings);

/// The frames of the subset to render: from `first` by `step` to `last`, ends included. There is at
/// least one, and the subset may go on after the final frame (measured).
struct FrameRange {
  std::int64_t first = 0, last = 0, step = 1;
};
FrameRange frame_range(const AppSettings& settings);

/// The clock of a frame: from the initial to the final clock, evenly; a cyclic animation stops one
/// step before the final clock.
double frame_clock(const AppSettings& settings, std::int64_t number);

/// Where the picture goes: the output name, or the scene's name in the working folder; with the
/// extension of its type, and the frame's number, as wide as the last one's, before that. The name
/// of a device or pipe stays as it is.
std::string output_path(const AppSettings& settings, std::int64_t frame);

}  // namespace dioptre::app
