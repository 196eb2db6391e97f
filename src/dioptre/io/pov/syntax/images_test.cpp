// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "dioptre/io/image/palette_samples_test.h"
#include "dioptre/io/pov/syntax/syntax_test_support.h"

namespace dioptre::pov {
namespace {

namespace fs = std::filesystem;

class Images : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("dioptre_images_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    put("grey.pgm", "P5\n2 1\n255\n\x40\xc0");
    put("p.gif", palette_gif());
  }
  void TearDown() override { fs::remove_all(folder_); }

  void put(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  LoadOptions options() const {
    LoadOptions options;
    options.search_folders.push_back(folder_.string());
    return options;
  }
  /// The images of a scene that has one sphere for each pigment.
  std::vector<ImageSource> images_of(const std::vector<std::string>& pigments,
                                     const std::string& settings = "") const {
    std::string program = "#version 3.7;\n" + settings + "\n";
    for (const std::string& p : pigments) program += "sphere { 0, 1 pigment { " + p + " } }\n";
    Diagnostics diagnostics;
    NoQueries queries;
    auto loaded = load_pov_text("t.pov", program, options(), queries, diagnostics);
    if (loaded) return std::move(loaded->scene.images);
    ADD_FAILURE() << said(program, options());
    return std::vector<ImageSource>(pigments.size());
  }

  fs::path folder_;
};

TEST_F(Images, AFileIsDecodedOnceForEachWayToReadIt) {
  const std::string plain = "image_map { gif \"p.gif\" }";
  const std::string other = "image_map { gif \"p.gif\" gamma 3 }";
  const std::string old = "#version 3.5; " + plain;
  const auto images = images_of({other, plain, other, plain, old});
  ASSERT_EQ(images.size(), 5u);
  const auto pixels = [&](std::size_t i) { return &*images[i].data; };
  EXPECT_EQ(pixels(0), pixels(2));
  EXPECT_EQ(pixels(1), pixels(3));
  EXPECT_NE(*images[0].data, *images[1].data);
  EXPECT_NE(*images[0].data, *images[4].data);
  EXPECT_NE(*images[1].data, *images[4].data);
}

TEST_F(Images, NamesMayLackTheEndingOfTheirFormat) {
  const std::pair<const char*, std::vector<const char*>> endings[] = {
      {"jpeg", {"jpg", "JPG", "jpeg"}},
      {"tiff", {"tif", "tiff"}},
      {"png", {"png", "PNG"}},
      {"gif", {"gif"}},
      {"tga", {"tga"}},
      {"bmp", {"bmp"}},
      {"ppm", {"ppm"}},
      {"pgm", {"pgm"}},
      {"hdr", {"hdr"}},
      {"exr", {"exr"}}};
  for (const auto& [format, names] : endings) {
    for (const std::string ending : names) {
      put("sign." + ending, palette_gif());
      const auto images = images_of({"image_map { " + std::string(format) + " \"sign\" }"});
      EXPECT_EQ(images.at(0).data->width, 8u) << ending;
      fs::remove(folder_ / ("sign." + ending));
    }
  }
  put("sign.gif", palette_gif());
  for (const std::string format : {"", "sys", "png"}) {
    EXPECT_NE(said("sphere { 0, 1 pigment { image_map { " + format + " \"sign\" } } }", options())
                  .find("cannot find the file 'sign'"),
              std::string::npos)
        << format;
  }
}

TEST_F(Images, TheLastTransmitOfAColorCounts) {
  const auto alphas = [&](const std::string& transmits) {
    const auto images = images_of({"image_map { gif \"p.gif\" " + transmits + " }"});
    const ImageData& data = *images.at(0).data;
    std::vector<float> of_entries(8, -1);
    for (std::size_t i = 0; data.channels == 4 && i < 8; ++i) {
      of_entries[static_cast<std::size_t>(kPaletteNumbers[i])] = data.pixels[4 * i + 3];
    }
    return std::pair(of_entries, images.at(0).transmit_all);
  };
  using Alphas = std::pair<std::vector<float>, double>;
  EXPECT_EQ(alphas("transmit 1, 0.5 transmit 7, 1 transmit 1.9, 0.25"),
            (Alphas{{1, 0.75f, 1, 1, 1, 1, 1, 0}, 0}));
  EXPECT_EQ(alphas("transmit all 0.5 transmit 1, 0"),
            (Alphas{{0.5f, 1, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f}, 0}));
  EXPECT_EQ(alphas("transmit 1, 0 transmit all 0.5"), (Alphas{std::vector<float>(8, -1), 0.5}));
}

TEST_F(Images, FiltersOfSingleColorsAreAFifthChannel) {
  const auto filters = [&](const std::string& given) {
    const auto images = images_of({"image_map { gif \"p.gif\" " + given + " }"});
    const ImageData& data = *images.at(0).data;
    std::vector<float> of_entries(8, -1);
    for (std::size_t i = 0; data.channels == 5 && i < 8; ++i) {
      of_entries[static_cast<std::size_t>(kPaletteNumbers[i])] = data.pixels[5 * i + 4];
    }
    return std::pair(of_entries, images.at(0).filter_all);
  };
  using Filters = std::pair<std::vector<float>, double>;
  EXPECT_EQ(filters("filter 1, 0.5 filter 7, 1"), (Filters{{0, 0.5f, 0, 0, 0, 0, 0, 1}, 0}));
  EXPECT_EQ(filters("filter all 0.5 filter 1, 0"),
            (Filters{{0.5f, 0, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f}, 0}));
  EXPECT_EQ(filters("filter 1, 0 filter all 0.5"), (Filters{std::vector<float>(8, -1), 0.5}));
}

TEST_F(Images, LightIsGivenInTheValuesOfTheScene) {
  const auto first = [&](const std::string& settings, const std::string& modifiers) {
    const auto images = images_of({"image_map { gif \"p.gif\" " + modifiers + " }"}, settings);
    return (*images.at(0).data).pixels[0];
  };
  const float light = first("global_settings { assumed_gamma 1 }", "gamma 2");
  const float value = first("global_settings { assumed_gamma 2 }", "gamma 2");
  EXPECT_FLOAT_EQ(value * value, light);
}

TEST_F(Images, WrongTransmitsAreErrors) {
  const auto message = [&](const std::string& image) {
    return said("sphere { 0, 1 pigment { image_map { " + image + " } } }", options());
  };
  for (const std::string number : {"256", "-1", "1e300"}) {
    EXPECT_NE(message("gif \"p.gif\" transmit " + number + ", 1").find("colours 0 to 255"),
              std::string::npos)
        << number;
  }
  EXPECT_NE(message("pgm \"grey.pgm\" transmit 1, 1").find("no palette"), std::string::npos);
}

}  // namespace
}  // namespace dioptre::pov
