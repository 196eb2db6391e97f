// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "frames.h"
#include "ini_file.h"

namespace dioptre::app {
namespace {

AppSettings parse(const std::vector<std::string>& arguments) {
  AppSettings settings;
  const auto read = read_arguments(settings, arguments);
  EXPECT_TRUE(read) << (read ? "" : read.error().message);
  return settings;
}

TEST(CommandLine, SwitchesAndKeysSayTheSame) {
  const std::pair<const char*, std::vector<std::string>> pairs[] = {
      {"+W640", {"Width=640"}},
      {"-h48", {"Height=48"}},
      {"+Iscene.pov", {"Input_File_Name=scene.pov"}},
      {"+Oout.png", {"Output_File_Name=out.png"}},
      {"+O-", {"Output_File_Name=-"}},
      {"+A", {"Antialias=on"}},
      {"-A", {"Antialias=off"}},
      {"+A0.1", {"Antialias=on", "Antialias_Threshold=0.1"}},
      {"-A0.1", {"Antialias=off", "Antialias_Threshold=0.1"}},
      {"+AM2", {"Sampling_Method=2"}},
      {"+AG1.0", {"Antialias_Gamma=1"}},
      {"+R4", {"Antialias_Depth=4"}},
      {"+J0.5", {"Jitter=on", "Jitter_Amount=0.5"}},
      {"-J", {"Jitter=off"}},
      {"+Q5", {"Quality=5"}},
      {"+FN16", {"Output_to_File=on", "Output_File_Type=N", "Bits_Per_Color=16"}},
      {"+FP", {"Output_to_File=on", "Output_File_Type=P"}},
      {"-F", {"Output_to_File=off"}},
      {"-FT", {"Output_to_File=off", "Output_File_Type=t"}},
      {"+UA", {"Output_Alpha=yes"}},
      {"-UA", {"Output_Alpha=0"}},
      {"+Ldir", {"Library_Path=dir"}},
      {"+L\"a b\"", {"Library_Path=a b"}},
      {"+WT2", {"Work_Threads=2"}},
      {"+SR13", {"Start_Row=13"}},
      {"+ER0.5", {"End_Row=0.5"}},
      {"+SC0.25", {"Start_Column=0.25"}},
      {"+EC40", {"End_Column=40"}},
      {"+K0.5", {"Clock=0.5"}},
      {"+K-2", {"Clock=-2"}},
      {"+KFI2", {"Initial_Frame=2"}},
      {"+KFF9", {"Final_Frame=9"}},
      {"+KI25", {"Initial_Clock=25"}},
      {"+KF75", {"Final_Clock=75"}},
      {"+KC", {"Cyclic_Animation=on"}},
      {"+SF0.3", {"Subset_Start_Frame=0.3"}},
      {"+EF7", {"Subset_End_Frame=7"}},
      {"+STP3", {"Frame_Step=3"}},
      {"+MV3.5", {"Version=3.5"}},
      {"+HIx.inc", {"Include_Header=x.inc"}},
      {"+TH", {"Dither=on"}},
      {"-V", {"Verbose=off"}},
      {"--size=64x48", {"Width=64", "Height=48"}},
      {"--region=3,4,5,6", {"+SC3", "+SR4", "+EC5", "+ER6"}},
      {"--aa=0.2", {"+A0.2"}},
      {"--threads=3", {"+WT3"}},
  };
  for (const auto& [spelling, keys] : pairs) {
    EXPECT_EQ(parse({spelling}), parse(keys)) << spelling;
  }
}

TEST(CommandLine, EveryDocumentedSwitchIsKnown) {
  for (const char* letters :
       {"K1",     "KFI1",   "KFF1",   "KI1",    "KF1",    "SF0.1",  "EF0.1", "STP2", "KC",
        "UF",     "UO",     "H1",     "W1",     "MI64",   "SC1",    "SR1",   "EC1",  "ER1",
        "X",      "X10",    "C",      "GIfile", "D",      "D0",     "D0T",   "P",    "V",
        "UD",     "SP8",    "EP1",    "F",      "FN16",   "FB",     "FC",    "FE",   "FH",
        "FJ",     "FP",     "FS",     "FT",     "UA",     "Oout",   "TH",    "THfs", "Ifile",
        "HIf",    "Ldir",   "MV3.7",  "GD",     "GF",     "GR",     "GS",    "GW",   "GA",
        "GDfile", "GFfile", "GRfile", "GSfile", "GWfile", "GAfile", "GP",    "WL5",  "WT2",
        "BS16",   "RP2",    "RS1",    "Q9",     "BM2",    "MB",     "MB3",   "UL",   "UV",
        "UR",     "SU",     "A",      "A0.3",   "AM1",    "J",      "J1.0",  "R3",   "AG2.5",
        "HR",     "RFname", "RFI",    "RFO",    "RVP"}) {
    for (const char* sign : {"+", "-"}) {
      AppSettings settings;
      const auto applied = apply_switch(settings, std::string(sign) + letters);
      EXPECT_TRUE(applied) << sign << letters << ": " << (applied ? "" : applied.error().message);
    }
  }
}

TEST(CommandLine, EveryKeyIsFoundInAnyCase) {
  for (const std::string_view name : option_names()) {
    AppSettings settings;
    const auto upper = set_option(settings, name, "");
    if (!upper) {
      EXPECT_EQ(upper.error().message.find("unknown option"), std::string::npos) << name;
    }
    const auto lower = set_option(settings, to_lower(name), "");
    EXPECT_EQ(upper.has_value(), lower.has_value()) << name;
  }
}

TEST(CommandLine, TheLastOneWinsAndLibraryPathsAccumulate) {
  const AppSettings settings = parse({"+W10", "Width=20", "+W30", "+La", "Library_Path=b"});
  EXPECT_EQ(settings.width, 30u);
  EXPECT_EQ(settings.search_folders, (std::vector<std::string>{"a", "b"}));
}

TEST(CommandLine, AnUnknownOptionNamesTheNearest) {
  AppSettings settings;
  const auto key = read_arguments(settings, {"Widht=640"});
  ASSERT_FALSE(key);
  EXPECT_EQ(key.error().message, "unknown option \"Widht\"; the nearest is Width");
  EXPECT_FALSE(key.error().own_option);
  const auto own = read_arguments(settings, {"--thread", "2"});
  ASSERT_FALSE(own);
  EXPECT_EQ(own.error().message, "unknown option --thread; the nearest is --threads");
  EXPECT_TRUE(own.error().own_option);
  EXPECT_FALSE(read_arguments(settings, {"+Z99"}));
}

TEST(CommandLine, OptionsWithoutEffectAreNotedOnce) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(parse({"+C", "+UF", "Continue_Trace=on"}).without_effect,
            (Names{"Continue_Trace", "Field_Render"}));
  EXPECT_EQ(parse({"-C", "-UF", "-D", "+UV", "Bounding_Threshold=3"}).without_effect, Names{});
  EXPECT_EQ(parse({"Create_Ini=a.ini"}).without_effect, Names{"Create_Ini"});
}

TEST(CommandLine, EachBudgetHasAnOption) {
  const AppSettings s =
      parse({"--max-steps=1", "--max-objects=2", "--max-nesting=3", "--max-string-bytes=4",
             "--max-array-elements=5", "--max-written-bytes=6", "--max-scene-bytes=7",
             "--max-read-seconds=8", "--max-pixels=9"});
  EXPECT_EQ(s.max_steps, 1u);
  EXPECT_EQ(s.max_objects, 2u);
  EXPECT_EQ(s.max_nesting, 3u);
  EXPECT_EQ(s.max_string_bytes, 4u);
  EXPECT_EQ(s.max_array_elements, 5u);
  EXPECT_EQ(s.max_written_bytes, 6u);
  EXPECT_EQ(s.max_scene_bytes, 7u);
  EXPECT_EQ(s.max_read_seconds, 8);
  EXPECT_EQ(s.max_pixels, 9u);
}

TEST(CommandLine, BadValuesAreRefused) {
  for (const char* bad :
       {"+W",          "+W0",        "+W-5",           "+W1e30",
        "+Wnan",       "+W6.5",      "+H99999999999",  "+A4",
        "+AM3",        "+R0",        "+Q12",           "+FX",
        "+FN17",       "Clock=abc",  "Declare=x",      "Post_Scene_Command=rm -rf /",
        "--size=64",   "--size=0x0", "--region=1,2,3", "--progress=loud",
        "--threads=-1"}) {
    AppSettings settings;
    EXPECT_FALSE(read_arguments(settings, {bad})) << bad;
  }
}

class IniFile : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    const std::string path = testing::TempDir() + "/dioptre_" + name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
};

