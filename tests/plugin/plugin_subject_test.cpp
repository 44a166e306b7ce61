// SPDX-License-Identifier: MIT
#include <oracle/subjects/plugin_subject.h>

#include <ostream>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <lightcuts/render/io/open_scene.h>
#include <oracle/campaign/check.h>
#include <oracle/campaign/hunt.h>
#include <oracle/cases/random_case.h>
#include <oracle/properties/judge.h>

#include <tests/plugin/plugins.h>

namespace lightcuts::oracle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Three omni lights over a diffuse point that sees them all.
Case three_lights() {
  Case on;
  for (int i = 0; i < 3; ++i) {
    Light light;
    light.position = {float(i), 0, 1};
    light.intensity = glm::vec3(1);
    on.lights.push_back(light);
  }
  on.views.push_back({});
  return on;
}

Tally verdict(const Subject& subject, const Case& on = three_lights()) {
  Tally tally;
  check_case(subject, on, 0, tally);
  return tally;
}

SceneView small_view() {
  static const Scene scene = [] {
    Scene s = open_scene("cloud?lights=20");
    s.image_size = {16, 12};
    return s;
  }();
  return SceneView(scene);
}

CheckResult checked(const Subject& subject) {
  CheckConfig config;
  config.pairs = 1000;
  config.threads = 2;
  return check(small_view(), subject, config);
}

/// Names of the properties that are violated; waste is none.
std::set<std::string> broken_names(const Tally& tally) {
  std::set<std::string> names;
  for (const Property p : all_properties)
    if (tally[p].violations > 0 && tally[p].severity == Severity::violation)
      names.insert(info(p).name);
  return names;
}

/// How many children this process has.
int children() { return int(children_of(getpid()).size()); }

// ---- what is wrong in its own way

struct Fault {
  const char* plugin;
  Property property;
  const char* says;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.plugin; }

class FaultyPlugin : public testing::TestWithParam<Fault> {};

TEST_P(FaultyPlugin, IsConvictedOfACase) {
  const Fault& fault = GetParam();
  const auto subject = plugin(fault.plugin);
  const Tally tally = verdict(*subject);
  EXPECT_GT(tally[fault.property].violations, 0U);
  EXPECT_THAT(tally[fault.property].first_violation, HasSubstr(fault.says));
  if (fault.property == Property::subject_answers) {
    EXPECT_THAT(tally[fault.property].first_violation,
                StartsWith(std::string("lib") + fault.plugin + ".so: "));
  }
}

TEST_P(FaultyPlugin, IsConvictedOfItAgain) {
  const Fault& fault = GetParam();
  const auto subject = plugin(fault.plugin);
  for (int i = 0; i < 2; ++i) EXPECT_GT(verdict(*subject)[fault.property].violations, 0U);
}

std::string test_name(const testing::TestParamInfo<Fault>& of) { return of.param.plugin; }

constexpr auto answers = Property::subject_answers;
constexpr auto partitions = Property::tree_partitions_lights;
constexpr auto finite = Property::results_are_finite;

