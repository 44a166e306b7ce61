// SPDX-License-Identifier: MIT
#include <lightcuts/render/files/output_folder.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <sys/stat.h>
#include <unistd.h>

#include <tests/render/support/temporary_folder.h>

namespace lightcuts {
namespace {

namespace fs = std::filesystem;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(OutputFolder, appears_with_all_files_on_commit) {
  const TemporaryFolder home;
  const fs::path out = home.path / "out";
  {
    OutputFolder folder(out);
    write(folder.stage("a"), "1");
    write(folder.stage("b"), "2");
    EXPECT_FALSE(fs::exists(out));
    folder.commit();
    EXPECT_EQ(content_of(out / "a"), "1");
  }
  EXPECT_EQ(content_of(out / "b"), "2");
  EXPECT_EQ(entries(home.path), 1U);
  EXPECT_EQ(entries(out), 2U);
}

TEST(OutputFolder, leaves_nothing_without_commit) {
  const TemporaryFolder home;
  {
    OutputFolder folder(home.path / "x/y/out/");
    write(folder.stage("a"), "1");
    EXPECT_EQ(entries(home.path), 1U);
  }
  EXPECT_EQ(entries(home.path), 0U);
}

TEST(OutputFolder, keeps_old_files_without_commit) {
  const TemporaryFolder home;
  write(home.path / "a", "old");
  {
    OutputFolder folder(home.path);
    write(folder.stage("a"), "new");
    EXPECT_EQ(content_of(home.path / "a"), "old");
  }
  EXPECT_EQ(content_of(home.path / "a"), "old");
  EXPECT_EQ(entries(home.path), 1U);
}

TEST(OutputFolder, replaces_files_of_the_same_name_only) {
  const TemporaryFolder home;
  write(home.path / "a", "old");
  write(home.path / "b", "mine");
  OutputFolder folder(home.path);
  write(folder.stage("a"), "new");
  folder.commit();
  EXPECT_EQ(content_of(home.path / "a"), "new");
  EXPECT_EQ(content_of(home.path / "b"), "mine");
  EXPECT_EQ(entries(home.path), 2U);
}

TEST(OutputFolder, makes_missing_parents) {
  const TemporaryFolder home;
  OutputFolder folder(home.path / "x/./y/../z/out");
  write(folder.stage("a"), "1");
  folder.commit();
  EXPECT_EQ(content_of(home.path / "x/z/out/a"), "1");
}

TEST(OutputFolder, stages_a_name_once) {
  const TemporaryFolder home;
  OutputFolder folder(home.path / "out");
  EXPECT_EQ(folder.stage("a"), folder.stage("a"));
  EXPECT_EQ(folder.stage("a.exr").extension(), ".exr");
}

TEST(OutputFolder, can_be_used_twice_at_once) {
  const TemporaryFolder home;
  OutputFolder one(home.path / "out"), two(home.path / "out");
  write(one.stage("a"), "1");
  write(two.stage("b"), "2");
  one.commit();
  two.commit();
  EXPECT_EQ(entries(home.path / "out"), 2U);
}

TEST(OutputFolder, refuses_at_once_what_it_cannot_write) {
  const TemporaryFolder home;
  write(home.path / "file", "");
  // Below a file, as permissions mean nothing to root.
  EXPECT_THROW(OutputFolder(home.path / "file/out"), InputError);
  EXPECT_THROW(OutputFolder(home.path / "file/x/out"), InputError);
  EXPECT_THROW(OutputFolder(home.path / "file"), InputError);
  EXPECT_THROW(OutputFolder("/proc/lightcuts/out"), InputError);
  EXPECT_THROW(OutputFolder(""), InputError);
  try {
    OutputFolder(home.path / "file/out");
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault(), InputFault::unwritable_file);
    EXPECT_NE(std::string(error.what()).find("file/out"), std::string::npos) << error.what();
  }
  EXPECT_EQ(entries(home.path), 1U);
}

TEST(OutputFolder, moves_nothing_where_a_file_is_missing_or_in_the_way) {
  const TemporaryFolder home;
  OutputFolder folder(home.path / "out");
  write(folder.stage("a"), "1");
  static_cast<void>(folder.stage("forgotten"));
  EXPECT_THROW(folder.commit(), InputError);
  EXPECT_FALSE(fs::exists(home.path / "out"));

  fs::create_directories(home.path / "taken/b");
  OutputFolder taken(home.path / "taken");
  write(taken.stage("a"), "1");
  write(taken.stage("b"), "2");
  EXPECT_THROW(taken.commit(), InputError);
  EXPECT_FALSE(fs::exists(home.path / "taken/a"));
}

TEST(OutputFolder, refuses_names_with_folders) {
  const TemporaryFolder home;
  OutputFolder folder(home.path / "out");
  for (const char* name : {"", ".", "..", "a/b", "/a", "../a"})
    EXPECT_THROW(static_cast<void>(folder.stage(name)), InputError) << name;
}

TEST(WriteFileAtomically, replaces_the_whole_file) {
  const TemporaryFolder home;
  write(home.path / "a", "a longer old text");
  write_file_atomically(home.path / "a", std::string_view("n\0w", 3));
  EXPECT_EQ(content_of(home.path / "a"), std::string("n\0w", 3));
  EXPECT_EQ(entries(home.path), 1U);
}

TEST(WriteFileAtomically, writes_into_a_pipe) {
  const TemporaryFolder home;
  const fs::path pipe = home.path / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  write_file_atomically(pipe, "x");
  EXPECT_TRUE(fs::is_fifo(pipe));
  char read = 0;
  EXPECT_EQ(::read(reader, &read, 1), 1);
  EXPECT_EQ(read, 'x');
  ::close(reader);
}

TEST(WriteFileAtomically, follows_links) {
  const TemporaryFolder home;
  write(home.path / "a", "old");
  fs::create_symlink("a", home.path / "link");
  write_file_atomically(home.path / "link", "new");
  EXPECT_TRUE(fs::is_symlink(home.path / "link"));
  EXPECT_EQ(content_of(home.path / "a"), "new");
}

TEST(WriteFileAtomically, names_what_it_cannot_write) {
  const TemporaryFolder home;
  write(home.path / "file", "");
  EXPECT_THROW(write_file_atomically(home.path / "file/a", "x"), InputError);
  EXPECT_THROW(write_file_atomically(home.path / "missing/a", "x"), InputError);
  EXPECT_THROW(write_file_atomically(home.path, "x"), InputError);
  EXPECT_EQ(entries(home.path), 1U);
}

} // namespace
} // namespace lightcuts
