// SPDX-License-Identifier: Apache-2.0
#include "settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "dioptre/io/spelling.h"
#include "unused_options.h"

namespace dioptre::app {
namespace {

using Value = const std::string&;

tl::unexpected<Error> expected(const char* what, Value value) {
  return fail(std::string("expected ") + what + ", found \"" + value + "\"");
}

Result<void> read_number(Value text, double low, double high, double& out) {
  double value = 0;
  const char* start = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(start, text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) {
    return expected("a number", text);
  }
  if (!(value >= low && value <= high)) return fail("the number " + text + " is out of range");
  out = value;
  return {};
}

template <double low, double high, auto member>
Result<void> number(AppSettings& settings, Value text) {
  return read_number(text, low, high, settings.*member);
}

template <double low, double high, auto member>
Result<void> whole(AppSettings& settings, Value text) {
  double value = 0;
  if (auto read = read_number(text, low, high, value); !read) return read;
  if (value != std::floor(value)) return expected("a whole number", text);
  using Member = std::remove_reference_t<decltype(settings.*member)>;
  settings.*member = static_cast<Member>(value);
  return {};
}

template <auto member>
Result<void> flag(AppSettings& settings, Value text) {
  const std::string v = to_lower(text);
  settings.*member = v == "on" || v == "true" || v == "yes" || v == "1";
  if (settings.*member || v == "off" || v == "false" || v == "no" || v == "0") return {};
  return expected("on or off", text);
}

template <auto member>
Result<void> text(AppSettings& settings, Value value) {
  if (value.empty()) return fail("expected a name");
  settings.*member = value;
  return {};
}

/// The number of a frame: its whole part, and `least` for what is less (measured).
template <std::int32_t least, auto member>
Result<void> frame(AppSettings& settings, Value text) {
  double value = 0;
  if (auto read = read_number(text, -1e300, INT32_MAX, value); !read) return read;
  settings.*member = static_cast<std::int32_t>(std::fmax(std::trunc(value), least));
  return {};
}

Result<void> clock(AppSettings& settings, Value text) {
  settings.clock_given = true;
  return read_number(text, -1e300, 1e300, settings.clock);
}

Result<void> subset_end(AppSettings& settings, Value text) {
  return read_number(text, -1e300, INT32_MAX, settings.subset_end.emplace());
}

/// Shell commands in a file from a stranger must not run.
Result<void> refuse_command(AppSettings&, Value) {
  return fail("shell commands are not run; remove the line");
}

Result<void> library_path(AppSettings& settings, Value path) {
  if (path.empty()) return fail("expected a folder");
  settings.search_folders.push_back(path);
  return {};
}

Result<void> declare(AppSettings& settings, Value text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) return expected("NAME=NUMBER", text);
  double value = 0;
  if (auto read = read_number(text.substr(equals + 1), -1e300, 1e300, value); !read) return read;
  settings.declares[text.substr(0, equals)] = value;
  return {};
}

Result<void> file_gamma(AppSettings& settings, Value text) {
  if (to_lower(text) == "srgb") {
    settings.file_gamma = 0;
    return {};
  }
  return read_number(text, 0.01, 100, settings.file_gamma);
}

Result<void> file_type(AppSettings& settings, Value text) {
  const std::string type = to_lower(text);
  if (type.empty() || std::string_view("bcehjnpst").find(type[0]) == std::string_view::npos) {
    return expected("one of B C E H J N P S T", text);
  }
  if (type.size() > 1) {
    if (auto set = whole<1.0, 16.0, &AppSettings::bits>(settings, type.substr(1)); !set) return set;
  }
  settings.file_type = static_cast<char>(type[0] - 'a' + 'A');
  return {};
}

/// All consoles at once.
Result<void> consoles(AppSettings& settings, Value text) {
  if (auto set = flag<&AppSettings::warnings>(settings, text); !set) return set;
  settings.debug_messages = settings.warnings;
  return {};
}

/// 0: no warnings.
Result<void> warning_level(AppSettings& settings, Value text) {
  double level = 0;
  if (auto read = read_number(text, 0, 1e9, level); !read) return read;
  settings.warnings = level > 0;
  return {};
}

Result<void> progress(AppSettings& settings, Value text) {
  for (const char* known : {"auto", "plain", "json", "none"}) {
    if (text == known) {
      settings.progress = text;
      return {};
    }
  }
  return expected("auto, plain, json or none", text);
}

Result<void> pixel(AppSettings& settings, Value text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return expected("column,row", text);
  constexpr double kMost = 4294967295.0;
  double column = 0, row = 0;
  if (auto read = read_number(text.substr(0, comma), 0, kMost, column); !read) return read;
  if (auto read = read_number(text.substr(comma + 1), 0, kMost, row); !read) return read;
  settings.pixel = {static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)};
  return {};
}

