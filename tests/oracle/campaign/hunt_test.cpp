// SPDX-License-Identifier: MIT
#include <oracle/campaign/hunt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oracle/cases/random_case.h>
#include <oracle/cases/simpler_case.h>
#include <oracle/mutants/mutants.h>

#include <tests/oracle/support/case_text.h>
#include <tests/oracle/support/made_subject.h>
#include <tests/support/float_limits.h>

namespace lightcuts::oracle {
namespace {

using testing::IsEmpty;

constexpr double for_ever = 1e9;

HuntConfig config_of(std::uint64_t cases, std::uint64_t seed = 1) {
  HuntConfig config;
  config.cases = cases;
  config.seed = seed;
  return config;
}

/// Half the bound of clusters of more than two lights.
class HalfBound : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<HalfBound>(shared_tree());
  }
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    const glm::vec3 bound = LibraryTree::bound(node, point);
    return tree().node(node).light_count > 2 ? 0.5F * bound : bound;
  }
};

/// An infinite bound of the root: all the rest is refined as ever.
struct InfiniteRoot : ClusterKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return node == 0 ? glm::vec3(inf) : contribution_bound(tree, node, point);
  }
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    return cluster_estimate(tree, node, point, bound);
  }
};

/// The same with an order that is none, too.
class WastefulAndWrong : public KernelSubject {
public:
  WastefulAndWrong() : KernelSubject("wasteful and wrong", std::make_shared<InfiniteRoot>()) {}
  [[nodiscard]] bool refined_before(double, double) const override { return true; }
};

struct Silent : LibraryTree {
  using LibraryTree::LibraryTree;
  glm::vec3 bound(std::uint32_t, const ShadingPoint&) override { throw SubjectFailure("it hung"); }
};

TEST(Hunt, FindsNothingWrongWithTheLibraryInThousandsOfCases) {
  const HuntResult result = hunt(*library_subject(), config_of(4000, 2));
  EXPECT_EQ(result.cases, 4000U);
  EXPECT_FALSE(result.found) << info(result.found->property).name << " in case "
                             << result.found->index << ": " << result.found->message;
  EXPECT_THAT(violated(result.tally), IsEmpty());
}

// Of what takes many draws, only what large trees are asked without.
TEST(Hunt, AsksTheLibraryForEveryPropertyThatItHas) {
  const Tally tally = hunt(*library_subject(), config_of(400)).tally;
  for (const Property p : all_properties) {
    const PropertyInfo& property = info(p);
    const bool of_materials = property.of_light != nullptr || property.of_lobe != nullptr;
    const bool in_few_cases = property.of_draws == nullptr || property.of_odds != nullptr;
    EXPECT_EQ(tally[p].cases > 0, in_few_cases && !of_materials) << property.name;
  }
}

TEST(Hunt, FindsWhatIsBrokenAndTellsTheCase) {
  const MadeSubject subject = subject_with<HalfBound>();
  const HuntResult result = hunt(subject, config_of(1000));
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.found->property, Property::bound_dominates_contribution);
  EXPECT_EQ(result.found->index + 1, result.cases);
  EXPECT_LT(result.cases, 1000U);
  EXPECT_EQ(text_of(result.found->on), text_of(random_case(1, result.found->index)));
  EXPECT_EQ(failure_of(subject, result.found->property, result.found->on), result.found->message);
  EXPECT_EQ(result.tally[result.found->property].first_violation, result.found->message);
}

TEST(Hunt, LeavesLargeCasesOutOnceSomethingIsFound) {
  constexpr std::uint64_t past_the_first = 200;
  HuntConfig config = config_of(past_the_first);
  EXPECT_GE(hunt(*library_subject(), config).most_lights, 100U);
  config.further = past_the_first;
  const HuntResult result = hunt(subject_with<HalfBound>(), config);
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.cases, past_the_first);
  EXPECT_LT(result.most_lights, 100U);
}

