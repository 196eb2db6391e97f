// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

#include "dioptre/io/image/palette_samples_test.h"
#include "dioptre/io/image/read_image.h"
#include "dioptre/io/image/write_image.h"

namespace dioptre {
namespace {

namespace fs = std::filesystem;

class ImageFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("dioptre_image_" + std::to_string(::getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string put(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  static std::string bytes_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  fs::path folder_;
};

EncodedImage ramp(std::uint32_t channels, std::uint32_t bits) {
  EncodedImage image;
  image.width = 5;
  image.height = 3;
  image.channels = channels;
  image.bits = bits;
  for (std::uint32_t k = 0; k < 15 * channels; ++k) {
    image.values.push_back(static_cast<std::uint16_t>((k * 977 + 5) & ((1u << bits) - 1)));
  }
  return image;
}

TEST_F(ImageFiles, WhatIsWrittenWithoutLossIsReadBackExactly) {
  struct Case {
    ImageFormat format;
    const char* name;
    std::uint32_t channels, bits;
  };
  const Case cases[] = {
      {ImageFormat::kPng, "a.png", 3, 8},  {ImageFormat::kPng, "a.png", 4, 8},
      {ImageFormat::kPng, "a.png", 3, 16}, {ImageFormat::kPng, "a.png", 4, 16},
      {ImageFormat::kPng, "a.png", 1, 16}, {ImageFormat::kPng, "a.png", 2, 8},
      {ImageFormat::kPpm, "a.ppm", 3, 8},  {ImageFormat::kPpm, "a.ppm", 3, 16},
      {ImageFormat::kPpm, "a.ppm", 3, 5},  {ImageFormat::kTga, "a.tga", 3, 8},
      {ImageFormat::kTga, "a.tga", 4, 8},  {ImageFormat::kBmp, "a.bmp", 3, 8},
  };
  for (const Case& c : cases) {
    const EncodedImage image = ramp(c.channels, c.bits);
    ASSERT_TRUE(write_image(path(c.name), image, c.format));
    const auto read = read_image(path(c.name), {.gamma = 1.0});
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->width, 5u);
    ASSERT_EQ(read->height, 3u);
    ASSERT_EQ(read->channels, c.channels);
    for (std::size_t k = 0; k < image.values.size(); ++k) {
      EXPECT_NEAR(read->pixels[k], image.values[k] / ((1 << c.bits) - 1.0), 1e-7) << c.name;
    }
  }
}

TEST_F(ImageFiles, FloatFilesKeepLight) {
  Image image(3, 2);
  for (std::size_t k = 0; k < 6; ++k) image.pixels[k] = {0.001f * k, 1.0f * k, 1000.0f * k};
  ASSERT_TRUE(write_exr(path("a.exr"), image, false));
  ASSERT_TRUE(write_exr(path("h.exr"), image, true));
  ASSERT_TRUE(write_hdr(path("a.hdr"), image));
  for (const auto& [name, error] :
       {std::pair("a.exr", 0.0), std::pair("h.exr", 1e-3), std::pair("a.hdr", 1.0 / 128)}) {
    const auto read = read_image(path(name), {});
    ASSERT_TRUE(read) << read.error().message;
    for (std::size_t k = 0; k < 6; ++k) {
      const double top = 1000.0 * k;
      EXPECT_NEAR(read->pixels[3 * k + 2], top, top * error) << name;
    }
  }
}

/// A PNG of four pixels, entries 3, 2, 1, 0 of the palette red, green, blue, white; two bits each.
constexpr unsigned char kPalettePng[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x04, 0x00, 0x00, 0x00, 0x01, 0x02, 0x03, 0x00, 0x00, 0x00, 0x84, 0x52, 0xe7,
    0x5e, 0x00, 0x00, 0x00, 0x0c, 0x50, 0x4c, 0x54, 0x45, 0xff, 0x00, 0x00, 0x00, 0xff, 0x00, 0x00,
    0x00, 0xff, 0xff, 0xff, 0xff, 0xfb, 0x00, 0x60, 0xf6, 0x00, 0x00, 0x00, 0x0a, 0x49, 0x44, 0x41,
    0x54, 0x78, 0x9c, 0x63, 0x78, 0x02, 0x00, 0x00, 0xe6, 0x00, 0xe5, 0x58, 0xda, 0x89, 0xce, 0x00,
    0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

TEST_F(ImageFiles, APaletteGivesItsNumbersOrItsColors) {
  const std::string file =
      put("p.png", {reinterpret_cast<const char*>(kPalettePng), sizeof kPalettePng});
  for (const float scale : {1.0f, 0.5f}) {
    for (const std::optional<double> gamma : {std::optional<double>{}, std::optional(2.2)}) {
      const auto numbers = read_image(file, {.gamma = gamma, .palette_scale = scale});
      ASSERT_TRUE(numbers) << numbers.error().message;
      EXPECT_EQ(numbers->channels, 1u);
      EXPECT_EQ(numbers->pixels, (std::vector<float>{3 * scale, 2 * scale, scale, 0}));
    }
  }
  const auto colors = read_image(file, {});
  ASSERT_TRUE(colors) << colors.error().message;
  EXPECT_EQ(colors->channels, 3u);
  EXPECT_EQ(colors->pixels, (std::vector<float>{1, 1, 1, 0, 0, 1, 0, 1, 0, 1, 0, 0}));
}

TEST_F(ImageFiles, PalettesOfAllFormatsGiveTheirNumbersOrTheirColors) {
  for (const auto& [name, bytes] : palette_files()) {
    const std::string file = put(name, bytes);
    const auto numbers = read_image(file, {.palette_scale = 1});
    ASSERT_TRUE(numbers) << numbers.error().message;
    EXPECT_EQ(numbers->width, 8u) << name;
    EXPECT_EQ(numbers->channels, 1u) << name;
    EXPECT_EQ(numbers->pixels, kPaletteNumbers) << name;
    const auto colors = read_image(file, {.gamma = 1});
    ASSERT_TRUE(colors) << colors.error().message;
    for (std::size_t i = 0; i < kPaletteNumbers.size(); ++i) {
      const auto& color = kPalette[static_cast<std::size_t>(kPaletteNumbers[i])];
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_FLOAT_EQ(colors->pixels[i * colors->channels + k], color[k] / 255.0f) << name;
      }
    }
  }
}

TEST_F(ImageFiles, EntriesOfPalettesLetLightThroughAsAsked) {
  for (const auto& [name, bytes] : palette_files()) {
    const ReadImageOptions options{.entry_transmits = {{2, 0.5f}, {7, 1}, {2, 0.25f}}};
    const auto image = read_image(put(name, bytes), options);
    ASSERT_TRUE(image) << image.error().message;
    ASSERT_EQ(image->channels, 4u) << name;
    for (std::size_t i = 0; i < kPaletteNumbers.size(); ++i) {
      const float number = kPaletteNumbers[i];
      EXPECT_EQ(image->pixels[4 * i + 3], number == 2 ? 0.75f : number == 7 ? 0.0f : 1.0f) << name;
    }
  }
  const auto none = read_image(put("a.pgm", "P5\n1 1\n255\n\x01"), {.entry_transmits = {{0, 1}}});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("no palette"), std::string::npos);
}

TEST_F(ImageFiles, DamagedPalettesAreNoHarm) {
  for (const auto& [name, whole] : palette_files()) {
    for (std::size_t at = 0; at < whole.size(); ++at) {
      std::string damaged = whole;
      for (const int change : {0x01, 0x80, 0xff}) {
        damaged[at] = static_cast<char>(whole[at] ^ change);
        const auto read = read_image(put(name, damaged), {.palette_scale = 1, .max_pixels = 1000});
        static_cast<void>(read);  // any answer but a crash
      }
      EXPECT_FALSE(read_image(put(name, whole.substr(0, at)), {.palette_scale = 1}) &&
                   at < whole.size() / 2)
          << name << " cut to " << at;
    }
  }
}

TEST_F(ImageFiles, AJpegComesNear) {
  EncodedImage image = ramp(3, 8);
  for (auto& v : image.values) v = 188;
  ASSERT_TRUE(write_image(path("a.jpg"), image, ImageFormat::kJpeg));
  const auto read = read_image(path("a.jpg"), {});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NEAR(read->pixels[0], 0.503, 0.01);
}

TEST_F(ImageFiles, GammaFollowsTheFileTheFormatAndTheLanguage) {
  EncodedImage image = ramp(3, 8);
  for (auto& v : image.values) v = 128;
  const double value = 128 / 255.0, srgb = 0.2158605;
  image.gamma_known = false;
  ASSERT_TRUE(write_image(path("plain.png"), image, ImageFormat::kPng));
  EXPECT_NEAR(read_image(path("plain.png"), {})->pixels[0], srgb, 1e-5);
  EXPECT_NEAR(read_image(path("plain.png"), {.language_version = 3.6})->pixels[0], value, 1e-6);
  EXPECT_NEAR(read_image(path("plain.png"), {.gamma = 2.0})->pixels[0], value * value, 1e-6);
  image.gamma_known = true;
  image.gamma = 2;
  ASSERT_TRUE(write_image(path("two.png"), image, ImageFormat::kPng));
  EXPECT_NEAR(read_image(path("two.png"), {})->pixels[0], value * value, 1e-5);
  EXPECT_NEAR(read_image(path("two.png"), {.language_version = 3.6})->pixels[0], value * value,
              1e-5);
  ASSERT_TRUE(write_image(path("a.ppm"), image, ImageFormat::kPpm));
  EXPECT_NEAR(read_image(path("a.ppm"), {})->pixels[0], value, 1e-6);
}

TEST_F(ImageFiles, CutAndDamagedFilesAreErrors) {
  Image light(40, 30);
  for (Color& c : light.pixels) c = {1, 2, 3};
  EncodedImage image;
  image.width = 40, image.height = 30;
  for (std::uint32_t k = 0; k < 3600; ++k) image.values.push_back(k * k % 251);
  ASSERT_TRUE(write_image(path("a.png"), image, ImageFormat::kPng));
  ASSERT_TRUE(write_image(path("a.ppm"), image, ImageFormat::kPpm));
  ASSERT_TRUE(write_image(path("a.jpg"), image, ImageFormat::kJpeg));
  ASSERT_TRUE(write_image(path("a.tga"), image, ImageFormat::kTga));
  ASSERT_TRUE(write_image(path("a.bmp"), image, ImageFormat::kBmp));
  ASSERT_TRUE(write_exr(path("a.exr"), light, true));
  ASSERT_TRUE(write_hdr(path("a.hdr"), light));
  for (const char* name : {"a.png", "a.ppm", "a.jpg", "a.tga", "a.bmp", "a.exr", "a.hdr"}) {
    const std::string whole = bytes_of(path(name));
    for (std::size_t part = 0; part < 20; ++part) {
      const std::string cut =
          put("cut" + std::string(name + 1), whole.substr(0, whole.size() * part / 20));
      EXPECT_FALSE(read_image(cut, {})) << name << " cut to " << part << "/20";
    }
    for (std::size_t at = 0; at < std::min<std::size_t>(whole.size(), 200); ++at) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (0x41 + at));
      const auto read = read_image(put("bad" + std::string(name + 1), damaged), {});
      static_cast<void>(read);  // any answer but a crash
    }
  }
}

