// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightcuts {
namespace {

using testing::HasSubstr;

std::string help_of(const std::string& command) {
  const Outcome outcome = OracleProcess().run({command, "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

void expect_common_defaults(const std::string& help) {
  for (const char* part :
       {"SCENE TEXT=desk", "--seed UINT=1", "--threads UINT:UINT in [0 - 1024]=0",
        "--max-cut UINT=5000", "--size TEXT", "default: the scene's", "--json TEXT",
        "default: no JSON"})
    EXPECT_THAT(help, HasSubstr(part));
}

TEST(Help, OfCheckShowsEveryDefault) {
  const std::string help = help_of("check");
  EXPECT_THAT(help, HasSubstr("counterexamples to out/SCENE"));
  expect_common_defaults(help);
  EXPECT_THAT(help, HasSubstr("--threshold TEXT=auto"));
  EXPECT_THAT(help, HasSubstr("--cases TEXT=1e7"));
  EXPECT_THAT(help, HasSubstr("--memory-limit TEXT=4GiB"));
}

TEST(Help, OfReportShowsEveryDefault) {
  const std::string help = help_of("report");
  expect_common_defaults(help);
  for (const char* part : {"default: out/SCENE", "=[reference,lightcuts]", "=[auto]",
                           "--repeats INT:INT in [1 - 99]=3"})
    EXPECT_THAT(help, HasSubstr(part));
}

TEST(Help, OfRenderShowsEveryDefault) {
  const std::string help = help_of("render");
  expect_common_defaults(help);
  for (const char* part : {"--threshold TEXT=auto", "default: out/SCENE", "=auto"})
    EXPECT_THAT(help, HasSubstr(part));
}

TEST(Help, OfMutantsAndInfoShowsEveryDefault) {
  const std::string info = help_of("info");
  expect_common_defaults(info);
  EXPECT_THAT(info, HasSubstr("--threshold TEXT=auto"));
  EXPECT_THAT(help_of("mutants"), HasSubstr("--cases TEXT=20000"));
}

TEST(Help, NamesCommandsAndExitCodes) {
  const Outcome outcome = OracleProcess().run({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* part : {"check", "report", "render", "mutants", "info", "scenes", "stress",
                           "errors", "replay", "new-subject", "0 all holds",
                           "1 a property is violated", "2 usage", "3 input", "4 internal"})
    EXPECT_THAT(outcome.out, HasSubstr(part));
}

TEST(Version, IsPrinted) {
  const Outcome outcome = OracleProcess().run({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.find("lightcuts-oracle 0."), 0U);
}

struct BadUsage {
  const char* name;
  std::vector<std::string> arguments;
  std::string says; ///< on stderr
};

class Usage : public testing::TestWithParam<BadUsage> {};

TEST_P(Usage, IsRefused) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run(GetParam().arguments);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().says));
  EXPECT_LT(outcome.err.size(), 250U);
  EXPECT_TRUE(oracle.files().empty());
}

INSTANTIATE_TEST_SUITE_P(
    Cli, Usage,
    testing::Values(
        BadUsage{"NoCommand", {}, "subcommand is required"},
        BadUsage{"UnknownCommand", {"frob"}, "frob"},
        BadUsage{"UnknownOption", {"check", "--frob"}, "--frob"},
        BadUsage{"TwoScenes", {"check", "desk", "cloud"}, "cloud"},
        BadUsage{"UnknownMethod", {"render", "--method", "magic"}, "magic"},
        BadUsage{"UnknownMethodInList", {"report", "--methods", "lightcuts,magic"}, "magic"},
        BadUsage{"ThresholdMissing", {"check", "--threshold"}, "--threshold"},
        BadUsage{"ThresholdNotANumber", {"check", "--threshold", "x"}, "'x' is not a threshold"},
        BadUsage{"ThresholdNan", {"check", "--threshold", "nan"}, "'nan' is not a threshold"},
        BadUsage{"ThresholdInfinite", {"check", "--threshold", "inf"}, "'inf' is not a threshold"},
        BadUsage{"ThresholdNegative", {"check", "--threshold", "-1%"}, "'-1%' is not a threshold"},
        BadUsage{"ThresholdWithRest", {"check", "--threshold", "2%%"}, "'2%%' is not a threshold"},
        BadUsage{"ThresholdInList", {"report", "--thresholds", "1%,two"}, "'two'"},
        BadUsage{"SizeWithoutHeight", {"check", "--size", "10"}, "'10' is not WIDTHxHEIGHT"},
        BadUsage{"SizeNegative", {"check", "--size", "-1x5"}, "'-1x5' is not WIDTHxHEIGHT"},
        BadUsage{"SizeWithRest", {"check", "--size", "4x5x6"}, "'4x5x6' is not WIDTHxHEIGHT"},
        BadUsage{"SizeZero", {"check", "--size", "0x10"}, "'0x10' is not WIDTHxHEIGHT"},
        BadUsage{"SizeTooLarge", {"check", "--size", "10x16385"}, "1 to 16384 pixels"},
        BadUsage{"SizeEmpty", {"check", "--size", ""}, "'' is not WIDTHxHEIGHT"},
        BadUsage{"SeedNegative", {"check", "--seed", "-1"}, "'-1' is negative"},
        BadUsage{"ThreadsNegative", {"check", "--threads", "-1"}, "--threads"},
        BadUsage{"ThreadsTooMany", {"check", "--threads", "1000000"}, "1024"},
        BadUsage{"CasesZero", {"check", "--cases", "0"}, "'0' is not a whole number above 0"},
        BadUsage{"CasesNegative", {"check", "--cases", "-5"}, "'-5' is not a whole number"},
        BadUsage{"CasesFraction", {"check", "--cases", "1.5e6"}, "'1.5e6' is not a whole number"},
        BadUsage{"CasesTooMany", {"mutants", "--cases", "2e19"}, "'2e19' is not a whole number"},
        BadUsage{"CasesByTheirOldName", {"check", "--pairs", "5"}, "--pairs"},
        BadUsage{"LightsZero", {"check", "--lights", "0"}, "'0' is not a whole number above 0"},
        BadUsage{"MaxCutZero", {"check", "--max-cut", "0"}, "'0' is not a whole number above 0"},
        BadUsage{"MaxCutTooLarge", {"check", "--max-cut", "4294967296"}, "--max-cut"},
        BadUsage{"RepeatsZero", {"report", "--repeats", "0"}, "--repeats"}),
    [](const auto& of) { return of.param.name; });

} // namespace
} // namespace lightcuts
