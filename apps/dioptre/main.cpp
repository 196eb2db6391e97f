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

void print_help() {
  std::printf(
      "dioptre " DIOPTRE_VERSION
      ", a ray tracer for exact solids\n\n"
      "  dioptre [render] SCENE [OPTION...]   render a POV-Ray 3.7 scene or a .json dump of one\n"
      "  dioptre dump SCENE [-o FILE]         print the scene as JSON\n"
      "  dioptre compare SCENE [OPTION...]    compare the accelerators on a scene\n"
      "  dioptre info SCENE                   print how much there is in a scene\n"
      "  dioptre --version | --help\n\n"
      "POV-Ray's switches (+W640 +H480 +A0.1 -D), INI names (Width=640) and INI files\n"
      "(file.ini, file.ini[section]) stand anywhere; the last one wins. Beside them:\n\n%s\n"
      "Exit codes: 0 done, 1 error in scene, option or file, 2 stopped by the user,\n"
      "64 misuse of a -- option.\n",
      own_options_help().c_str());
}

int run(std::vector<std::string> arguments) {
  using Command = int (*)(const AppSettings&);
  Command command = render_command;
  for (const std::string& argument : arguments) {
    if (argument == "--version") return std::puts("dioptre " DIOPTRE_VERSION), kSuccess;
    if (argument == "--help") return print_help(), kSuccess;
  }
  if (!arguments.empty()) {
    const std::string first = arguments.front();
    const bool alone = arguments.size() == 1;
    if (alone && (first == "-h" || first == "-?" || first == "+h")) return print_help(), kSuccess;
    const bool named = first == "render" || first == "compare" || first == "dump" || first == "info";
    if (first == "compare") command = compare_command;
    if (first == "dump") command = dump_command;
    if (first == "info") command = info_command;
    if (named) arguments.erase(arguments.begin());
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
  return command(settings);
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
