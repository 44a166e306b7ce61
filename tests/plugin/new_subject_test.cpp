// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightcuts {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The line that begins so, of what was printed.
std::string line_of(const std::string& text, const std::string& start) {
  const std::size_t at = text.find("\n  " + start);
  return at == text.npos ? "" : text.substr(at + 3, text.find('\n', at + 1) - at - 3);
}

TEST(NewSubject, CompilesAsItSaysAndIsRight) {
  const OracleProcess oracle;
  const Outcome written = oracle.run({"new-subject", "mine"});
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_THAT(content_of(oracle.folder() / "mine.c"),
              AllOf(HasSubstr("/* REPLACE: "), HasSubstr("libmine.so"), HasSubstr("\"mine\""),
                    Not(HasSubstr("new_subject"))));
  const std::string cc = line_of(written.out, "cc ");
  ASSERT_EQ(std::system(("cd '" + oracle.folder().string() + "' && " + cc).c_str()), 0) << cc;
  const Outcome stress = oracle.run({"stress", "--subject", "./libmine.so", "--cases", "200"});
  EXPECT_EQ(stress.exit_code, 0) << stress.out;
  EXPECT_THAT(stress.out, Not(HasSubstr(" violations.")));
  const Outcome check = oracle.run({"check", "cloud?lights=20", "--size", "16x12", "--cases",
                                    "1000", "--subject", "./libmine.so"});
  EXPECT_EQ(check.exit_code, 0) << check.out;
  EXPECT_THAT(check.out, HasSubstr("mine (libmine.so) does not offer them"));
}

TEST(NewSubject, OverwritesNothing) {
  const OracleProcess oracle;
  ASSERT_EQ(oracle.run({"new-subject", "mine"}).exit_code, 0);
  std::filesystem::resize_file(oracle.folder() / "mine.c", 5);
  const Outcome again = oracle.run({"new-subject", "mine"});
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_EQ(again.out, "");
  EXPECT_EQ(again.err, "lightcuts-oracle: mine.c: is there already, and is not overwritten\n");
  EXPECT_EQ(std::filesystem::file_size(oracle.folder() / "mine.c"), 5U);
}

TEST(NewSubject, WantsAPlainName) {
  const OracleProcess oracle;
  for (const char* name : {"", "../mine", "mi ne", "mine.c"})
    EXPECT_EQ(oracle.run({"new-subject", name}).exit_code, 2) << name;
  EXPECT_EQ(oracle.run({"new-subject"}).exit_code, 2);
  EXPECT_TRUE(oracle.files().empty());
}

} // namespace
} // namespace lightcuts
