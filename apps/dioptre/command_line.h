// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "settings.h"

namespace dioptre::app {

/// Why a command line is refused.
struct UsageError {
  std::string message;
  bool own_option = false;  ///< it is one of the `--` options that was misused
};

/// Reads arguments from left to right, the last one wins: POV-Ray's switches (+W640, -D), INI names
/// (Width=640), INI files (`file.ini`, `file.ini[section]`), the scene, and our own options
/// (--size 640x480). `-o FILE` and `-i FILE` may stand apart from their value.
tl::expected<void, UsageError> read_arguments(AppSettings& settings,
                                              const std::vector<std::string>& arguments);

/// Applies one of POV-Ray's switches, sign included.
Result<void> apply_switch(AppSettings& settings, const std::string& argument);

/// The text of --help about our own options.
std::string own_options_help();

}  // namespace dioptre::app
