// SPDX-License-Identifier: Apache-2.0
#include "unused_options.h"

#include "settings.h"

namespace dioptre::app {
namespace {

constexpr const char* kOn = "|on|true|yes|1|";
constexpr const char* kOff = "|off|false|no|0|";
constexpr const char* kAny = "*";

}  // namespace

const std::vector<UnusedOption>& unused_options() {
  static const std::vector<UnusedOption> kOptions = {
      {"All_File", kOff},
      {"Append_File", kOff},
      {"Bounding", kOn},
      {"Bounding_Method", "|1|", true},
      {"Bounding_Threshold", "|3|", true},
      {"BSP_BaseAccessCost", "", true},
      {"BSP_ChildAccessCost", "", true},
      {"BSP_IsectCost", "", true},
      {"BSP_MaxDepth", "", true},
      {"BSP_MissChance", "", true},
      {"Buffer_Output", kAny},
      {"Buffer_Size", kAny, true},
      {"Continue_Trace", kOff},
      {"Create_Ini", kOff},
      {"Debug_File", kOff},
      {"Display", kAny},
      {"Display_Gamma", kAny},
      {"Dither_Method", "|fs|"},
      {"Draw_Vistas", kOff},
      {"Fatal_Console", kOn},
      {"Fatal_Error_Return", kAny},
      {"Fatal_File", kOff},
      {"Field_Render", kOff},
      {"Grayscale_Output", kOff},
      {"High_Reproducibility", kAny},
      {"Histogram_Name", ""},
      {"Histogram_Type", ""},
      {"Light_Buffer", kOn},
      {"Max_Image_Buffer_Memory", "|128|", true},
      {"Odd_Field", kOff},
      {"Palette", "|0|"},
      {"Pause_When_Done", kOff},
      {"Post_Frame_Return", kAny},
      {"Post_Scene_Return", kAny},
      {"Pre_Frame_Return", kAny},
      {"Pre_Scene_Return", kAny},
      {"Preview_End_Size", "|1|", true},
      {"Preview_Start_Size", "|1|", true},
      {"Radiosity_File_Name", kAny},
      {"Radiosity_From_File", kOff},
      {"Radiosity_To_File", kOff},
      {"Radiosity_Vain_Pretrace", kOn},
      {"Remove_Bounds", kOn},
      {"Render_Block_Size", "|32|", true},
      {"Render_Block_Step", "|0|", true},
      {"Render_Console", kOn},
      {"Render_File", kOff},
      {"Render_Pattern", "|0|", true},
      {"Split_Unions", kOff},
      {"Statistic_Console", kAny},
      {"Statistic_File", kOff},
      {"Test_Abort", kAny},
      {"Test_Abort_Count", kAny, true},
      {"User_Abort_Return", kAny},
      {"Video_Mode", kAny},
      {"Vista_Buffer", kOn},
      {"Warning_File", kOff},
  };
  return kOptions;
}

bool asks_in_vain(const UnusedOption& option, std::string_view value) {
  const std::string_view harmless = option.harmless;
  if (harmless == kAny) return false;
  return harmless.find("|" + to_lower(value) + "|") == std::string_view::npos;
}

}  // namespace dioptre::app
