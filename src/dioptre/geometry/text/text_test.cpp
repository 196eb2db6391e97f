// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/text/text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "dioptre/geometry/text/glyphs.h"

namespace dioptre {
namespace {

constexpr const char* kSans = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* kTimes = "/usr/share/povray-3.7/include/timrom.ttf";

Bounds bounds_of(const char* font, const std::string& letters, Vec3 offset = {}) {
  Text text;
  text.font = font;
  text.text = letters;
  text.offset = offset;
  const auto shape = prepare(text);
  EXPECT_TRUE(shape) << shape.error().message;
  return shape ? (*shape)->bounds() : Bounds{};
}

// Reference values: max_extent of the same texts in POV-Ray 3.7, which widens its boxes by 2e-5.
TEST(Text, WidthsAreThoseOfPovRay) {
  ASSERT_TRUE(std::filesystem::exists(kSans)) << "the tests need fonts-dejavu-core";
  EXPECT_NEAR(bounds_of(kSans, "A").max.x, 0.667986, 1e-4);
  EXPECT_NEAR(bounds_of(kSans, "AV").max.x, 1.288103, 1e-4);
  EXPECT_NEAR(bounds_of(kSans, "To").max.x, 1.000994, 1e-4);
  EXPECT_NEAR(bounds_of(kSans, "oo").max.x, 1.113787, 1e-4);
  EXPECT_NEAR(bounds_of(kSans, "fi").max.y, 0.759775, 1e-4);
}

TEST(Text, WidthsInPovRaysOwnFontAreThoseOfPovRay) {
  ASSERT_TRUE(std::filesystem::exists(kTimes)) << "the tests need povray-includes";
  EXPECT_NEAR(bounds_of(kTimes, "A").max.x, 0.736, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "V").max.x, 0.721, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "AV").max.x, 1.278, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "VA").max.x, 1.316, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "Ag").max.x, 1.203, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "Ag").min.y, -0.212, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "A g").max.x, 1.472, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "gA").max.x, 1.215, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "gA", {0.1, 0, 0}).max.x, 1.315, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "gAg", {0.1, 0.2, 0}).max.x, 1.882, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, " g").max.x, 0.728, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "AVAV").max.x, 2.415, 1e-4);
  EXPECT_NEAR(bounds_of(kTimes, "gggggggggggg").max.x, 5.954, 1e-4);
}

TEST(Text, HolesInLettersAreHoles) {
  ASSERT_TRUE(std::filesystem::exists(kSans)) << "the tests need fonts-dejavu-core";
  Text text;
  text.font = kSans;
  text.text = "o";
  text.thickness = -2;
  const ShapePtr shape = prepare(text).value();
  const Vec3 middle = shape->bounds().center();
  EXPECT_EQ(middle.z, -1);
  EXPECT_FALSE(shape->contains(middle));
  Crossings out;
  shape->crossings({middle - Vec3{5, 0, 0}, {1, 0, 0}}, Interval::all(), out);
  EXPECT_EQ(out.size(), 4u);
  out.clear();
  shape->crossings({{middle.x, shape->bounds().max.y - 0.02, -9}, {0, 0, 1}}, Interval::all(), out);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].t, 7);
  EXPECT_EQ(out[1].t, 9);
}

TEST(Text, NothingToShowIsAnEmptyShape) {
  ASSERT_TRUE(std::filesystem::exists(kSans)) << "the tests need fonts-dejavu-core";
  EXPECT_TRUE(bounds_of(kSans, "").empty());
  EXPECT_TRUE(bounds_of(kSans, "  ").empty());
}

TEST(Text, DamagedFontsAreRefusedOrReadButNeverCrash) {
  ASSERT_TRUE(std::filesystem::exists(kSans)) << "the tests need fonts-dejavu-core";
  std::ifstream in(kSans, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const std::string path = testing::TempDir() + "damaged.ttf";
  Text text;
  text.font = path;
  text.text = "Dioptre";
  const auto attempt = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    return prepare(text).has_value();
  };
  EXPECT_FALSE(attempt("this is a text file"));
  EXPECT_FALSE(attempt(""));
  EXPECT_FALSE(attempt(whole.substr(0, 2048)));
  for (std::size_t at = 4; at < 400; at += 13) {
    std::string damaged = whole;
    for (std::size_t i = at; i < at + 8; ++i) damaged[i] = static_cast<char>(0xff - damaged[i]);
    attempt(damaged);
  }
  std::filesystem::remove(path);
  EXPECT_EQ(prepare(text).error().message, "cannot read the font '" + path + "'");
}

TEST(Text, Utf8IsDecodedAndBadBytesAreReplaced) {
  EXPECT_EQ(decode_utf8("a\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80"),
            (std::vector<char32_t>{'a', 0xe9, 0x20ac, 0x1f600}));
  EXPECT_EQ(decode_utf8("\xff\xc0\xaf\xe2\x82"),
            (std::vector<char32_t>{0xfffd, 0xfffd, 0xfffd, 0xfffd, 0xfffd}));
  EXPECT_EQ(decode_utf8("\xed\xa0\x80"), (std::vector<char32_t>{0xfffd, 0xfffd, 0xfffd}));
}

}  // namespace
}  // namespace dioptre