Result<void> polygon_test(AppSettings& settings, Value text) {
  if (text != "crossings" && text != "angles") return expected("crossings or angles", text);
  settings.polygon_test = text == "angles" ? PolygonTest::kAngles : PolygonTest::kCrossings;
  return {};
}

Result<void> penumbra(AppSettings& settings, Value text) {
  for (std::size_t i = 0; i < kLightShapeNames.size(); ++i) {
    if (text != kLightShapeNames[i]) continue;
    settings.penumbra = static_cast<LightShape>(i);
    return {};
  }
  return expected("grid, rectangle, disc or sphere", text);
}

Result<void> accelerator(AppSettings& settings, Value value) {
  settings.accelerator_is_named = true;
  return text<&AppSettings::accelerator>(settings, value);
}

/// One number for mirrored and transmitted rays, or one for each.
Result<void> attenuation(AppSettings& settings, Value text) {
  const std::size_t comma = text.find(',');
  const std::string second = comma == std::string::npos ? text : text.substr(comma + 1);
  double reflected = 0, transmitted = 0;
  if (auto read = read_number(text.substr(0, comma), 0, 1e300, reflected); !read) return read;
  if (auto read = read_number(second, 0, 1e300, transmitted); !read) return read;
  settings.reflected_attenuation = reflected;
  settings.transmitted_attenuation = transmitted;
  return {};
}

template <auto member>
Result<void> layers(AppSettings& settings, Value names) {
  const bool maps = member == &AppSettings::heat_maps;
  const auto read = read_layers(names, maps ? LayerSet::costs() : LayerSet::all());
  if (!read) return tl::unexpected(read.error());
  settings.*member = *read;
  return {};
}

using Set = Result<void> (*)(AppSettings&, Value);
struct Option {
  const char* name;
  Set set;
};
using S = AppSettings;
constexpr double kBig = 2147483647;