INSTANTIATE_TEST_SUITE_P(
    Crashes, FaultyPlugin,
    testing::Values(
        Fault{"crash_in_build", answers, "crashed (signal 11, Segmentation fault) in build()"},
        Fault{"crash_in_destroy", answers, "crashed (signal 11, Segmentation fault) in destroy()"},
        Fault{"crash_in_bound", answers, "(signal 11, Segmentation fault) in bound() of node 0"},
        Fault{"crash_in_estimate", answers, "in estimate() of node 0"},
        Fault{"crash_in_select", answers, "in select()"},
        Fault{"crash_in_sample", answers, "in sample() of node 0"},
        Fault{"exit_in_build", answers, "exited with code 3 in build()"},
        Fault{"exit_in_bound", answers, "exited with code 3 in bound() of node 0"},
        Fault{"closes_connection", answers, "in build()"},
        Fault{"writes_to_connection", answers, "connection"},
        Fault{"forks_and_hangs", answers, "crashed (signal 6, Aborted) in build()"}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Hangs, FaultyPlugin,
    testing::Values(Fault{"hang_in_build", answers, "hung for 1 s in build()"},
                    Fault{"hang_in_bound", answers, "hung for 1 s in bound() of node 0"},
                    Fault{"hang_in_select", answers, "hung for 1 s in select(), threshold "}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Answers, FaultyPlugin,
    testing::Values(
        Fault{"null_tree", answers, "returned NULL in build()"},
        Fault{"code_in_bound", answers, "returned 42 in bound() of node 0"},
        Fault{"code_in_sample", answers, "returned -7 in sample() of node 0"},
        Fault{"nan_bound", finite, "bound nan"}, Fault{"nothing_written", finite, "bound nan"},
        Fault{"nan_bound", Property::bound_dominates_contribution, "channel g"},
        Fault{"nan_estimate", finite, "estimate (0, 0, nan)"},
        Fault{"nan_radiance", finite, "radiance (nan, 0, 0)"},
        Fault{"nan_probability", finite, "not in [0, 1]"},
        Fault{"child_beyond", partitions, "node 0 has node 1000000 of 4 as a child"},
        Fault{"child_cycle", partitions, "the root is a child of node 1"},
        Fault{"child_of_two", partitions, "node 2 is a child twice, of node 1 at last"},
        Fault{"many_children", partitions, "node 0 has children beyond"},
        Fault{"many_nodes", answers, "returned 4294967295 in node_count() for 3 lights"},
        Fault{"no_nodes", partitions, "no node for 3 lights"},
        Fault{"light_beyond", partitions, "node 1 has light 3 of 3"},
        Fault{"many_lights", partitions, "node 1 has lights beyond"},
        Fault{"light_left_out", partitions, "light 0 is in 0 leaves"},
        Fault{"wrong_representative", Property::representative_belongs, "is not of this cluster"},
        Fault{"cut_node_beyond", Property::cut_partitions_lights, "123456789"},
        Fault{"cut_node_twice", Property::cut_partitions_lights, "1 clusters repeated"},
        Fault{"many_clusters", answers, "a cut of 4294967295 clusters in select(), of 4 nodes"},
        Fault{"no_such_end", answers, "returned end 77 in select()"},
        Fault{"asks_beyond", answers, "whether light 3 of 3 is visible"},
        Fault{"draws_beyond", Property::draws_state_their_probability, "draws light 4294967294"},
        Fault{"random_bound", Property::threads_agree, "another bound of node"},
        Fault{"half_bound", Property::bound_dominates_contribution, "true contribution"}),
    [](const auto& of) {
      return std::string(of.param.plugin) + "_" + std::to_string(int(of.param.property));
    });

// ---- on a scene, in several threads

TEST(PluginCheck, ConvictsWhatCrashesAndHangs) {
  for (const char* name : {"crash_in_build", "crash_in_bound", "crash_in_estimate",
                           "crash_in_select", "hang_in_bound", "exit_in_bound"}) {
    const CheckResult result = checked(*plugin(name));
    EXPECT_GE(result.tally[answers].violations, 1U) << name;
    EXPECT_THAT(result.tally[answers].first_violation,
                StartsWith(std::string("lib") + name + ".so: "));
  }
}

TEST(PluginCheck, ConvictsWhatBuildsAnotherTreeForEachThread) {
  EXPECT_THAT(checked(*plugin("another_tree")).tally[answers].first_violation,
              HasSubstr("built another tree"));
}

TEST(PluginCheck, JudgesSamplingAlone) {
  const CheckResult result = checked(*plugin("only_sampling"));
  EXPECT_THAT(broken_names(result.tally), IsEmpty());
  EXPECT_GT(result.tally[Property::probabilities_sum_to_one].cases, 0U);
  EXPECT_EQ(result.tally[Property::bound_dominates_contribution].cases, 0U);
  EXPECT_GT(checked(*plugin("nan_probability")).tally[finite].violations, 0U);
}

// ---- parts

TEST(PluginParts, AreThoseThatItOffers) {
  EXPECT_EQ(plugin("none")->parts(),
            only(Part::bounds) | only(Part::estimates) | only(Part::sampling));
  EXPECT_EQ(plugin("only_sampling")->parts(), only(Part::sampling));
  EXPECT_EQ(plugin("only_bounds")->parts(), only(Part::bounds));
  EXPECT_EQ(plugin("only_cuts")->parts(), only(Part::cuts));
  EXPECT_EQ(plugin("only_probability")->parts(), 0U);
}

TEST(PluginParts, AreJudgedAlone) {
  const Tally sampling = verdict(*plugin("only_sampling"));
  EXPECT_THAT(broken_names(sampling), IsEmpty());
  EXPECT_GT(sampling[Property::probabilities_sum_to_one].cases, 0U);
  EXPECT_EQ(sampling[Property::bound_dominates_contribution].cases, 0U);
  EXPECT_EQ(sampling[Property::cut_partitions_lights].cases, 0U);
  const Tally bounds = verdict(*plugin("only_bounds"));
  EXPECT_THAT(broken_names(bounds), IsEmpty());
  EXPECT_GT(bounds[Property::bound_dominates_contribution].cases, 0U);
  EXPECT_EQ(bounds[Property::bound_dominates_error].cases, 0U);
  EXPECT_EQ(bounds[Property::probabilities_sum_to_one].cases, 0U);
}

TEST(PluginParts, OfALaterHeaderDoNotMatter) {
  EXPECT_THAT(broken_names(verdict(*plugin("newer_table"))), IsEmpty());
}

// ---- random cuts

/// Of so many cases in which much is drawn, up to the first where something is wrong.
Tally verdict_on_draws(const Subject& subject, int cases = 12) {
  Tally tally;
  for (std::uint64_t i = 0; cases > 0 && broken_names(tally).empty(); ++i) {
    const Case on = random_case(1, i);
    if (!on.draws) continue;
    check_case(subject, on, i, tally);
    --cases;
  }
  return tally;
}

TEST(PluginDraws, OfTheExampleAreRight) {
  const auto subject = example("top_down_tree");
  EXPECT_TRUE(has(subject->parts(), Part::random_cuts));
  const Tally tally = verdict_on_draws(*subject, 3);
  EXPECT_THAT(broken_names(tally), IsEmpty());
  EXPECT_GT(tally[Property::stochastic_is_unbiased].cases, 0U);
  EXPECT_GT(tally[Property::draws_are_independent].cases, 0U);
}

TEST(PluginDraws, AreConvicted) {
  const auto broken_by = [](const char* fault) {
    return broken_names(verdict_on_draws(*plugin(fault)));
  };
  EXPECT_THAT(broken_by("one_number_for_all"), testing::ElementsAre("draws-are-independent"));
  EXPECT_THAT(broken_by("drawn_evenly"), testing::Contains("stochastic-is-unbiased"));
  EXPECT_THAT(broken_by("cut_by_query"), testing::ElementsAre("draws-are-independent"));
  EXPECT_THAT(verdict_on_draws(*plugin("draws_no_node"))[Property::subject_answers].first_violation,
              HasSubstr("returned node 123456789 of "));
}

TEST(PluginDraws, AreNotInAnOlderTable) {
  const auto subject = plugin("older_table");
  EXPECT_FALSE(has(subject->parts(), Part::random_cuts));
  EXPECT_TRUE(has(subject->parts(), Part::sampling));
  EXPECT_THAT(broken_names(verdict(*subject)), IsEmpty());
}

TEST(PluginDraws, AreThoseOfTheirQueries) {
  const auto subject = example("top_down_tree");
  const auto tree = subject->build(three_lights().light_set(), 1);
  const ShadingPoint point = three_lights().views[0].view.point();
  const CutConfig config{0.5F, 2, 0};
  const auto seen = [](std::uint32_t) { return true; };
  std::vector<std::uint64_t> queries(300);
  for (std::size_t i = 0; i < queries.size(); ++i) queries[i] = i;
  std::vector<glm::vec3> together, one_by_one;
  tree->draws(point, config, queries, seen,
              [&](const Cut& cut) { together.push_back(cut.radiance); });
  for (const std::uint64_t query : queries)
    one_by_one.push_back(tree->draw(point, config, query, seen).radiance);
  EXPECT_EQ(together, one_by_one);
  EXPECT_FALSE(tree->draw(point, config, 7, seen).clusters.empty());
}

// ---- what is no plug-in

std::string refusal(const std::filesystem::path& file, double time_limit = 10) {
  try {
    (void)plugin_subject(file, {.time_limit = time_limit, .host = {}});
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(PluginFile, IsRefusedByItsName) {
  const auto says = [](const std::string& name, const std::string& why) {
    const std::filesystem::path file = plugin_file(name);
    EXPECT_THAT(refusal(file, patience(name)),
                AllOf(StartsWith(file.string() + ": "), HasSubstr(why)));
  };
  says("wrong_version", "wrong ABI version 99, expected 1");
  says("small_table", "a table of 16 bytes");
  says("no_function", "no function children()");
  says("no_table", "returned NULL");
  says("no_symbol", "does not export lightcuts_subject_v1()");
  says("crash_in_load", "crashed (signal 11, Segmentation fault) while it was loaded");
  says("hang_in_load", "hung for 1 s while it was loaded");
  says("no such file", "no such file");
}

TEST(PluginFile, IsRefusedWhereItIsNoLibrary) {
  const auto text = std::filesystem::temp_directory_path() / "lightcuts_no_library.so";
  std::ofstream(text) << "#!/bin/sh\n";
  EXPECT_EQ(refusal(text), text.string() + ": cannot be loaded: file too short");
  std::filesystem::remove(text);
  EXPECT_THAT(refusal(std::filesystem::temp_directory_path()), HasSubstr("not a shared library"));
}

// ---- processes

TEST(PluginProcess, IsKilledAtTheTimeLimit) {
  const auto start = Clock::now();
  const auto subject = plugin("hang_in_build");
  EXPECT_THROW((void)subject->build(three_lights().light_set(), 1), SubjectFailure);
  EXPECT_LT(seconds_since(start), 30);
}

#ifndef __SANITIZE_ADDRESS__ // whose own memory leaves no room for a limit
TEST(PluginProcess, IsRefusedMemoryBeyondItsLimit) {
  const auto failure = [](const char* name, std::uint64_t mebibytes) -> std::string {
    const auto subject = plugin_subject(
        plugin_file(name), {.time_limit = 60, .memory_limit = mebibytes << 20, .host = {}});
    try {
      (void)subject->build(three_lights().light_set(), 1);
    } catch (const SubjectFailure& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(failure("hoards", 256), "libhoards.so: returned NULL in build(); its memory limit of "
                                    "256 MiB was reached: 1 MiB more were refused");
  EXPECT_EQ(failure("hoards_and_aborts", 1024),
            "libhoards_and_aborts.so: crashed (signal 6, Aborted) in build(); its memory limit of "
            "1 GiB was reached: 1 MiB more were refused");
  EXPECT_EQ(failure("null_tree", 256), "libnull_tree.so: returned NULL in build()");
  EXPECT_EQ(failure("none", 64), "");
}
#endif

TEST(PluginProcess, EndsWithItsSubject) {
  const int before = children();
  {
    const auto subject = brute_tree();
    const auto tree = subject->build(three_lights().light_set(), 1);
    const auto other = tree->for_another_thread();
    EXPECT_EQ(children(), before + 2);
    EXPECT_THAT(broken_names(verdict(*plugin("crash_in_bound"))),
                testing::Contains("subject-answers"));
  }
  EXPECT_EQ(children(), before);
}

TEST(PluginProcess, EndsWithAllThatItStarted) {
  pid_t sleeper = 0;
  {
    const auto subject = plugin("forks_a_sleeper");
    const auto tree = subject->build(three_lights().light_set(), 1);
    sleeper = child_of(child_of(getpid()));
    EXPECT_TRUE(is_running(sleeper));
  }
  EXPECT_TRUE(ends(sleeper));
}

TEST(PluginProcess, HasTheUsualArithmeticInEachCall) {
  const auto subject = plugin("spoils_arithmetic");
  const auto tree = subject->build(three_lights().light_set(), 1);
  EXPECT_EQ(tree->bound(0, three_lights().views[0].view.point()).x, 1);
}

TEST(PluginProcess, IsUsedAgain) {
  const auto subject = brute_tree();
  (void)verdict(*subject);
  EXPECT_LE(children(), 3);
}

TEST(PluginProcess, OutlivesTheThreadThatStartedIt) {
  const auto subject = brute_tree();
  std::unique_ptr<SubjectTree> tree;
  std::thread([&] {
    tree = subject->build(three_lights().light_set(), 1)->for_another_thread();
  }).join();
  EXPECT_GT(tree->bound(0, three_lights().views[0].view.point()).x, 0);
}

TEST(PluginTree, SaysAgainThatItHasFailed) {
  const auto subject = plugin("crash_in_bound");
  const auto tree = subject->build(three_lights().light_set(), 1);
  const ShadingPoint point = three_lights().views[0].view.point();
  for (int i = 0; i < 2; ++i) EXPECT_THROW((void)tree->bound(0, point), SubjectFailure);
  const auto next = subject->build(three_lights().light_set(), 1);
  EXPECT_EQ(next->claim().nodes.size(), 4U);
}

/// How many trees the process of a tree has built.
float builds(SubjectTree& tree) { return tree.bound(0, three_lights().views[0].view.point()).x; }

TEST(PluginTree, IsBuiltInTheProcessOfTheOneBefore) {
  const auto subject = plugin("counts_builds");
  const LightSet lights = three_lights().light_set();
  auto one = subject->build(lights, 1);
  auto other = subject->build_after(subject->build(lights, 1), lights, 2);
  one = subject->build_after(std::move(one), lights, 2);
  other = subject->build_after(std::move(other), lights, 3);
  EXPECT_EQ(builds(*one), 2);
  EXPECT_EQ(builds(*other), 3);
}

TEST(PluginTree, IsBuiltAnewAfterAForeignOne) {
  const auto subject = plugin("counts_builds"), another = plugin("none");
  const LightSet lights = three_lights().light_set();
  EXPECT_EQ(builds(*subject->build_after(another->build(lights, 1), lights, 1)), 1);
  EXPECT_EQ(builds(*subject->build_after(nullptr, lights, 1)), 2);
}

TEST(PluginTree, IsBuiltAnewAfterOneThatFailed) {
  const auto subject = plugin("crash_in_bound");
  const LightSet lights = three_lights().light_set();
  auto tree = subject->build(lights, 1);
  EXPECT_THROW((void)builds(*tree), SubjectFailure);
  EXPECT_EQ(subject->build_after(std::move(tree), lights, 1)->claim().nodes.size(), 4U);
}

TEST(PluginTree, AnswersOneByOneAsItDoesManyAtOnce) {
  const auto subject = brute_tree();
  const auto tree = subject->build(three_lights().light_set(), 1);
  const ShadingPoint point = three_lights().views[0].view.point();
  std::vector<glm::vec3> bounds(tree->claim().nodes.size());
  tree->bounds(point, bounds);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) EXPECT_EQ(tree->bound(i, point), bounds[i]);
  // The estimate of a cluster is kept within the bound that is given.
  EXPECT_GT(tree->estimate(0, point, bounds[0]).x, 0.1);
  EXPECT_EQ(tree->estimate(0, point, glm::vec3(0.1F)), glm::dvec3(0.1F));
  const std::vector<double> u{0, 0.4, 0.99};
  std::vector<DrawnLight> drawn(u.size());
  tree->samples(0, point, u, drawn);
  for (std::size_t i = 0; i < u.size(); ++i) {
    EXPECT_EQ(tree->sample(0, point, u[i]).light, drawn[i].light);
    EXPECT_EQ(tree->probability(0, point, drawn[i].light), drawn[i].probability);
  }
}

// ---- hunting

TEST(PluginHunt, ShrinksWhatItFinds) {
  const auto subject = plugin("half_bound");
  HuntConfig config;
  config.cases = 1000;
  config.waste = false;
  const HuntResult result = hunt(*subject, config);
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.found->property, Property::bound_dominates_contribution);
  const Counterexample small = shrunk(*subject, *result.found);
  EXPECT_EQ(small.on.lights.size(), 1U);
  EXPECT_EQ(small.on.views.size(), 1U);
}

} // namespace
} // namespace lightcuts::oracle
