// SPDX-License-Identifier: Apache-2.0
#include "settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>

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

bool is_true(Value text) {
  const std::string v = to_lower(text);
  return v == "on" || v == "true" || v == "yes" || v == "1";
}

template <auto member>
Result<void> flag(AppSettings& settings, Value text) {
  settings.*member = is_true(text);
  return {};
}

template <auto member>
Result<void> text(AppSettings& settings, Value value) {
  if (value.empty()) return fail("expected a name");
  settings.*member = value;
  return {};
}

Result<void> ignore(AppSettings&, Value) { return {}; }

Result<void> ignore_number(AppSettings&, Value text) {
  double unused = 0;
  return read_number(text, -1e300, 1e300, unused);
}

/// Shell commands in a file from a stranger must not run.
Result<void> refuse_command(AppSettings&, Value) {
  return fail("shell commands are not run; remove the line");
}

Result<void> library_path(AppSettings& settings, Value path) {
  if (path.empty()) return fail("expected a folder");
  settings.library_paths.push_back(path);
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

Result<void> progress(AppSettings& settings, Value text) {
  for (const char* known : {"auto", "plain", "json", "none"}) {
    if (text == known) {
      settings.progress = text;
      return {};
    }
  }
  return expected("auto, plain, json or none", text);
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
    {"Accelerator", text<&S::accelerator>},
    {"All_Console", flag<&S::warnings>},
    {"All_File", ignore},
    {"Antialias", flag<&S::antialias>},
    {"Antialias_Depth", whole<1.0, 9.0, &S::antialias_depth>},
    {"Antialias_Gamma", number<0.01, 100.0, &S::antialias_gamma>},
    {"Antialias_Threshold", number<0.0, 3.0, &S::antialias_threshold>},
    {"Append_File", ignore},
    {"Bits_Per_Color", whole<1.0, 16.0, &S::bits>},
    {"Bounding", ignore},
    {"Bounding_Method", ignore_number},
    {"Bounding_Threshold", ignore_number},
    {"BSP_BaseAccessCost", ignore_number},
    {"BSP_ChildAccessCost", ignore_number},
    {"BSP_IsectCost", ignore_number},
    {"BSP_MaxDepth", ignore_number},
    {"BSP_MissChance", ignore_number},
    {"Buffer_Output", ignore},
    {"Buffer_Size", ignore_number},
    {"Clock", number<-1e300, 1e300, &S::clock>},
    {"Compression", whole<0.0, 100.0, &S::compression>},
    {"Continue_Trace", ignore},
    {"Create_Ini", ignore},
    {"Cyclic_Animation", flag<&S::cyclic>},
    {"Debug_Console", ignore},
    {"Debug_File", ignore},
    {"Declare", declare},
    {"Display", ignore},
    {"Display_Gamma", ignore},
    {"Dither", flag<&S::dither>},
    {"Dither_Method", ignore},
    {"Draw_Vistas", ignore},
    {"End_Column", number<0.0, kBig, &S::end_column>},
    {"End_Row", number<0.0, kBig, &S::end_row>},
    {"Fatal_Console", ignore},
    {"Fatal_Error_Command", refuse_command},
    {"Fatal_Error_Return", ignore},
    {"Fatal_File", ignore},
    {"Field_Render", ignore},
    {"File_Gamma", file_gamma},
    {"Final_Clock", number<-1e300, 1e300, &S::final_clock>},
    {"Final_Frame", whole<-1.0, kBig, &S::final_frame>},
    {"Frame_Step", whole<1.0, kBig, &S::frame_step>},
    {"Height", whole<1.0, kBig, &S::height>},
    {"High_Reproducibility", ignore},
    {"Histogram_Name", ignore},
    {"Histogram_Type", ignore},
    {"Include_Header", text<&S::include_header>},
    {"Initial_Clock", number<-1e300, 1e300, &S::initial_clock>},
    {"Initial_Frame", whole<0.0, kBig, &S::initial_frame>},
    {"Input_File_Name", text<&S::input>},
    {"Integrator", text<&S::integrator>},
    {"Jitter", flag<&S::jitter>},
    {"Jitter_Amount", number<0.0, 1e6, &S::jitter_amount>},
    {"Library_Path", library_path},
    {"Light_Buffer", ignore},
    {"Max_Image_Buffer_Memory", ignore_number},
    {"Max_Nesting", whole<1.0, 1e6, &S::max_nesting>},
    {"Max_Objects", whole<0.0, 1e15, &S::max_objects>},
    {"Max_Pixels", whole<1.0, 1e12, &S::max_pixels>},
    {"Max_Seconds", number<0.0, 1e9, &S::max_seconds>},
    {"Max_Steps", whole<0.0, 1e15, &S::max_steps>},
    {"Odd_Field", ignore},
    {"Output_Alpha", flag<&S::alpha>},
    {"Output_File_Name", text<&S::output>},
    {"Output_File_Type", file_type},
    {"Output_to_File", flag<&S::output_to_file>},
    {"Palette", ignore},
    {"Pause_When_Done", ignore},
    {"Post_Frame_Command", refuse_command},
    {"Post_Frame_Return", ignore},
    {"Post_Scene_Command", refuse_command},
    {"Post_Scene_Return", ignore},
    {"Pre_Frame_Command", refuse_command},
    {"Pre_Frame_Return", ignore},
    {"Pre_Scene_Command", refuse_command},
    {"Pre_Scene_Return", ignore},
    {"Preview_End_Size", ignore_number},
    {"Preview_Start_Size", ignore_number},
    {"Progress", progress},
    {"Quality", whole<0.0, 11.0, &S::quality>},
    {"Radiosity_File_Name", ignore},
    {"Radiosity_From_File", ignore},
    {"Radiosity_To_File", ignore},
    {"Radiosity_Vain_Pretrace", ignore},
    {"Remove_Bounds", ignore},
    {"Render_Block_Size", ignore_number},
    {"Render_Block_Step", ignore_number},
    {"Render_Console", ignore},
    {"Render_File", ignore},
    {"Render_Pattern", ignore_number},
    {"Sampling_Method", whole<1.0, 2.0, &S::sampling_method>},
    {"Split_Unions", ignore},
    {"Start_Column", number<0.0, kBig, &S::start_column>},
    {"Start_Row", number<0.0, kBig, &S::start_row>},
    {"Statistic_Console", ignore},
    {"Statistic_File", ignore},
    {"Subset_End_Frame", number<0.0, kBig, &S::subset_end>},
    {"Subset_Start_Frame", number<0.0, kBig, &S::subset_start>},
    {"Test_Abort", ignore},
    {"Test_Abort_Count", ignore_number},
    {"User_Abort_Command", refuse_command},
    {"User_Abort_Return", ignore},
    {"Verbose", flag<&S::verbose>},
    {"Version", number<0.0, 10.0, &S::version>},
    {"Video_Mode", ignore},
    {"Vista_Buffer", ignore},
    {"Warning_Console", flag<&S::warnings>},
    {"Warning_File", ignore},
    {"Warning_Level", ignore_number},
    {"Width", whole<1.0, kBig, &S::width>},
    {"Work_Threads", whole<0.0, 512.0, &S::threads>},
};

/// The number of insertions, deletions and replacements between two words (Levenshtein 1966).
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
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
  const std::string wanted = to_lower(name.substr(0, 64));
  std::size_t best = wanted.size() + 64;
  std::string_view found;
  for (const std::string_view known : names) {
    const std::size_t distance = edits(wanted, to_lower(known));
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
  return fail("unknown option \"" + std::string(key.substr(0, 80)) + "\"; the nearest is " +
              nearest(key, option_names()));
}

}  // namespace dioptre::app
