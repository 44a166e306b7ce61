// SPDX-License-Identifier: MIT
#include <tests/cli/oracle_process.h>

#include <algorithm>
#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <tests/plugin/plugins.h>

namespace lightcuts {
namespace {

using nlohmann::json;
using oracle::ends;
using oracle::is_running;
using oracle::plugin_file;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Outcome judged(const std::string& file, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"check", "cloud?lights=20", "--size", "16x12", "--cases",
                                     "500",   "--subject",       file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return OracleProcess().run(arguments);
}

TEST(SubjectOption, JudgesAForeignTree) {
  const Outcome outcome = judged(LIGHTCUTS_BRUTE_TREE);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("All properties hold."),
                    HasSubstr("not judged: occlusion, pictures, random cuts, block bounds, "
                              "lights with profiles, proven visibility "
                              "(brute tree (libbrute_tree.so) does not offer them)")));
}

TEST(SubjectOption, TellsWhatWasNotJudged) {
  const Outcome outcome = judged(plugin_file("only_bounds"), {"--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["subject"], plugin_file("only_bounds").string());
  EXPECT_THAT(result["not_judged"],
              ElementsAre("lower bounds", "estimates", "cuts", "sampling", "refinement order",
                          "occlusion", "pictures", "random cuts", "block bounds",
                          "lights with profiles", "proven visibility"));
}

TEST(SubjectOption, RunsTheCatalogueAndSavesTheFirstViolation) {
  const OracleProcess oracle;
  const Outcome outcome = oracle.run(
      {"stress", "--catalogue", "--subject", plugin_file("half_bound"), "--json", "results.json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("named cases"));
  EXPECT_THAT(outcome.out, HasSubstr("left out, since it may take long: a-million-at-one-place"));
  const json result = json::parse(content_of(oracle.folder() / "results.json"));
  EXPECT_EQ(result["schema"], "lightcuts-oracle/stress/2");
  EXPECT_GE(result["cases"].size(), 40U);
  std::uint64_t violations = 0;
  for (const json& one : result["cases"]) {
    EXPECT_FALSE(one["name"].get<std::string>().empty());
    EXPECT_FALSE(one["why"].get<std::string>().empty());
    EXPECT_TRUE(one["worst_ratio"].is_number());
    EXPECT_TRUE(one["max_relative_error"].is_number() || one["max_relative_error"].is_null());
    EXPECT_GE(one["saturated"], 0);
    violations += one["violations"].get<std::uint64_t>();
  }
  EXPECT_GT(violations, 0U);
  EXPECT_EQ(result["violations"], violations);
  const std::string file = result["counterexample"]["file"];
  EXPECT_EQ(oracle.run({"replay", file}).exit_code, 1);
}

TEST(SubjectOption, ConvictsInOnePiece) {
  for (const char* name : {"crash_in_build", "crash_in_bound", "crash_in_select", "exit_in_bound",
                           "nan_bound", "child_cycle", "many_nodes", "half_bound"}) {
    const Outcome outcome = judged(plugin_file(name));
    EXPECT_EQ(outcome.exit_code, 1) << name;
    EXPECT_EQ(outcome.err, "") << name;
    EXPECT_THAT(outcome.out, HasSubstr("violations.")) << name;
  }
  EXPECT_THAT(
      judged(plugin_file("crash_in_bound")).out,
      HasSubstr("libcrash_in_bound.so: crashed (signal 11, Segmentation fault) in bound()"));
}

TEST(SubjectOption, ConvictsWhatHangs) {
  const Outcome outcome = judged(plugin_file("hang_in_select"), {"--time-limit", "1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("libhang_in_select.so: hung for 1 s in select(), threshold "));
}

TEST(SubjectOption, SaysWhereItHungOnTheScenesLights) {
  const Outcome outcome = judged(plugin_file("hang_in_build"), {"--time-limit", "1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("No file for subject-answers, as it is on the scene's lights "
                                     "taken together:\n  libhang_in_build.so: hung for 1 s in "
                                     "build()\n"));
}

#ifndef __SANITIZE_ADDRESS__
TEST(SubjectOption, ConvictsWhatWantsTooMuchMemory) {
  const Outcome outcome = judged(plugin_file("hoards"), {"--memory-limit", "256MiB"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("its memory limit of 256 MiB was reached"));
}
#endif

TEST(SubjectOption, RefusesWhatIsNoTree) {
  for (const char* name :
       {"wrong_version", "no_symbol", "no_function", "crash_in_load", "nowhere"}) {
    const Outcome outcome = judged(plugin_file(name));
    EXPECT_EQ(outcome.exit_code, 3) << name;
    EXPECT_EQ(outcome.out, "") << name;
    EXPECT_THAT(outcome.err, HasSubstr("lightcuts-oracle: " + plugin_file(name).string() + ": "));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(judged("").exit_code, 3);
  EXPECT_EQ(judged(LIGHTCUTS_BRUTE_TREE, {"--time-limit", "0"}).exit_code, 2);
  EXPECT_EQ(judged(LIGHTCUTS_BRUTE_TREE, {"--memory-limit", "4GB"}).exit_code, 2);
  EXPECT_EQ(judged(LIGHTCUTS_BRUTE_TREE, {"--memory-limit", "1MiB"}).exit_code, 2);
}

// In a subject's way, not in that of the results.
TEST(SubjectOption, LeadsOutputToStderr) {
  const Outcome outcome = judged(plugin_file("prints"), {"--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(json::parse(outcome.out)["violations"], 0);
  EXPECT_THAT(outcome.err, HasSubstr("this is not JSON"));
}

TEST(SubjectOption, LeavesOutMostOfMuchOutput) {
  const Outcome outcome = judged(plugin_file("prints_much"));
  EXPECT_EQ(outcome.exit_code, 0);
  const std::string end = "\nlibprints_much.so: prints more than 64 KiB, which is left out\n";
  EXPECT_EQ(outcome.err.size(), 64 * 1024 + end.size());
  EXPECT_TRUE(outcome.err.ends_with(end));
}

TEST(SubjectOption, LeavesNoProcessWhereTheOracleIsKilled) {
  std::vector<std::string> arguments{
      LIGHTCUTS_ORACLE, "check", "cloud?lights=20", "--subject", plugin_file("hang_in_bound"),
      "--time-limit",   "100"};
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  pid_t program = 0;
  ASSERT_EQ(posix_spawn(&program, argv[0], nullptr, nullptr, argv.data(), environ), 0);
  const auto [host, sleeper] = oracle::child_and_grandchild_of(program); // both hang
  EXPECT_TRUE(is_running(host));
  EXPECT_TRUE(is_running(sleeper));
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  EXPECT_TRUE(ends(host));
  EXPECT_TRUE(ends(sleeper));
}

TEST(SubjectOption, IsRememberedByFilesThatAreReplayedElsewhere) {
  const OracleProcess oracle, elsewhere;
  const auto library = oracle.folder() / "libmine.so";
  std::filesystem::copy_file(plugin_file("half_bound"), library);
  ASSERT_EQ(oracle.run({"stress", "--subject", "./libmine.so", "--out", "."}).exit_code, 1);
  const std::string file = oracle.folder() / "counterexample-bound-dominates-contribution.json";
  const Outcome outcome = elsewhere.run({"replay", file});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("is still violated by half bound (libmine.so)"));
  EXPECT_THAT(elsewhere.run({"replay", file, "--as-test"}).out,
              HasSubstr("subject_named(\"" + library.string() + "\")"));
  std::filesystem::remove(library);
  const Outcome gone = elsewhere.run({"replay", file});
  EXPECT_EQ(gone.exit_code, 3);
  EXPECT_THAT(gone.err,
              AllOf(HasSubstr(file + ": "), HasSubstr(library.string() + ": no such file"),
                    HasSubstr("--subject")));
  EXPECT_EQ(elsewhere.run({"replay", file, "--subject", "lightcuts"}).exit_code, 0);
}

TEST(SubjectOption, IsOneOfStressToo) {
  const OracleProcess oracle;
  const std::vector<std::string> stress{"stress", "--cases", "50", "--subject"};
  const auto run = [&](const std::string& file) {
    std::vector<std::string> arguments = stress;
    arguments.push_back(file);
    return oracle.run(arguments);
  };
  EXPECT_EQ(run(LIGHTCUTS_BRUTE_TREE).exit_code, 0);
  const Outcome half = run(plugin_file("half_bound"));
  EXPECT_EQ(half.exit_code, 1);
  EXPECT_THAT(half.out, HasSubstr("bound-dominates-contribution"));
  EXPECT_EQ(run(plugin_file("no_symbol")).exit_code, 3);
}

} // namespace
} // namespace lightcuts
