// SPDX-License-Identifier: MIT
#include <oracle/properties/bounds/block_answers.h>

#include <functional>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <oracle/campaign/hunt.h>
#include <oracle/cases/blocks.h>
#include <oracle/cases/random_case.h>
#include <oracle/mutants/mutants.h>
#include <tests/oracle/support/made_subject.h>

namespace lightcuts::oracle {
namespace {

constexpr auto of_blocks = Property::block_bound_dominates;

/// The library but for how it bounds blocks.
class BentBlocks : public LibraryTree {
public:
  using Bend = std::function<glm::vec3(std::uint32_t node, glm::vec3 bound)>;
  BentBlocks(const LightTree& tree, Bend bend) : LibraryTree(tree), bend_(std::move(bend)) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<BentBlocks>(*this);
  }
  void block_bounds(std::span<const ShadingPoint> points, std::span<glm::vec3> out) override {
    LibraryTree::block_bounds(points, out);
    for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = bend_(i, out[i]);
  }

private:
  Bend bend_;
};

MadeSubject bent(const BentBlocks::Bend& bend) {
  return MadeSubject([bend](LightTree tree) { return std::make_unique<BentBlocks>(tree, bend); },
                     all_parts_and_claims);
}

/// Two lights over a floor, and two points of it; the second is the nearer one.
Case two_points() {
  Case c;
  c.lights = {{.position = {0, 0, 1}, .intensity = {1, 1, 1}},
              {.position = {0.25F, 0, 1}, .intensity = {1, 2, 1}}};
  c.views = {{{.position = {-1, 0, 0}}, {}}, {{.position = {0, 0, 0}}, {}}};
  return c;
}

PropertyCount count_of(const Subject& subject, const Case& on) {
  Tally tally;
  check_case(subject, on, 0, tally, of_blocks);
  return tally[of_blocks];
}

glm::vec3 as_it_is(std::uint32_t /*node*/, glm::vec3 bound) { return bound; }

TEST(BlockBoundDominates, IsJudgedForEachClusterAtEachPoint) {
  const PropertyCount count = count_of(bent(as_it_is), two_points());
  EXPECT_EQ(count.cases, 6U);
  EXPECT_EQ(count.violations, 0U);
  EXPECT_GT(count.worst_ratio, 0.5);
  EXPECT_LE(count.worst_ratio, 1);
}

TEST(BlockBoundDominates, ConvictsABoundThatIsTooLowForOneOfThePoints) {
  Tally tally;
  // The light alone at the point below it: 1/pi. At the other point it is less than half of that.
  const auto halved =
      bent([](std::uint32_t node, glm::vec3 bound) { return node == 1 ? bound * 0.9F : bound; });
  const PropertyCount count = count_of(halved, two_points());
  EXPECT_EQ(count.violations, 1U);
  EXPECT_THAT(count.first_violation, testing::HasSubstr("point (0, 0, 0), node 1 of 1 light"));
  EXPECT_THAT(count.first_violation, testing::HasSubstr("true contribution 0.3183"));
  EXPECT_THAT(count.first_violation, testing::HasSubstr("block's bound 0.286"));
}

TEST(BlockBoundDominates, ConvictsWhatIsNoNumber) {
  const auto bad = bent([](std::uint32_t, glm::vec3 bound) { return bound * float(nan("")); });
  EXPECT_EQ(count_of(bad, two_points()).violations, 6U);
}

TEST(BlockBoundDominates, AsksOfNothingThatIsNoBlock) {
  Case on = two_points();
  on.views[1].view.material.lobe = Ward{glm::vec3(1), 0.5F};
  EXPECT_EQ(count_of(bent(as_it_is), on).cases, 0U);
}

TEST(BlockBoundDominates, AsksForPartsThatThereAreOnly) {
  const MadeSubject subject(
      [](LightTree tree) {
        return std::make_unique<BentBlocks>(
            tree, [](std::uint32_t, glm::vec3) -> glm::vec3 { throw std::logic_error("asked"); });
      },
      all_parts_and_claims & ~only(Part::block_bounds));
  EXPECT_EQ(count_of(subject, two_points()).cases, 0U);
}

// All kinds of light and lobes are met.
TEST(BlockBoundDominates, HoldsForTheLibraryOnRandomCases) {
  PropertyCount count;
  std::set<std::size_t> lobes;
  std::set<LightKind> kinds;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    if (many_lights_at(i) > 0) continue;
    const Case on = random_case(3, i);
    if (on.views.size() < 2 || !is_block(on)) continue;
    lobes.insert(on.views[0].view.material.lobe.index());
    for (const Light& light : on.lights) kinds.insert(light.kind);
    count.merge(count_of(*library_subject(), on));
  }
  EXPECT_EQ(count.violations, 0U) << count.first_violation;
  EXPECT_GT(count.cases, 3000U);
  EXPECT_EQ(lobes.size(), std::variant_size_v<Lobe>);
  EXPECT_EQ(kinds.size(), std::size_t(light_kind_count));
}

TEST(BlockBoundDominates, AloneConvictsBlocksThatAreBoundedAsOthers) {
  for (const char* name : {"block-corner-forgotten", "block-of-one-normal", "block-of-one-material",
                           "block-rounded-inwards"}) {
    const Mutant* mutant = mutant_named(name);
    ASSERT_NE(mutant, nullptr) << name;
    HuntConfig config;
    config.cases = 400;
    config.further = 100;
    const HuntResult result = hunt(*mutant->subject(), config);
    ASSERT_TRUE(result.found) << name;
    EXPECT_THAT(violated(result.tally), testing::ElementsAre(of_blocks)) << name;
  }
}

} // namespace
} // namespace lightcuts::oracle
