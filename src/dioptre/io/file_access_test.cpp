// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/file_access.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace dioptre {
namespace {

namespace fs = std::filesystem;

/// A folder with scene/, library/ and secret/ in it, gone after the test.
class FileAccessTest : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("dioptre_access_" + std::to_string(getpid()));
    for (const char* folder : {"scene/sub", "library", "secret"}) {
      fs::create_directories(root_ / folder);
    }
    for (const char* file : {"scene/a.pov", "scene/sub/b.inc", "library/c.inc", "secret/d.inc"}) {
      std::ofstream(root_ / file) << file;
    }
    fs::create_symlink(root_ / "secret/d.inc", root_ / "scene/link.inc");
    options_.scene_folder = root_ / "scene";
    options_.scene_file = root_ / "scene/a.pov";
    options_.search_folders = {root_ / "library"};
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path root_;
  FileAccess::Options options_;
};

TEST_F(FileAccessTest, FindsAlongTheSearchPathInAnyCase) {
  const FileAccess access(options_);
  EXPECT_TRUE(access.find("sub/b.inc"));
  EXPECT_TRUE(access.find("c.inc"));
  const auto other = access.find("SUB/B.INC");
  ASSERT_TRUE(other);
  EXPECT_TRUE(other->other_case);
  EXPECT_FALSE(access.find("nothing.inc"));
  EXPECT_FALSE(access.find(""));
}

TEST_F(FileAccessTest, LeadsOutOfTheFoldersOnlyWhereThatIsAllowed) {
  for (const std::string& name : {std::string("../secret/d.inc"), std::string("link.inc"),
                                  (root_ / "secret/d.inc").string()}) {
    EXPECT_FALSE(FileAccess(options_).find(name)) << name;
    FileAccess::Options open = options_;
    open.readable_paths = {root_ / "secret"};
    EXPECT_TRUE(FileAccess(open).find(name)) << name;
  }
}

TEST_F(FileAccessTest, FollowsTheLinksOfALibraryButNotNamesThatLeaveIt) {
  std::filesystem::create_symlink(root_ / "secret/d.inc", root_ / "library/font.ttf");
  const FileAccess access(options_);
  EXPECT_TRUE(access.find("font.ttf"));
  EXPECT_FALSE(access.find((root_ / "library/../secret/d.inc").string()));
}

TEST_F(FileAccessTest, WritesBelowTheSceneButNeverAScene) {
  const FileAccess access(options_);
  EXPECT_TRUE(access.writable(root_ / "scene/sub/new.txt"));
  EXPECT_FALSE(access.writable(root_ / "scene/a.pov"));
  EXPECT_FALSE(access.writable(root_ / "scene/../secret/x.txt"));
  EXPECT_FALSE(access.writable(root_ / "scene/link.inc"));
  EXPECT_FALSE(access.writable(root_ / "library/x.txt"));
}

TEST_F(FileAccessTest, WritesNothingThatOtherProgramsWouldObey) {
  const FileAccess access(options_);
  fs::create_symlink(root_ / "secret/new.txt", root_ / "scene/dangling.txt");
  for (const char* name : {".profile", "sub/.git/config", "povray.INI", "dangling.txt", "sub"}) {
    EXPECT_FALSE(access.writable(root_ / "scene" / name)) << name;
  }
  EXPECT_TRUE(access.writable(root_ / "scene/data.v2.txt"));
}

TEST_F(FileAccessTest, ReadsFilesOnlyAndOnlyAsLongAsAllowed) {
  const FileAccess access(options_);
  EXPECT_EQ(access.read(root_ / "scene/a.pov", 100).value(), "scene/a.pov");
  EXPECT_FALSE(access.read(root_ / "scene/a.pov", 5));
  EXPECT_FALSE(access.read(root_ / "scene", 100));
  EXPECT_FALSE(access.read("/dev/zero", 100));
}

}  // namespace
}  // namespace dioptre
