// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "dioptre/io/load_scene.h"
#include "settings.h"

namespace dioptre::app {

/// What the program says to its caller.
enum ExitCode : int { kSuccess = 0, kFailure = 1, kStopped = 2, kUsage = 64 };

/// Reads the scene of one frame: POV-Ray's language, or a `.json` dump. Messages go to the standard
/// error; nothing if there is no scene. `cancel` ends the reading when it becomes true.
std::optional<LoadedScene> load(const AppSettings& settings, std::int64_t frame,
                                const std::atomic<bool>* cancel = nullptr);

/// Renders all frames that the settings ask for.
int render_command(const AppSettings& settings);
/// Prints the scene as JSON, to the output file or the standard output.
int dump_command(const AppSettings& settings);
/// Renders a scene with each accelerator and reports what each one does.
int compare_command(const AppSettings& settings);
/// Tells how the value of one pixel came about.
int explain_command(const AppSettings& settings);
/// Prints how much there is in a scene.
int info_command(const AppSettings& settings);

/// Prints a message to the standard error.
void print_message(const Diagnostic& message);

/// Prints "dioptre: error: ..." to the standard error and returns kFailure.
int report_error(const std::string& message);

}  // namespace dioptre::app
