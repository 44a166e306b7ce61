// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/mutants.h>

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/oracle/check.h>
#include <lightcuts/render/builtin_scenes.h>
#include <lightcuts/tree_builder.h>

#include "judged_point.h"

namespace lightcuts::oracle {
namespace {

/// As `lightcuts-oracle mutants` has it, but for fewer lights.
struct Desk {
  Scene scene = make_builtin("desk");
  SceneView view{scene};
  LightTree tree = build(scene.lights);

  [[nodiscard]] Tally judge(const Subject& subject) const {
    CheckConfig config;
    config.pairs = 20'000;
    config.threads = 2;
    return check(view, subject, config).tally;
  }
};

TEST(Mutants, AreAllCaughtOnTheDesk) {
  const Desk desk;
  for (const Mutant& mutant : mutants())
    EXPECT_GT(desk.judge(*mutant.make(desk.tree)).violations(), 0U) << mutant.name;
}

TEST(Mutants, AreNotTheLibrary) {
  const Desk desk;
  EXPECT_THAT(violated(desk.judge(*library_subject(desk.tree))), testing::IsEmpty());
}

TEST(Mutants, BreakThePropertyThatTheyWereMadeFor) {
  const Desk desk;
  for (const Mutant& mutant : mutants()) {
    const auto broken = violated(desk.judge(*mutant.make(desk.tree)));
    if (std::string(mutant.name) == "heap-inverted") {
      EXPECT_THAT(broken, testing::Contains(Property::cut_obeys_threshold));
    } else if (std::string(mutant.name) == "intensity-of-representative") {
      EXPECT_THAT(broken, testing::Contains(Property::bound_dominates_contribution));
    }
  }
}

TEST(Mutants, HaveNamesAndSayWhatIsWrong) {
  std::set<std::string> names;
  const LightTree tree = four_lights();
  for (const Mutant& mutant : mutants()) {
    names.insert(mutant.name);
    EXPECT_EQ(mutant.make(tree)->name(), mutant.name);
    EXPECT_GT(std::string(mutant.what_is_wrong).size(), 20U);
  }
  EXPECT_EQ(names.size(), mutants().size());
  EXPECT_TRUE(names.contains("heap-inverted"));
  EXPECT_TRUE(names.contains("intensity-of-representative"));
}

TEST(LibrarySubject, GivesTheLibrarysOwnAnswers) {
  const LightTree tree = four_lights();
  const auto subject = library_subject(tree);
  EXPECT_EQ(subject->name(), "lightcuts");
  EXPECT_EQ(&subject->tree(), &tree);
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i)
    EXPECT_EQ(subject->bound(i, diffuse_point()),
              contribution_bound(tree, i, diffuse_point(), NoLobe()));
}

} // namespace
} // namespace lightcuts::oracle