TEST_F(IniFile, SectionsCountOnlyWhenAskedFor) {
  const std::string path = write("sections.ini",
                                 "; a comment\r\nWidth = 100 ; wide\n+H50 -D\n[Small]\nWidth=10\n"
                                 "[large]\nWidth=1000\nDeclare=RAD=2\n");
  EXPECT_EQ(parse({path}).width, 100u);
  EXPECT_EQ(parse({path}).height, 50u);
  EXPECT_EQ(parse({path + "[small]"}).width, 10u);
  EXPECT_EQ(parse({path + "[LARGE]"}).width, 1000u);
  EXPECT_EQ(parse({path + "[large]"}).declares.at("RAD"), 2);
  AppSettings settings;
  EXPECT_FALSE(read_ini(settings, path + "[none]"));
}

TEST_F(IniFile, ErrorsNameFileAndLine) {
  const std::string path = write("bad.ini", "Width=1\n\nHight=2\n");
  AppSettings settings;
  const auto read = read_ini(settings, path);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message,
            path + ":3: error: unknown option \"Hight\"; the nearest is Height");
}

TEST_F(IniFile, OneThatIncludesItselfEnds) {
  const std::string path = testing::TempDir() + "/dioptre_self.ini";
  std::ofstream(path, std::ios::binary) << path << "\n";
  AppSettings settings;
  EXPECT_FALSE(read_ini(settings, path));
}

