// SPDX-License-Identifier: MIT
#include <lightcuts/render/files/file_access.h>

#include <gtest/gtest.h>

#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>

namespace lightcuts {
namespace {

class FileAccessOfAScene : public testing::Test {
protected:
  FileAccessOfAScene() {
    std::filesystem::create_directories(scene_ / "sub");
    write(folder_.path / "secret.txt", "x");
    write(scene_ / "a.txt", "x");
  }

  TemporaryFolder folder_;
  std::filesystem::path scene_ = folder_.path / "scene";
};

TEST_F(FileAccessOfAScene, is_to_its_folder_and_what_is_below) {
  const FileAccess access(scene_ / "s.json");
  for (const char* inside : {"a.txt", "sub/b.txt", "sub/../a.txt", "./a.txt", "not there.txt"})
    EXPECT_TRUE(access.allows(scene_ / inside)) << inside;
  for (const char* outside : {"../secret.txt", "sub/../../secret.txt", "../scene2/a.txt", ".."})
    EXPECT_FALSE(access.allows(scene_ / outside)) << outside;
  EXPECT_FALSE(access.allows("/etc/passwd"));
  EXPECT_FALSE(access.allows(folder_.path / "scene2"));
}

TEST_F(FileAccessOfAScene, follows_links) {
  std::filesystem::create_symlink(folder_.path / "secret.txt", scene_ / "link.txt");
  std::filesystem::create_symlink("a.txt", scene_ / "inner.txt");
  std::filesystem::create_directory_symlink(folder_.path, scene_ / "up");
  const FileAccess access(scene_ / "s.json");
  EXPECT_FALSE(access.allows(scene_ / "link.txt"));
  EXPECT_FALSE(access.allows(scene_ / "up/secret.txt"));
  EXPECT_TRUE(access.allows(scene_ / "inner.txt"));
  EXPECT_TRUE(access.allows(scene_ / "up/scene/a.txt"));
}

TEST_F(FileAccessOfAScene, that_is_itself_named_by_a_link_is_to_where_it_was_named) {
  std::filesystem::create_directory_symlink(scene_, folder_.path / "alias");
  const FileAccess access(folder_.path / "alias/s.json");
  EXPECT_TRUE(access.allows(folder_.path / "alias/a.txt"));
  EXPECT_TRUE(access.allows(scene_ / "a.txt"));
  EXPECT_FALSE(access.allows(folder_.path / "secret.txt"));
}

TEST_F(FileAccessOfAScene, is_to_everything_where_that_is_allowed) {
  const FileAccess access(scene_ / "s.json", true);
  EXPECT_TRUE(access.allows("/etc/passwd"));
  EXPECT_NO_THROW(access.require("/etc/passwd", "it"));
}

TEST_F(FileAccessOfAScene, says_what_it_refuses) {
  const FileAccess access(scene_ / "s.json");
  expect_refusal("s.json: '../secret.txt': lies outside the scene's folder; --allow-outside",
                 [&] { access.require(scene_ / "../secret.txt", "s.json: '../secret.txt'"); });
}

} // namespace
} // namespace lightcuts
