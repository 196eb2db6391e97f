// SPDX-License-Identifier: Apache-2.0
#include "frames.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace dioptre::app {
namespace {

const char* extension(char file_type) {
  switch (file_type) {
    case 'B':
      return ".bmp";
    case 'E':
      return ".exr";
    case 'H':
      return ".hdr";
    case 'J':
      return ".jpg";
    case 'P':
      return ".ppm";
    case 'C':
    case 'S':
    case 'T':
      return ".tga";
    default:
      return ".png";
  }
}

/// Whether the path is of something written in place: a device or a pipe.
bool is_device(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto type = std::filesystem::status(path, ignored).type();
  using Type = std::filesystem::file_type;
  return type == Type::character || type == Type::block || type == Type::fifo ||
         type == Type::socket;
}

/// A bound of the subset; if under 1 a share of how many frames there are, wherever they begin
/// (measured).
std::int64_t subset_frame(const AppSettings& s, double bound) {
  const double frames = static_cast<double>(final_frame(s)) - s.initial_frame + 1;
  const double frame = std::floor(bound < 1 ? bound * frames : bound);
  return static_cast<std::int64_t>(std::max<double>(frame, s.initial_frame));
}

}  // namespace

bool is_animation(const AppSettings& s) {
  return s.final_frame > 0 || (s.final_frame < 0 && s.initial_frame > 1);
}

std::int32_t final_frame(const AppSettings& s) { return std::max(s.final_frame, s.initial_frame); }

double clock_delta(const AppSettings& settings) {
  const double steps = static_cast<double>(final_frame(settings)) - settings.initial_frame +
                       (settings.cyclic ? 1 : 0);
  if (!is_animation(settings) || steps <= 0) return 0;
  return (settings.final_clock - settings.initial_clock) / steps;
}

FrameRange frame_range(const AppSettings& s) {
  if (!is_animation(s)) return {0, 0, 1};
  const std::int64_t first = subset_frame(s, s.subset_start);
  const std::int64_t last = s.subset_end ? subset_frame(s, *s.subset_end) : final_frame(s);
  return {first, std::max(first, last), s.frame_step};
}

double frame_clock(const AppSettings& settings, std::int64_t number) {
  if (!is_animation(settings)) return settings.clock;
  return settings.initial_clock +
         clock_delta(settings) * static_cast<double>(number - settings.initial_frame);
}

std::string output_path(const AppSettings& settings, std::int64_t frame) {
  namespace fs = std::filesystem;
  if (settings.output == "-") return "-";
  const fs::path scene = settings.input == "-" ? fs::path("stdin") : fs::path(settings.input);
  fs::path path = settings.output;
  std::error_code ignored;
  if (is_device(path)) return path.string();
  if (path.empty() || !path.has_filename() || fs::is_directory(path, ignored)) {
    path /= scene.stem();
    path += extension(settings.file_type);
  } else if (path.extension().empty()) {
    path += extension(settings.file_type);
  }
  if (!is_animation(settings)) return path.string();
  std::string number = std::to_string(frame);
  const std::size_t digits = std::to_string(final_frame(settings)).size();
  if (number.size() < digits) number.insert(0, digits - number.size(), '0');
  const std::string end = path.extension().string();
  path.replace_extension();
  return path.string() + number + end;
}

}  // namespace dioptre::app
