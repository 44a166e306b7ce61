// SPDX-License-Identifier: MIT
#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <lightcuts/render/view/scene_view.h>
#include <oracle/cases/random_picture.h>
#include <oracle/mutants/mutants.h>
#include <oracle/properties/judge.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {
namespace {

using testing::HasSubstr;

constexpr auto proofs = Property::proven_visibility_holds;

PropertyCount count_of(const Subject& subject, std::uint64_t first, std::uint64_t end) {
  Tally tally;
  for (std::uint64_t i = first; i < end; ++i) {
    gen::Dice dice(i);
    check_case(subject, picture_case(dice), i, tally, proofs);
  }
  return tally[proofs];
}

/// The library, but for what is said of one thing that it proves.
class Says : public KernelSubject {
public:
  explicit Says(std::function<void(ProvenSight&)> alter)
      : KernelSubject("says"), alter_(std::move(alter)) {}
  [[nodiscard]] std::vector<ProvenSight>
  prove(const SceneView& view, const LightTree& tree,
        std::span<const VisiblePoint> points) const override {
    auto sights = KernelSubject::prove(view, tree, points);
    for (ProvenSight& sight : sights) alter_(sight);
    return sights;
  }

private:
  std::function<void(ProvenSight&)> alter_;
};

// Of each kind that pictures are drawn of, and not of a few of them only.
TEST(ProvenVisibilityHolds, ForTheLibraryInThousandsOfPictures) {
  const PropertyCount count = count_of(*library_subject(), 0, 3000);
  EXPECT_EQ(count.violations, 0U) << count.first_violation;
  EXPECT_GT(count.cases, 50'000U);
  int seen = 0, hidden = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    gen::Dice dice(i);
    bool any_seen = false, any_hidden = false;
    const Says watched([&](ProvenSight& sight) {
      any_seen = any_seen || sight == ProvenSight::seen;
      any_hidden = any_hidden || sight == ProvenSight::hidden;
    });
    Tally tally;
    check_case(watched, picture_case(dice), i, tally, proofs);
    seen += any_seen ? 1 : 0;
    hidden += any_hidden ? 1 : 0;
  }
  EXPECT_GT(seen, 40);
  EXPECT_GT(hidden, 20);
}

TEST(ProvenVisibilityHolds, NotWhereSightsAreExchangedOrAllIsTakenForProven) {
  const Says exchanged([](ProvenSight& sight) {
    if (sight != ProvenSight::unknown)
      sight = sight == ProvenSight::seen ? ProvenSight::hidden : ProvenSight::seen;
  });
  const PropertyCount wrong = count_of(exchanged, 0, 40);
  EXPECT_EQ(wrong.violations, wrong.cases);
  EXPECT_THAT(wrong.first_violation, HasSubstr("proven "));
  EXPECT_THAT(wrong.first_violation, HasSubstr(" with all of node "));
  for (const ProvenSight sight : {ProvenSight::seen, ProvenSight::hidden}) {
    const Says rash([&](ProvenSight& s) { s = sight; });
    const PropertyCount count = count_of(rash, 0, 40);
    EXPECT_GT(count.violations, 0U);
    EXPECT_LT(count.violations, count.cases);
  }
}

TEST(ProvenVisibilityHolds, IsNotAskedOfSubjectsThatProveNothing) {
  class ProvesNothing : public KernelSubject {
  public:
    ProvesNothing() : KernelSubject("proves nothing") {}
    [[nodiscard]] Parts parts() const override {
      return all_parts_and_claims & ~only(Part::proofs);
    }
  };
  EXPECT_EQ(count_of(ProvesNothing(), 0, 40).cases, 0U);
}

TEST(ProvenVisibilityHolds, ConvictsBrokenShafts) {
  for (const char* name :
       {"shaft-to-the-middle", "shaft-without-margin", "covered-at-the-middle",
        "candidates-of-another", "plane-of-the-first-point", "pair-hides-the-middle"}) {
    const Mutant* mutant = mutant_named(name);
    ASSERT_NE(mutant, nullptr) << name;
    const auto subject = mutant->subject();
    std::uint64_t end = 0;
    while (end < 3000 && count_of(*subject, end, end + 100).violations == 0) end += 100;
    EXPECT_LT(end, 3000U) << name;
  }
}

} // namespace
} // namespace lightcuts::oracle
