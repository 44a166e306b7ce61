// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/cli/terminal.h>

namespace lightcuts {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Progress, IsDrawnOnATerminalAndCleared) {
  const OracleProcess oracle;
  const Terminal terminal;
  const auto table = oracle.folder() / "table";
  const pid_t child = oracle.start(
      {"check", "cloud?lights=20", "--size", "16x12", "--cases", "2000"}, table, terminal.path());
  std::string drawn;
  for (std::string part; !(part = terminal.next()).empty();) drawn += part;
  const Outcome outcome = OracleProcess::outcome_of(child, table, terminal.path());
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("All properties hold."));
  EXPECT_THAT(drawn, StartsWith("\rcheck cloud?lights=20 ["));
  EXPECT_THAT(drawn, HasSubstr(" %  "));
  EXPECT_THAT(drawn, EndsWith("\r\x1b[K"));
}

} // namespace
} // namespace lightcuts
