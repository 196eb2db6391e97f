// SPDX-License-Identifier: Apache-2.0
// Heights as measured on POV-Ray 3.7.
#include <fstream>

#include "dioptre/io/image/palette_samples_test.h"
#include "dioptre/io/pov/syntax/syntax_test_support.h"

namespace dioptre::pov {
namespace {

/// The heights, in steps of 1/65536, of an image in a file of its own.
std::vector<double> heights_of(const std::string& name, const std::string& bytes,
                               const std::string& format = "") {
  const std::string path = testing::TempDir() + name;
  std::ofstream(path, std::ios::binary) << bytes;
  Diagnostics diagnostics;
  NoQueries queries;
  LoadOptions options;
  options.search_folders.push_back(testing::TempDir());
  const auto loaded =
      load_pov_text("t.pov", "#version 3.7; height_field { " + format + " \"" + name + "\" }",
                    options, queries, diagnostics);
  std::vector<double> heights;
  if (!loaded) return heights;
  const auto& shape = std::get<ShapeData>(loaded->scene.objects.at(0).geometry);
  for (const float h : std::get<HeightField>(shape).grid->heights) heights.push_back(65536.0 * h);
  return heights;
}

TEST(HeightFields, TheLastRowOfTheImageIsTheFirstOfLand) {
  EXPECT_EQ(heights_of("grey.pgm", "P5\n2 3\n255\n\x01\x02\x03\x04\x05\xff"),
            (std::vector<double>{5 * 257, 65535, 3 * 257, 4 * 257, 257, 2 * 257}));
}

TEST(HeightFields, RedIsTheHighByteAndGreenTheLowOne) {
  EXPECT_EQ(
      heights_of("colors.ppm", "P6\n2 2\n255\n\x01\x02\x03\x04\x05\xff\x07\x08\x09\x0a\x0b\x0c"),
      (std::vector<double>{0x0708, 0x0a0b, 0x0102, 0x0405}));
}

TEST(HeightFields, NumbersOfPalettesAreHighBytes) {
  for (const auto& [name, bytes] : palette_files()) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < 16; ++i) heights.push_back(256 * kPaletteNumbers[(i + 8) % 16]);
    EXPECT_EQ(heights_of(name, bytes), heights) << name;
  }
}

TEST(HeightFields, TheHalvesOfAPotImageAreHighAndLowBytes) {
  EXPECT_EQ(heights_of("p.pot", palette_gif(), "pot"),
            (std::vector<double>{0x604, 0x502, 0x301, 0x700, 0x007, 0x103, 0x205, 0x406}));
  EXPECT_TRUE(heights_of("thin.pot", "P5\n3 2\n255\n\x01\x02\x03\x04\x05\x06", "pot").empty());
}

TEST(HeightFields, FunctionsAreRoundedDown) {
  const auto field =
      shape_of<HeightField>("height_field { function 3, 2 { x } smooth water_level 0.25 }");
  EXPECT_EQ(field.grid->width, 3u);
  EXPECT_EQ(field.grid->depth, 2u);
  EXPECT_EQ(field.grid->heights, std::vector<float>(6, 32767 * 0x1p-16f));
  EXPECT_TRUE(field.smooth);
  EXPECT_EQ(field.water_level, 0.25);
}

TEST(HeightFields, OfOddSizesAreErrors) {
  EXPECT_NE(said("height_field { function 1, 2 { x } }").find("at least 2 x 2 points"),
            std::string::npos);
  EXPECT_NE(said("height_field { function 1e9, 1e9 { x } }").find("too many points"),
            std::string::npos);
  EXPECT_TRUE(heights_of("thin.pgm", "P5\n1 2\n255\n\x01\x02").empty());
}

}  // namespace
}  // namespace dioptre::pov
