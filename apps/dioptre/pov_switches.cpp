// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include "command_line.h"

namespace dioptre::app {
namespace {

enum class Form {
  kValue,        ///< +W640: key=640
  kToggle,       ///< +UA, -UA: key=on, key=off
  kToggleValue,  ///< +A0.1: key=on and value_key=0.1; the value may be missing
  kFile,         ///< +FN16: the type and depth of the output file
  kAnything,     ///< +D0T: accepted whatever follows
};

struct Switch {
  std::string_view letters;
  Form form;
  const char* key;
  const char* value_key = nullptr;
};

/// A switch whose letters begin another's stands after it.
constexpr Switch kSwitches[] = {
    {"stp", Form::kValue, "Frame_Step"},
    {"kfi", Form::kValue, "Initial_Frame"},
    {"kff", Form::kValue, "Final_Frame"},
    {"rvp", Form::kToggle, "Radiosity_Vain_Pretrace"},
    {"rfi", Form::kToggle, "Radiosity_From_File"},
    {"rfo", Form::kToggle, "Radiosity_To_File"},
    {"am", Form::kValue, "Sampling_Method"},
    {"ag", Form::kValue, "Antialias_Gamma"},
    {"bm", Form::kValue, "Bounding_Method"},
    {"bs", Form::kValue, "Render_Block_Size"},
    {"ec", Form::kValue, "End_Column"},
    {"ef", Form::kValue, "Subset_End_Frame"},
    {"ep", Form::kValue, "Preview_End_Size"},
    {"er", Form::kValue, "End_Row"},
    {"ga", Form::kToggleValue, "All_Console", "All_File"},
    {"gd", Form::kToggleValue, "Debug_Console", "Debug_File"},
    {"gf", Form::kToggleValue, "Fatal_Console", "Fatal_File"},
    {"gi", Form::kAnything, "Create_Ini"},
    {"gp", Form::kToggle, "Append_File"},
    {"gr", Form::kToggleValue, "Render_Console", "Render_File"},
    {"gs", Form::kToggleValue, "Statistic_Console", "Statistic_File"},
    {"gw", Form::kToggleValue, "Warning_Console", "Warning_File"},
    {"hi", Form::kValue, "Include_Header"},
    {"hr", Form::kToggle, "High_Reproducibility"},
    {"kc", Form::kToggle, "Cyclic_Animation"},
    {"ki", Form::kValue, "Initial_Clock"},
    {"kf", Form::kValue, "Final_Clock"},
    {"mb", Form::kToggleValue, "Bounding", "Bounding_Threshold"},
    {"mi", Form::kValue, "Max_Image_Buffer_Memory"},
    {"mv", Form::kValue, "Version"},
    {"rf", Form::kValue, "Radiosity_File_Name"},
    {"rp", Form::kValue, "Render_Pattern"},
    {"rs", Form::kValue, "Render_Block_Step"},
    {"sc", Form::kValue, "Start_Column"},
    {"sf", Form::kValue, "Subset_Start_Frame"},
    {"sp", Form::kValue, "Preview_Start_Size"},
    {"sr", Form::kValue, "Start_Row"},
    {"su", Form::kToggle, "Split_Unions"},
    {"th", Form::kToggleValue, "Dither", "Dither_Method"},
    {"ua", Form::kToggle, "Output_Alpha"},
    {"ud", Form::kToggle, "Draw_Vistas"},
    {"uf", Form::kToggle, "Field_Render"},
    {"ul", Form::kToggle, "Light_Buffer"},
    {"uo", Form::kToggle, "Odd_Field"},
    {"ur", Form::kToggle, "Remove_Bounds"},
    {"uv", Form::kToggle, "Vista_Buffer"},
    {"wl", Form::kValue, "Warning_Level"},
    {"wt", Form::kValue, "Work_Threads"},
    {"a", Form::kToggleValue, "Antialias", "Antialias_Threshold"},
    {"c", Form::kToggle, "Continue_Trace"},
    {"d", Form::kAnything, "Display"},
    {"f", Form::kFile, "Output_to_File", "Output_File_Type"},
    {"h", Form::kValue, "Height"},
    {"i", Form::kValue, "Input_File_Name"},
    {"j", Form::kToggleValue, "Jitter", "Jitter_Amount"},
    {"k", Form::kValue, "Clock"},
    {"l", Form::kValue, "Library_Path"},
    {"o", Form::kValue, "Output_File_Name"},
    {"p", Form::kToggle, "Pause_When_Done"},
    {"q", Form::kValue, "Quality"},
    {"r", Form::kValue, "Antialias_Depth"},
    {"v", Form::kToggle, "Verbose"},
    {"w", Form::kValue, "Width"},
    {"x", Form::kToggleValue, "Test_Abort", "Test_Abort_Count"},
};

/// Takes one pair of double quotes off a value.
std::string unquoted(std::string text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    return text.substr(1, text.size() - 2);
  }
  return text;
}

Result<void> set_file(AppSettings& settings, const std::string& on, const std::string& value) {
  if (auto set = set_option(settings, "Output_to_File", on); !set || value.empty()) return set;
  if (auto set = set_option(settings, "Output_File_Type", value.substr(0, 1)); !set) return set;
  if (value.size() == 1) return {};
  return set_option(settings, "Bits_Per_Color", value.substr(1));
}

Result<void> apply(AppSettings& settings, const Switch& s, const std::string& on,
                   const std::string& value) {
  switch (s.form) {
    case Form::kValue:
      return set_option(settings, s.key, value);
    case Form::kFile:
      return set_file(settings, on, value);
    case Form::kAnything:
      return set_option(settings, s.key, on);
    case Form::kToggle:
      if (!value.empty()) return fail("\"" + value + "\" is too much");
      return set_option(settings, s.key, on);
    case Form::kToggleValue: {
      if (auto set = set_option(settings, s.key, on); !set || value.empty()) return set;
      return set_option(settings, s.value_key, value);
    }
  }
  return {};
}

}  // namespace

Result<void> apply_switch(AppSettings& settings, const std::string& argument) {
  const std::string letters = to_lower(std::string_view(argument).substr(1));
  const std::string on = argument[0] == '+' ? "on" : "off";
  for (const Switch& s : kSwitches) {
    if (!letters.starts_with(s.letters)) continue;
    if (s.form == Form::kToggle && letters.size() > s.letters.size()) continue;
    const std::string value = unquoted(argument.substr(1 + s.letters.size()));
    const Result<void> applied = apply(settings, s, on, value);
    if (!applied) return fail(argument.substr(0, 80) + ": " + applied.error().message);
    return {};
  }
  std::vector<std::string_view> names;
  for (const Switch& s : kSwitches) names.push_back(s.letters);
  std::string near = nearest(letters, names);
  for (char& c : near) c = static_cast<char>(c - 'a' + 'A');
  return fail("unknown switch \"" + argument.substr(0, 80) + "\"; the nearest is +" + near);
}

}  // namespace dioptre::app
