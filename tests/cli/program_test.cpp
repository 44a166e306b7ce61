// SPDX-License-Identifier: MIT
#include <oracle/options/program.h>

#include <new>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>

#include <tests/cli/oracle_process.h>

namespace lightcuts {
namespace {

using testing::HasSubstr;

/// The exit code of what throws, and what is said of it.
template <class Thrown>
std::pair<int, std::string> code_of(const Thrown& thrown) {
  testing::internal::CaptureStderr();
  const int code = options::run_program("program", [&]() -> int { throw thrown; });
  return {code, testing::internal::GetCapturedStderr()};
}

TEST(Program, EndsByWhatItsWorkReturnsOrThrows) {
  EXPECT_EQ(options::run_program("program", [] { return 7; }), 7);
  EXPECT_EQ(code_of(InputError(InputFault::negative, "-1 is negative")),
            std::pair(3, std::string("program: -1 is negative\n")));
  EXPECT_EQ(code_of(std::logic_error("oops")),
            std::pair(4, std::string("program: internal error: oops\n")));
}

TEST(Program, TakesWantOfMemoryForTooLargeAnInput) {
  const auto [code, text] = code_of(std::bad_alloc());
  EXPECT_EQ(code, 3);
  EXPECT_THAT(text, HasSubstr("program: out of memory"));
}

/// Runs lightcuts-oracle by a shell that leads its streams elsewhere.
int code_with(const OracleProcess& oracle, const std::string& command, const std::string& streams) {
  const pid_t child =
      oracle.start("/bin/sh", {"-c", "exec \"$0\" " + command + " " + streams, LIGHTCUTS_ORACLE},
                   "/dev/null", "/dev/null");
  return OracleProcess::outcome_of(child, "/dev/null", "/dev/null").exit_code;
}

TEST(Program, ThatCannotWriteItsResultsSaysSoByItsExitCode) {
  const OracleProcess oracle;
  for (const char* streams : {">&-", ">&- 2>&-", ">/dev/full", ">/dev/full 2>/dev/full"})
    for (const char* command : {"scenes", "--help"})
      EXPECT_EQ(code_with(oracle, command, streams), 3) << command << ' ' << streams;
}

// What opens a file must not get the number of a stream that is closed: messages would go there.
TEST(Program, WorksWithoutStreams) {
  const OracleProcess oracle;
  write(oracle.folder() / "noted.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n");
  EXPECT_EQ(code_with(oracle, "info noted.obj --json a.json", "<&- 2>&-"), 0);
  EXPECT_THAT(content_of(oracle.folder() / "a.json"), HasSubstr("\"schema\""));
  EXPECT_EQ(code_with(oracle, "info nowhere.obj", "<&- >&- 2>&-"), 3);
}

} // namespace
} // namespace lightcuts
