// SPDX-License-Identifier: MIT
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <oracle/campaign/hunt.h>
#include <oracle/mutants/mutants.h>
#include <tests/oracle/support/made_draws.h>
#include <tests/oracle/support/made_subject.h>

namespace lightcuts::oracle {
namespace {

using testing::HasSubstr;

constexpr auto repeatable = Property::draws_are_repeatable;

PropertyCount repeated(SubjectTree& tree, const JudgedPoint& judged, Parts parts = sampled_parts) {
  return judged_at(
      tree, judged, [&](const Judge& judge, const PointAnswers& of) { judge.point(of, cut_of(2)); },
      parts, repeatable)[repeatable];
}

struct DrawsAreRepeatable : FourLights {
  [[nodiscard]] PropertyCount of(const Changes& changes, Parts parts = sampled_parts) const {
    MadeDraws tree = with(changes);
    return repeated(tree, judged, parts);
  }
};

TEST_F(DrawsAreRepeatable, HoldsForTheLibrary) {
  LibraryTree tree = judged.library();
  const PropertyCount count = repeated(tree, judged);
  EXPECT_EQ(count.cases, 1U);
  EXPECT_EQ(count.violations, 0U) << count.first_violation;
}

TEST_F(DrawsAreRepeatable, ConvictsAnotherLightTheSecondTime) {
  int asked = 0;
  const PropertyCount count = of({.number = [&](double u) { return ++asked > 10 ? 1 - u : u; }});
  EXPECT_EQ(count.violations, 1U);
  EXPECT_THAT(count.first_violation, HasSubstr("draws light"));
  EXPECT_THAT(count.first_violation, HasSubstr("when asked again"));
}

TEST_F(DrawsAreRepeatable, ConvictsAnotherProbability) {
  int asked = 0;
  const PropertyCount count =
      of({.drawn = [&](std::uint32_t, DrawnLight& d) { d.probability *= 1 + 0x1p-52 * ++asked; }});
  EXPECT_EQ(count.violations, 1U);
}

TEST_F(DrawsAreRepeatable, ConvictsOtherEstimatesOfARandomCut) {
  int asked = 0;
  const Changes other{.clusters = [&](Clusters& all, std::uint64_t) {
    if (++asked == 5) all.front().estimate *= 1 + 0x1p-52;
  }};
  const PropertyCount count = of(other);
  EXPECT_EQ(count.violations, 1U);
  EXPECT_THAT(count.first_violation, HasSubstr("query 1 draws radiance"));
  asked = 0;
  EXPECT_EQ(of(other, sampled_parts & ~only(Part::random_cuts)).violations, 0U);
}

TEST_F(DrawsAreRepeatable, AsksNobodyWhoDrawsNothing) {
  EXPECT_EQ(of({}, sampled_parts & ~only(Part::sampling)).cases, 0U);
}

TEST_F(DrawsAreRepeatable, AloneConvictsDrawsThatGoOn) {
  HuntConfig config;
  config.cases = 400;
  config.further = 100;
  const HuntResult result = hunt(*mutant_named("draws-go-on")->subject(), config);
  ASSERT_TRUE(result.found);
  EXPECT_THAT(violated(result.tally), testing::ElementsAre(repeatable));
}

} // namespace
} // namespace lightcuts::oracle
