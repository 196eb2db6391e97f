// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "dioptre/io/image/read_image.h"
#include "dioptre/scene/json.h"

namespace dioptre::app {
namespace {

namespace fs = std::filesystem;

class Program : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("dioptre_app_" + std::to_string(::getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
    put("povray.ini", "Width=16\nHeight=12\n");
    put("scene.json", write_json(Scene{}));
  }
  void TearDown() override { fs::remove_all(folder_); }

  void put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream in(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  /// The exit code of the program in the test's folder.
  int run(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.string() +
                                "' && env -u POVINI " DIOPTRE_PROGRAM " " + arguments +
                                " 2> messages";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  bool exists(const std::string& name) const { return fs::exists(folder_ / name); }

  fs::path folder_;
};

TEST_F(Program, ExitCodesSayWhatHappened) {
  EXPECT_EQ(run("scene.json"), 0);
  EXPECT_EQ(run("--version > out"), 0);
  EXPECT_EQ(run("--help > out"), 0);
  EXPECT_EQ(run("scene.json --help > out"), 0);
  EXPECT_EQ(run(""), 1);
  EXPECT_EQ(run("missing.json"), 1);
  EXPECT_EQ(run("scene.json +Z99"), 1);
  EXPECT_EQ(run("scene.json Widht=3"), 1);
  EXPECT_EQ(run("scene.json +W1000000000 +H1000000000"), 1);
  EXPECT_EQ(run("scene.json +Onone/x.png"), 1);
  EXPECT_EQ(run("scene.json --colour 3"), 64);
  EXPECT_EQ(run("scene.json --size 3"), 64);
}

TEST_F(Program, TheImageIsNamedAndSizedAsAsked) {
  ASSERT_EQ(run("+Iscene.json +H5"), 0);
  const auto image = read_image((folder_ / "scene.png").string(), {});
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->width, 16u);
  EXPECT_EQ(image->height, 5u);
  ASSERT_EQ(run("scene.json +FP -o other"), 0);
  EXPECT_TRUE(exists("other.ppm"));
  ASSERT_EQ(run("scene.json -F -o nothing.png"), 0);
  EXPECT_FALSE(exists("nothing.png"));
}

TEST_F(Program, AnAnimationNumbersItsFrames) {
  ASSERT_EQ(run("scene.json +KFF12 +SF9 +EF11"), 0);
  for (const char* name : {"scene09.png", "scene10.png", "scene11.png"}) EXPECT_TRUE(exists(name));
  EXPECT_FALSE(exists("scene12.png"));
}

TEST_F(Program, TheImageGoesToTheStandardOutput) {
  ASSERT_EQ(run("scene.json +FP +O- > out.ppm"), 0);
  EXPECT_TRUE(read_image((folder_ / "out.ppm").string(), {}));
}

TEST_F(Program, PolygonsKeepTheirTestUnlessAnotherIsNamed) {
  Polygon polygon;
  polygon.outlines = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  polygon.test = PolygonTest::kAngles;
  Scene scene;
  scene.objects.emplace_back().geometry = ShapeData(polygon);
  put("angles.json", write_json(scene));
  ASSERT_EQ(run("dump angles.json > kept.json"), 0);
  ASSERT_EQ(run("dump angles.json --polygon-test crossings > changed.json"), 0);
  EXPECT_EQ(read("kept.json"), write_json(scene));
  std::get<Polygon>(std::get<ShapeData>(scene.objects[0].geometry)).test = PolygonTest::kCrossings;
  EXPECT_EQ(read("changed.json"), write_json(scene));
}

TEST_F(Program, ADumpIsTheSameScene) {
  ASSERT_EQ(run("dump scene.json > again.json"), 0);
  EXPECT_EQ(read("again.json"), write_json(Scene{}));
}

}  // namespace
}  // namespace dioptre::app
