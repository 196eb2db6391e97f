// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include <algorithm>

#include "ini_file.h"

namespace dioptre::app {
namespace {

/// Our own options; each stands for one INI name.
struct OwnOption {
  const char* name;
  const char* value;  ///< what it takes, for the help; null: nothing
  const char* key;    ///< null: handled by hand
  const char* help;
};
constexpr OwnOption kOwnOptions[] = {
    {"--output", "FILE", "Output_File_Name", "the image; - is the standard output (also -o FILE)"},
    {"--size", "WxH", nullptr, "width and height in pixels"},
    {"--threads", "N", "Work_Threads", "0: as many as there are cores"},
    {"--quality", "N", "Quality", "0 to 11, as POV-Ray's +Q"},
    {"--aa", "THRESHOLD", "Antialias_Threshold", "smooth edges; 0 to 3, 0.3 is usual"},
    {"--region", "X0,Y0,X1,Y1", nullptr, "the part to render, pixels from 1, ends included"},
    {"--accelerator", "NAME", "Accelerator", "how rays find objects"},
    {"--accel", "NAME", "Accelerator", "the same"},
    {"--integrator", "NAME", "Integrator", "how light is computed"},
    {"--polygon-test", "NAME", "Polygon_Test", "of points in polygons: crossings or angles"},
    {"--penumbra", "SHAPE", "Penumbra", "of area lights: grid, rectangle, disc or sphere"},
    {"--light-samples", "N", "Light_Samples", "of an area light, but for the grid"},
    {"--shadows", nullptr, "Shadows", "cast shadows where the integrator leaves them out (appel)"},
    {"--attenuation", "K", "Attenuation", "of mirrored and refracted rays by length; or KR,KT"},
    {"--layers", "NAMES", "Layers", "terms, cost, all or single ones, in the .exr"},
    {"--terms", nullptr, "Terms", "write Whitted's five terms as PNGs beside the image"},
    {"--heatmap", "NAMES", "Heatmap", "write what pixels cost as a PNG: rays, steps, tests, ..."},
    {"--progress", "KIND", "Progress", "auto, plain, json or none"},
    {"--pixel", "X,Y", "Explain_Pixel", "to explain; columns and rows from 0, the top left"},
    {"--rays", "N", "Compared_Rays", "of each sort that compare measures, about"},
    {"--csv", "FILE", "Report_Csv", "what compare found, as a table; - is the standard output"},
    {"--html", "FILE", "Report_Html", "what compare or explain found, as a page"},
    {"--json", "FILE", "Report_Json", "the same as JSON"},
    {"--strict", nullptr, "Strict", "refuse what POV-Ray 3.7 refuses, where its meaning is plain"},
    {"--max-steps", "N", "Max_Steps", "of the scene's program"},
    {"--max-objects", "N", "Max_Objects", "that a scene may make"},
    {"--max-nesting", "N", "Max_Nesting", "of braces, macros and includes"},
    {"--max-string-bytes", "N", "Max_String_Bytes", "of one string of a scene"},
    {"--max-array-elements", "N", "Max_Array_Elements", "of one array of a scene"},
    {"--max-written-bytes", "N", "Max_Written_Bytes", "that a scene may write to files"},
    {"--max-scene-bytes", "N", "Max_Scene_Bytes", "of memory for reading a scene"},
    {"--max-read-seconds", "S", "Max_Read_Seconds", "for reading a scene; 0: no limit"},
    {"--max-pixels", "N", "Max_Pixels", "of the image"},
};

tl::unexpected<UsageError> misuse(std::string message) {
  return tl::unexpected<UsageError>(UsageError{std::move(message), true});
}

Result<void> set_size(AppSettings& settings, const std::string& value) {
  const std::size_t by = value.find_first_of("xX");
  if (by == std::string::npos) return fail("expected WIDTHxHEIGHT");
  if (auto set = set_option(settings, "Width", value.substr(0, by)); !set) return set;
  return set_option(settings, "Height", value.substr(by + 1));
}

Result<void> set_region(AppSettings& settings, std::string value) {
  const char* const keys[] = {"Start_Column", "Start_Row", "End_Column", "End_Row"};
  for (const char* key : keys) {
    const std::size_t comma = value.find(',');
    if (value.empty()) return fail("expected X0,Y0,X1,Y1");
    if (auto set = set_option(settings, key, value.substr(0, comma)); !set) return set;
    value = comma == std::string::npos ? "" : value.substr(comma + 1);
  }
  if (!value.empty()) return fail("expected X0,Y0,X1,Y1");
  return {};
}

Result<void> apply_own(AppSettings& settings, const std::string& name, const OwnOption& option,
                       const std::string& value) {
  if (name == "--size") return set_size(settings, value);
  if (name == "--region") return set_region(settings, value);
  if (name == "--aa") settings.antialias = true;
  return set_option(settings, option.key, value);
}

/// Reads the own option at `at`; moves `at` onto its value if that is an argument of its own.
tl::expected<void, UsageError> read_own(AppSettings& settings,
                                        const std::vector<std::string>& arguments,
                                        std::size_t& at) {
  const std::string& argument = arguments[at];
  const std::size_t equals = argument.find('=');
  const std::string name = argument.substr(0, equals);
  std::vector<std::string_view> names;
  for (const OwnOption& option : kOwnOptions) {
    names.emplace_back(option.name);
    if (name != option.name) continue;
    const bool apart = option.value && equals == std::string::npos;
    if (apart && at + 1 == arguments.size()) {
      return misuse(name + " needs a value: " + option.value);
    }
    std::string value = "on";
    if (apart) value = arguments[++at];
    if (equals != std::string::npos) value = argument.substr(equals + 1);
    const Result<void> applied = apply_own(settings, name, option, value);
    if (!applied) return misuse(name + ": " + applied.error().message);
    return {};
  }
  return misuse("unknown option " + name.substr(0, 80) + "; the nearest is " +
                nearest(name, names));
}

bool is_ini(const std::string& argument) {
  const std::string lower = to_lower(argument);
  return lower.ends_with(".ini") || (lower.ends_with(']') && lower.find('[') != std::string::npos);
}

/// `Create_Ini=a.ini` is no INI file.
bool is_key_and_value(const std::string& argument) {
  const std::size_t equals = argument.find('=');
  return equals != std::string::npos && argument.find_first_of("./[") > equals;
}

Result<void> read_one(AppSettings& settings, const std::vector<std::string>& arguments,
                      std::size_t& at) {
  const std::string& argument = arguments[at];
  if (argument.empty()) return {};
  if (argument == "-o" || argument == "-i" || argument == "+o" || argument == "+i") {
    if (at + 1 == arguments.size()) return fail(argument + " needs a file");
    const char* key = argument[1] == 'o' ? "Output_File_Name" : "Input_File_Name";
    return set_option(settings, key, arguments[++at]);
  }
  if (argument.size() > 1 && (argument[0] == '+' || argument[0] == '-')) {
    return apply_switch(settings, argument);
  }
  if (is_ini(argument) && !is_key_and_value(argument)) return read_ini(settings, argument);
  if (const std::size_t equals = argument.find('='); equals != std::string::npos) {
    return set_option(settings, argument.substr(0, equals), argument.substr(equals + 1));
  }
  return set_option(settings, "Input_File_Name", argument);
}

}  // namespace

tl::expected<void, UsageError> read_arguments(AppSettings& settings,
                                              const std::vector<std::string>& arguments) {
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    if (arguments[at].starts_with("--")) {
      if (auto read = read_own(settings, arguments, at); !read) return read;
    } else if (const auto read = read_one(settings, arguments, at); !read) {
      return tl::unexpected<UsageError>(UsageError{read.error().message, false});
    }
  }
  return {};
}

std::string own_options_help() {
  std::string out;
  for (const OwnOption& option : kOwnOptions) {
    std::string line = std::string("  ") + option.name;
    if (option.value) line += std::string(" ") + option.value;
    line.resize(std::max<std::size_t>(line.size() + 2, 28), ' ');
    out += line + option.help + "\n";
  }
  return out;
}

}  // namespace dioptre::app
