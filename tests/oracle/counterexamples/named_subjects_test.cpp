// SPDX-License-Identifier: MIT
#include <oracle/counterexamples/named_subjects.h>

#include <filesystem>

#include <gtest/gtest.h>
#include <oracle/mutants/mutants.h>

#include <tests/render/support/refusal.h>

namespace lightcuts::oracle {
namespace {

TEST(SubjectNamed, IsTheLibraryAsItsMethodsAre) {
  for (const char* name : {"lightcuts", "locally-ordered", "paper", "stochastic-intensity"}) {
    EXPECT_EQ(subject_named(name)->name(), name);
    EXPECT_EQ(full_subject_name(name), name);
  }
}

TEST(SubjectNamed, IsEveryMutantByItsNameWithAndWithoutItsPrefix) {
  for (const Mutant& mutant : mutants()) {
    const std::string full = std::string("mutant:") + mutant.name;
    EXPECT_EQ(full_subject_name(mutant.name), full);
    EXPECT_EQ(full_subject_name(full), full);
    const std::string said = mutant.subject()->name();
    EXPECT_EQ(subject_named(mutant.name)->name(), said);
    EXPECT_EQ(subject_named(full)->name(), said);
  }
}

TEST(SubjectNamed, RefusesWhatItDoesNotKnowWithItsName) {
  for (const char* name :
       {"", "Lightcuts", "mutant:", "mutant:lightcuts", "mutant:unheard-of", "unheard-of"})
    expect_refusal(std::string("'") + name + "'", [&] { (void)subject_named(name); });
}

TEST(SubjectNamed, TakesWhatLooksLikeAFileForAPlugIn) {
  for (const char* file : {"./nowhere", "nowhere.so", "/nowhere/at.all"})
    expect_refusal("nowhere", [&] { (void)subject_named(file)->build({}, 1); });
}

TEST(FullSubjectName, OfAPlugInLeadsToItFromEverywhere) {
  const std::filesystem::path here = std::filesystem::current_path();
  EXPECT_EQ(full_subject_name("./a/../b.so"), here / "b.so");
  EXPECT_EQ(full_subject_name("b.so"), here / "b.so");
  EXPECT_EQ(full_subject_name("/nowhere/at.all"), "/nowhere/at.all");
}

TEST(IsLibrary, HoldsForLightcutsAlone) {
  EXPECT_TRUE(is_library(*subject_named("lightcuts")));
  EXPECT_FALSE(is_library(*subject_named("locally-ordered")));
  EXPECT_FALSE(is_library(*subject_named("paper")));
  EXPECT_FALSE(is_library(*subject_named("stochastic-intensity")));
  for (const Mutant& mutant : mutants()) EXPECT_FALSE(is_library(*mutant.subject())) << mutant.name;
}

} // namespace
} // namespace lightcuts::oracle
