// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "command_line.h"
#include "commands.h"
#include "ini_file.h"

namespace dioptre::app {
namespace {

/// What the program can be told to do.
struct Command {
  const char* name;
  int (*run)(const AppSettings&);
  const char* arguments;
  const char* help;
};
constexpr Command kCommands[] = {
    {"render", render_command, "SCENE", "render a POV-Ray 3.7 scene or a .json dump of one"},
    {"explain", explain_command, "SCENE --pixel X,Y", "tell how a pixel got its colour"},
    {"compare", compare_command, "SCENE", "compare the accelerators on a scene"},
    {"dump", dump_command, "SCENE [-o FILE]", "print the scene as JSON"},
    {"info", info_command, "SCENE", "print how much there is in a scene"},
};

void print_help() {
  std::puts("dioptre " DIOPTRE_VERSION ", a ray tracer for exact solids\n");
  for (const Command& each : kCommands) {
    const std::string name = &each == kCommands ? "[render]" : each.name;
    std::printf("  dioptre %-8s %-18s  %s\n", name.c_str(), each.arguments, each.help);
  }
  std::printf(
      "  dioptre --version | --help\n\n"
      "POV-Ray's switches (+W640 +H480 +A0.1 -D), INI names (Width=640) and INI files\n"
      "(file.ini, file.ini[section]) stand anywhere; the last one wins. Beside them:\n\n%s\n"
      "Exit codes: 0 done, 1 error in scene, option or file, 2 stopped by the user,\n"
      "64 misuse of a -- option.\n",
      own_options_help().c_str());
}

int run(std::vector<std::string> arguments) {
  const Command* command = kCommands;
  for (const std::string& argument : arguments) {
    if (argument == "--version") return std::puts("dioptre " DIOPTRE_VERSION), kSuccess;
    if (argument == "--help") return print_help(), kSuccess;
  }
  if (!arguments.empty()) {
    const std::string first = arguments.front();
    const bool alone = arguments.size() == 1;
    if (alone && (first == "-h" || first == "-?" || first == "+h")) return print_help(), kSuccess;
    for (const Command& each : kCommands) {
      if (first == each.name) command = &each;
    }
    if (first == command->name) arguments.erase(arguments.begin());
  }
  AppSettings settings;
  if (const auto read = read_default_ini(settings); !read) {
    return report_error(read.error().message);
  }
  if (const auto read = read_arguments(settings, arguments); !read) {
    report_error(read.error().message);
    return read.error().own_option ? kUsage : kFailure;
  }
  for (const std::string& name : settings.without_effect) {
    if (!settings.warnings) break;
    std::fprintf(stderr, "dioptre: warning: %s has no effect\n", name.c_str());
  }
  if (settings.input.empty()) return report_error("no scene is named; see dioptre --help");
  return command->run(settings);
}

}  // namespace
}  // namespace dioptre::app

int main(int argc, char** argv) {
  try {
    return dioptre::app::run({argv + 1, argv + argc});
  } catch (const std::bad_alloc&) {
    return dioptre::app::report_error("there is not enough memory for this picture");
  } catch (const std::exception& error) {
    return dioptre::app::report_error(error.what());
  }
}