TEST(Hunt, FindsTheSameByAnyNumberOfThreads) {
  for (const char* name : {"threshold-one-percent-loose", "cone-one-in-a-million"}) {
    const auto subject = mutant_named(name)->subject();
    HuntConfig config = config_of(600, 1);
    config.further = 50;
    const HuntResult one = hunt(*subject, config);
    ASSERT_TRUE(one.found) << name;
    for (const unsigned threads : {2U, 3U, 0U}) {
      config.threads = threads;
      const HuntResult many = hunt(*subject, config);
      ASSERT_TRUE(many.found) << name;
      EXPECT_EQ(many.cases, one.cases) << name;
      EXPECT_EQ(many.found->message, one.found->message) << name;
      EXPECT_EQ(many.found->index, one.found->index) << name;
      EXPECT_EQ(text_of(many.found->on), text_of(one.found->on)) << name;
      EXPECT_EQ(many.tally, one.tally) << name;
      EXPECT_EQ(many.most_lights, one.most_lights) << name;
    }
  }
}

TEST(Hunt, FindsTheSameEachTimeHoweverLongItTakes) {
  const MadeSubject subject = subject_with<HalfBound>();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const HuntResult once = hunt(subject, config_of(1000, seed));
    HuntConfig slow = config_of(1000, seed);
    slow.seconds = for_ever;
    slow.progress =
        Progress([](double) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
    const HuntResult again = hunt(subject, slow);
    ASSERT_TRUE(once.found && again.found);
    EXPECT_EQ(once.cases, again.cases);
    EXPECT_EQ(once.found->message, again.found->message);
    EXPECT_EQ(text_of(once.found->on), text_of(again.found->on));
    EXPECT_EQ(once.tally, again.tally);
  }
}

TEST(Hunt, EndsAfterSoManySeconds) {
  HuntConfig config = config_of(1'000'000'000);
  config.seconds = 0.05;
  const HuntResult result = hunt(*library_subject(), config);
  EXPECT_LT(result.cases, config.cases);
  EXPECT_GE(result.seconds, config.seconds);
}

TEST(Hunt, EndsWhereItIsCancelled) {
  HuntConfig config = config_of(1'000'000'000);
  int asked = 0;
  config.progress = Progress::until([&asked] { return ++asked > 3; });
  EXPECT_EQ(hunt(*library_subject(), config).cases, 3U);
}

TEST(Hunt, ReportsProgressUpToTheEnd) {
  double last = 0;
  HuntConfig config = config_of(20);
  config.progress = Progress([&](double share) {
    EXPECT_GT(share, last);
    last = share;
  });
  (void)hunt(*library_subject(), config);
  EXPECT_EQ(last, 1);
}

TEST(Hunt, TakesWasteForAFindOnlyWhereAsked) {
  const auto subject = KernelSubject("wasteful", std::make_shared<InfiniteRoot>());
  HuntConfig config = config_of(300);
  const HuntResult wasteful = hunt(subject, config);
  ASSERT_TRUE(wasteful.found);
  EXPECT_EQ(wasteful.found->property, Property::bound_is_finite);
  config.waste = false;
  const HuntResult result = hunt(subject, config);
  EXPECT_FALSE(result.found) << info(result.found->property).name << ": " << result.found->message;
  EXPECT_GT(result.tally.wasteful(), 0U);
  EXPECT_EQ(result.tally.violations(), 0U);
}

TEST(Hunt, NamesAViolationBeforeWaste) {
  std::uint64_t wasteful = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const HuntResult result = hunt(WastefulAndWrong(), config_of(100, seed));
    ASSERT_TRUE(result.found);
    EXPECT_EQ(result.found->property, Property::refinement_order_is_strict);
    wasteful += result.tally.wasteful();
  }
  EXPECT_GT(wasteful, 0U);
}

TEST(Hunt, CountsASubjectThatDoesNotAnswer) {
  const MadeSubject subject = subject_with<Silent>();
  const HuntResult result = hunt(subject, config_of(100));
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.found->property, Property::subject_answers);
  EXPECT_EQ(result.found->message, "it hung");
}

TEST(FailureOf, IsNothingWhereThePropertyHoldsOrTheCaseIsNotValid) {
  const MadeSubject subject = subject_with<HalfBound>();
  const Counterexample found = hunt(subject, config_of(1000)).found.value();
  EXPECT_TRUE(failure_of(subject, found.property, found.on));
  EXPECT_FALSE(failure_of(*library_subject(), found.property, found.on));
  EXPECT_FALSE(failure_of(subject, Property::tree_partitions_lights, found.on));
  Case invalid = found.on;
  invalid.views[0].view.normal = glm::vec3(0);
  EXPECT_FALSE(failure_of(subject, found.property, invalid));
}