TEST_F(ImageFiles, HostileFilesAreErrors) {
  using namespace std::string_literals;
  const std::pair<const char*, std::string> files[] = {
      {"empty.png", ""},
      {"text.png", "root:x:0:0"},
      {"zero.png", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\0\0\0\0\0\x08\2\0\0\0"s},
      {"header.gif", "GIF89a\1\0\1\0"s},
      {"huge.gif", "GIF89a\xff\xff\xff\xff\x80\0\0"s},
      {"top.tga", std::string(18, '\xff')},
      {"cut.tga", "\0\0\x0a\0\0\0\0\0\0\0\0\0\xff\xff\xff\xff\x18\0\1"s},
      {"huge.ppm", "P6 99999999 99999999 255\n"},
      {"negative.ppm", "P6 -5 7 255\n"},
      {"cut.hdr", "#?RADIANCE\n\n-Y 1000 +X 1000\n"},
      {"negative.hdr", "#?RADIANCE\n\n-Y -5 +X 1000000000\n"},
      {"rle.hdr", "#?RADIANCE\n\n-Y 1 +X 100\n\2\2\0\x64\xff\1\xff\1"s},
      {"garbage.exr", "\x76\x2f\x31\x01garbage garbage garbage"s},
      {"loop.tif", "II*\0\x08\0\0\0\0\0\x08\0\0\0"s},
      {"garbage.tif", "MM\0*\xff\xff\xff\xff"s},
  };
  for (const auto& [name, bytes] : files) {
    const auto read = read_image(put(name, bytes), {});
    ASSERT_FALSE(read) << name;
    EXPECT_EQ(read.error().message.find("root"), std::string::npos);
    EXPECT_NE(read.error().message.find(name), std::string::npos);
  }
  EXPECT_FALSE(read_image(path("missing.png"), {}));
  EXPECT_FALSE(read_image(folder_.string(), {}));
  EXPECT_FALSE(read_image("/dev/zero", {}));
}

TEST_F(ImageFiles, FailureLeavesTheOldFileAndNothingNew) {
  put("kept.png", "old");
  EncodedImage empty;
  EXPECT_FALSE(write_image(path("kept.png"), empty, ImageFormat::kPng));
  EXPECT_EQ(bytes_of(path("kept.png")), "old");
  EXPECT_FALSE(write_file(path("none/x.png"), "new"));
  EXPECT_FALSE(write_file(folder_.string(), "new"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(ImageFiles, AKillDuringTheWriteLeavesAWholeFile) {
  const std::string old_bytes(4 << 20, 'o'), new_bytes(4 << 20, 'n');
  for (int delay = 0; delay < 8; ++delay) {
    put("kept", old_bytes);
    const pid_t child = ::fork();
    if (child == 0) {
      for (;;) static_cast<void>(write_file(path("kept"), new_bytes));
    }
    ::usleep(static_cast<useconds_t>(delay * 900));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string now = bytes_of(path("kept"));
    EXPECT_TRUE(now == old_bytes || now == new_bytes);
  }
}

}  // namespace
}  // namespace dioptre
