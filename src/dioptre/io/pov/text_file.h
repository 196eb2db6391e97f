// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>

namespace dioptre::pov {

/// A file opened by #fopen.
struct TextFile {
  enum class Mode { kRead, kWrite };
  Mode mode = Mode::kRead;
  std::string path;
  std::string text;    ///< reading: all of it
  std::size_t at = 0;  ///< reading: the next character
  std::ofstream out;   ///< writing
  bool at_end = false;
};

}  // namespace dioptre::pov