TEST(Shrunk, StillFailsAndNothingSimplerDoes) {
  const MadeSubject subject = subject_with<HalfBound>();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Counterexample found = hunt(subject, config_of(1000, seed)).found.value();
    const Counterexample small = shrunk(subject, found, for_ever);
    EXPECT_EQ(small.property, found.property);
    EXPECT_EQ(small.index, found.index);
    EXPECT_EQ(failure_of(subject, small.property, small.on), small.message);
    for (const Case& c : simpler(small.on))
      EXPECT_FALSE(failure_of(subject, small.property, c)) << text_of(c);
    // The fewest of which this subject errs: one, where it is split in three.
    const std::size_t fewest = small.property == Property::split_light_is_immaterial ? 1 : 3;
    EXPECT_EQ(small.on.lights.size(), fewest)
        << seed << ' ' << info(small.property).name << ": " << small.message;
    EXPECT_EQ(small.on.views.size(), 1U);
    EXPECT_THAT(small.on.triangles, IsEmpty());
    EXPECT_EQ(small.on.seed, 1U);
  }
}

/// Half the bound of the root, where there are so many lights or more.
template <std::uint32_t least>
class HalfBoundOfMany : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<HalfBoundOfMany>(shared_tree());
  }
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    const bool errs = node == 0 && tree().lights().size() >= least;
    return LibraryTree::bound(node, point) * (errs ? 1e-3F : 1.0F);
  }
};

/// On a ring around the point, each as good as any other.
Counterexample on_a_ring(std::uint32_t count) {
  Counterexample c{Property::bound_dominates_contribution, {}, "", 0};
  c.on.views.resize(1);
  for (std::uint32_t i = 0; i < count; ++i)
    c.on.lights.push_back(
        {.position = {std::cos(float(i)), std::sin(float(i)), 1}, .intensity = glm::vec3(1)});
  return c;
}

TEST(Shrunk, SaysFromHowManyLightsOnItFails) {
  const MadeSubject subject = subject_with<HalfBoundOfMany<130>>();
  const Counterexample small = shrunk(subject, on_a_ring(300));
  EXPECT_EQ(small.on.lights.size(), 130U);
  EXPECT_EQ(small.least_lights, 130U);
  // Small numbers speak for themselves.
  EXPECT_EQ(shrunk(subject_with<HalfBoundOfMany<100>>(), on_a_ring(120)).least_lights, 0U);
}

TEST(Shrunk, SaysNothingOfSizesThatWereNotTried) {
  const MadeSubject subject = subject_with<HalfBoundOfMany<130>>();
  EXPECT_EQ(shrunk(subject, on_a_ring(130), 0).least_lights, 0U);
  // So little time that 300 lights stay: with 299 it fails, too.
  const Counterexample large = shrunk(subject, on_a_ring(300), 1e-9);
  EXPECT_EQ(large.on.lights.size(), 300U);
  EXPECT_EQ(large.least_lights, 0U);
}

/// Half the bound of the root, where there is a light of intensity 7.
class HalfBoundOfSeven : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<HalfBoundOfSeven>(shared_tree());
  }
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    const LightSet& lights = tree().lights();
    const bool errs = node == 0 && lights.size() >= 130 &&
                      std::any_of(lights.begin(), lights.end(),
                                  [](const Light& l) { return l.intensity.x == 7; });
    return LibraryTree::bound(node, point) * (errs ? 1e-3F : 1.0F);
  }
};

// Without the last, which is the bright one, it holds; without the first it does not.
TEST(Shrunk, SaysNothingWhereItIsALightAndNotTheSize) {
  Counterexample c = on_a_ring(140);
  c.on.lights.back().intensity = glm::vec3(7);
  EXPECT_EQ(shrunk(subject_with<HalfBoundOfSeven>(), c, 1e-9).least_lights, 0U);
}

TEST(Shrunk, IsWhatWasFoundWhereThereIsNoTime) {
  const MadeSubject subject = subject_with<HalfBound>();
  const Counterexample found = hunt(subject, config_of(1000)).found.value();
  const Counterexample same = shrunk(subject, found, 0);
  EXPECT_EQ(text_of(same.on), text_of(found.on));
  EXPECT_EQ(same.message, found.message);
}

} // namespace
} // namespace lightcuts::oracle
