// SPDX-License-Identifier: MIT
#include <lightcuts/render/files/text.h>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>

namespace lightcuts {
namespace {

TEST(Counted, IsPluralButOfOne) {
  EXPECT_EQ(counted(0, "light"), "0 lights");
  EXPECT_EQ(counted(1, "light"), "1 light");
  EXPECT_EQ(counted(1'000'000, "light"), "1000000 lights");
}

TEST(ReadFile, refuses_what_may_never_end) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder.path / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder.path / "zero");
  for (const char* name : {"pipe", "zero"})
    expect_refusal(std::string(name) + ": cannot open: a device or a pipe, not a file",
                   [&] { (void)read_file(folder.path / name); });
  expect_refusal("absent: cannot open", [&] { (void)read_file(folder.path / "absent"); });
  expect_refusal(": cannot open", [&] { (void)read_file(folder.path); });
}

// Files of /proc say that they are empty.
TEST(ReadFile, reads_to_the_end) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  write(folder.path / "file", bytes);
  EXPECT_EQ(read_file(folder.path / "file"), bytes);
  EXPECT_NE(read_file("/proc/self/status"), "");
}

TEST(ReadText, leaves_out_the_mark_of_utf_8_and_refuses_utf_16) {
  const TemporaryFolder folder;
  const auto text = [&](const std::string& bytes) {
    write(folder.path / "file", bytes);
    return read_text(folder.path / "file");
  };
  EXPECT_EQ(text("\xef\xbb\xbfv 1"), "v 1");
  EXPECT_EQ(text(""), "");
  using namespace std::string_literals;
  for (const std::string& bytes :
       {"\xff\xfev\0 \0"s, "\xfe\xff\0v"s, "v\0 \0"s, "\0v\0 "s, "v\0\0\0"s})
    expect_refusal("is UTF-16 or UTF-32; save it as UTF-8", [&] { (void)text(bytes); });
}

} // namespace
} // namespace lightcuts