/// In alphabetical order.
const Option kOptions[] = {
    {"Accelerator", accelerator},
    {"All_Console", consoles},
    {"Antialias", flag<&S::antialias>},
    {"Antialias_Depth", whole<1.0, 9.0, &S::antialias_depth>},
    {"Antialias_Gamma", number<0.01, 100.0, &S::antialias_gamma>},
    {"Antialias_Threshold", number<0.0, 3.0, &S::antialias_threshold>},
    {"Attenuation", attenuation},
    {"Bits_Per_Color", whole<1.0, 16.0, &S::bits>},
    {"Clock", clock},
    {"Compared_Rays", whole<1.0, 100e6, &S::compared_rays>},
    {"Compression", whole<0.0, 100.0, &S::compression>},
    {"Cyclic_Animation", flag<&S::cyclic>},
    {"Debug_Console", flag<&S::debug_messages>},
    {"Declare", declare},
    {"Dither", flag<&S::dither>},
    {"End_Column", number<0.0, kBig, &S::end_column>},
    {"End_Row", number<0.0, kBig, &S::end_row>},
    {"Explain_Pixel", pixel},
    {"Fatal_Error_Command", refuse_command},
    {"File_Gamma", file_gamma},
    {"Final_Clock", number<-1e300, 1e300, &S::final_clock>},
    {"Final_Frame", frame<0, &S::final_frame>},
    {"Frame_Step", whole<1.0, kBig, &S::frame_step>},
    {"Heatmap", layers<&S::heat_maps>},
    {"Height", whole<1.0, kBig, &S::height>},
    {"Include_Header", text<&S::include_header>},
    {"Initial_Clock", number<-1e300, 1e300, &S::initial_clock>},
    {"Initial_Frame", frame<0, &S::initial_frame>},
    {"Input_File_Name", text<&S::input>},
    {"Integrator", text<&S::integrator>},
    {"Jitter", flag<&S::jitter>},
    {"Jitter_Amount", number<0.0, 1e6, &S::jitter_amount>},
    {"Layers", layers<&S::layers>},
    {"Library_Path", library_path},
    {"Light_Samples", whole<1.0, 65536.0, &S::light_samples>},
    {"Max_Array_Elements", whole<0.0, 4e9, &S::max_array_elements>},
    {"Max_Nesting", whole<1.0, 1e5, &S::max_nesting>},
    {"Max_Objects", whole<0.0, 4e9, &S::max_objects>},
    {"Max_Pixels", whole<1.0, 1e12, &S::max_pixels>},
    {"Max_Read_Seconds", number<0.0, 1e9, &S::max_read_seconds>},
    {"Max_Scene_Bytes", whole<0.0, 1e15, &S::max_scene_bytes>},
    {"Max_Steps", whole<0.0, 1e15, &S::max_steps>},
    {"Max_String_Bytes", whole<0.0, 1e15, &S::max_string_bytes>},
    {"Max_Written_Bytes", whole<0.0, 1e15, &S::max_written_bytes>},
    {"Output_Alpha", flag<&S::alpha>},
    {"Output_File_Name", text<&S::output>},
    {"Output_File_Type", file_type},
    {"Output_to_File", flag<&S::output_to_file>},
    {"Penumbra", penumbra},
    {"Polygon_Test", polygon_test},
    {"Post_Frame_Command", refuse_command},
    {"Post_Scene_Command", refuse_command},
    {"Pre_Frame_Command", refuse_command},
    {"Pre_Scene_Command", refuse_command},
    {"Progress", progress},
    {"Quality", whole<0.0, 11.0, &S::quality>},
    {"Report_Csv", text<&S::csv_report>},
    {"Report_Html", text<&S::html_report>},
    {"Report_Json", text<&S::json_report>},
    {"Sampling_Method", whole<1.0, 2.0, &S::sampling_method>},
    {"Shadows", flag<&S::shadows>},
    {"Start_Column", number<0.0, kBig, &S::start_column>},
    {"Start_Row", number<0.0, kBig, &S::start_row>},
    {"Subset_End_Frame", subset_end},
    {"Subset_Start_Frame", number<-1e300, kBig, &S::subset_start>},
    {"Terms", flag<&S::term_images>},
    {"User_Abort_Command", refuse_command},
    {"Strict", flag<&S::strict>},
    {"Verbose", flag<&S::verbose>},
    {"Version", number<0.0, 3.85, &S::version>},
    {"Warning_Console", flag<&S::warnings>},
    {"Warning_Level", warning_level},
    {"Width", whole<1.0, kBig, &S::width>},
    {"Work_Threads", whole<0.0, 512.0, &S::threads>},
};

Result<void> set_unused(AppSettings& settings, const UnusedOption& option, Value value) {
  double unused = 0;
  if (option.number) {
    const auto read = read_number(value, -1e300, 1e300, unused);
    if (!read) return fail(std::string(option.name) + ": " + read.error().message);
  }
  auto& known = settings.without_effect;
  if (asks_in_vain(option, value) &&
      std::find(known.begin(), known.end(), option.name) == known.end()) {
    known.emplace_back(option.name);
  }
  return {};
}

}  // namespace

std::string to_lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

std::string nearest(std::string_view name, const std::vector<std::string_view>& names) {
  const std::string_view wanted = name.substr(0, 64);
  std::size_t best = wanted.size() + 64;
  std::string_view found;
  for (const std::string_view known : names) {
    const std::size_t distance = edit_distance(wanted, known);
    if (distance < best) {
      best = distance;
      found = known;
    }
  }
  return std::string(found);
}

std::vector<std::string_view> option_names() {
  std::vector<std::string_view> names;
  for (const Option& option : kOptions) names.emplace_back(option.name);
  for (const UnusedOption& option : unused_options()) names.emplace_back(option.name);
  std::sort(names.begin(), names.end(),
            [](std::string_view a, std::string_view b) { return to_lower(a) < to_lower(b); });
  return names;
}

Result<void> set_option(AppSettings& settings, std::string_view key, const std::string& value) {
  const std::string wanted = to_lower(key);
  for (const Option& option : kOptions) {
    if (to_lower(option.name) != wanted) continue;
    const Result<void> set = option.set(settings, value);
    if (!set) return fail(std::string(option.name) + ": " + set.error().message);
    return {};
  }
  for (const UnusedOption& option : unused_options()) {
    if (to_lower(option.name) == wanted) return set_unused(settings, option, value);
  }
  return fail("unknown option \"" + std::string(key.substr(0, 80)) + "\"; the nearest is " +
              nearest(key, option_names()));
}

}  // namespace dioptre::app