TEST(Frames, ClocksRunFromTheFirstToTheLastFrame) {
  const AppSettings open = parse({"+KFI1", "+KFF11", "+KI0", "+KF1"});
  EXPECT_DOUBLE_EQ(frame_clock(open, 1), 0);
  EXPECT_DOUBLE_EQ(frame_clock(open, 11), 1);
  const AppSettings cyclic = parse({"+KFF10", "+KC"});
  EXPECT_DOUBLE_EQ(frame_clock(cyclic, 10), 0.9);
}

// Measured: what POV-Ray 3.7 renders for the same options.
TEST(Frames, ThereIsAlwaysOne) {
  struct Case {
    std::vector<std::string> words;
    std::int64_t first, last;
    const char* name;
  };
  const Case cases[] = {
      {{}, 0, 0, "a.png"},
      {{"+KFF0"}, 0, 0, "a.png"},
      {{"+KFF0", "+SF3"}, 0, 0, "a.png"},
      {{"+KFI0"}, 0, 0, "a.png"},
      {{"+KFI3"}, 3, 3, "a3.png"},
      {{"+KFI5", "+KFF2"}, 5, 5, "a5.png"},
      {{"+KFI12", "+KFF2"}, 12, 12, "a12.png"},
      {{"+KFI2", "+KFF4", "+SF5"}, 5, 5, "a5.png"},
      {{"+KFI2", "+KFF4", "+SF4", "+EF3"}, 4, 4, "a4.png"},
      {{"+KFI8", "+KFF12", "+EF4"}, 8, 8, "a08.png"},
      {{"+KFI8", "+KFF12", "+SF7"}, 8, 12, "a08.png"},
      {{"+KFI8", "+KFF12", "+SF9", "+EF20"}, 9, 20, "a09.png"},
      {{"+KFF10", "+SF0.3", "+EF0.5"}, 3, 5, "a03.png"},
      {{"+KFF10", "+SF0.75"}, 7, 10, "a07.png"},
      {{"+KFF10", "+EF0.05"}, 1, 1, "a01.png"},
      {{"+KFF10", "+EF0"}, 1, 1, "a01.png"},
      {{"+KFF10", "+SF-1"}, 1, 10, "a01.png"},
      {{"+KFI5", "+KFF14", "+SF0.75"}, 7, 14, "a07.png"},
      {{"+KFI5", "+KFF14", "+EF0.25"}, 5, 5, "a05.png"},
      {{"+KFI2.9", "+KFF4.5"}, 2, 4, "a2.png"},
      {{"+KFI-2", "+KFF2"}, 0, 2, "a0.png"},
  };
  for (const Case& c : cases) {
    std::vector<std::string> words = c.words;
    words.push_back("+Oa.png");
    const AppSettings s = parse(words);
    const FrameRange range = frame_range(s);
    EXPECT_EQ(range.first, c.first) << c.name;
    EXPECT_EQ(range.last, c.last) << c.name;
    EXPECT_EQ(output_path(s, range.first), c.name);
    EXPECT_TRUE(std::isfinite(frame_clock(s, range.first)));
  }
}

TEST(Frames, NamesAreAsPovRayHasThem) {
  EXPECT_EQ(output_path(parse({"dir/scene.pov"}), 0), "scene.png");
  EXPECT_EQ(output_path(parse({"scene.pov", "+FP"}), 0), "scene.ppm");
  EXPECT_EQ(output_path(parse({"scene.pov", "+Oa.png", "+KFF100"}), 7), "a007.png");
  EXPECT_EQ(output_path(parse({"scene.pov", "+O-"}), 0), "-");
}

TEST(Frames, DevicesKeepTheirNames) {
  EXPECT_EQ(output_path(parse({"scene.pov", "+O/dev/null"}), 0), "/dev/null");
  EXPECT_EQ(output_path(parse({"scene.pov", "+O/dev/full", "+FP", "+KFF9"}), 3), "/dev/full");
}

TEST(Frames, SubsetsAndStepsKeepTheClock) {
  const AppSettings s = parse({"+KFF100", "+SF30", "+EF40", "+STP5"});
  const FrameRange range = frame_range(s);
  EXPECT_EQ(range.first, 30);
  EXPECT_EQ(range.last, 40);
  EXPECT_EQ(range.step, 5);
  EXPECT_DOUBLE_EQ(frame_clock(s, 100), 1);
}

}  // namespace
}  // namespace dioptre::app
