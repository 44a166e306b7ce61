// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/oracle/support/judged_point.h>
#include <tests/support/cut_promises.h>

namespace lightcuts::oracle {
namespace {

/// A tree of the library whose cuts a test makes, of the library's own.
class MadeCuts : public LibraryTree {
public:
  using Visible = std::function<bool(std::uint32_t)>;
  using Make = std::function<Cut(const Cut& own, const CutConfig&, const Visible&)>;

  MadeCuts(const LightTree& tree, Make make) : LibraryTree(tree), make_(std::move(make)) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<MadeCuts>(*this);
  }
  Cut select(const ShadingPoint& point, const CutConfig& config, const Visible& visible) override {
    return make_(LibraryTree::select(point, config, visible), config, visible);
  }

private:
  Make make_;
};

Tally compared_cuts(Property only, SubjectTree&& tree, const JudgedPoint& judged,
                    const CutConfig& cut = {}) {
  return judged_at(
      tree, judged, [&](const Judge& judge, const PointAnswers& of) { judge.point(of, cut); },
      library_parts, only);
}

PropertyCount nesting_of(SubjectTree&& tree, const JudgedPoint& judged, const CutConfig& cut) {
  constexpr auto p = Property::tighter_threshold_refines;
  return compared_cuts(p, std::move(tree), judged, cut)[p];
}

PropertyCount darkening_of(SubjectTree&& tree, const JudgedPoint& judged) {
  constexpr auto p = Property::visibility_only_darkens;
  return compared_cuts(p, std::move(tree), judged)[p];
}

RC_GTEST_PROP(ComparedCuts, HoldForTheLibrary, ()) {
  const CutCase given = *cut_case();
  std::vector<char> visible;
  for (std::uint32_t i = 0; i < given.scene.lights.size(); ++i)
    visible.push_back(given.visibility()(i) ? 1 : 0);
  const JudgedPoint judged(build(given.scene.light_set()), given.scene.view.point(), visible);
  const PropertyCount nesting = nesting_of(judged.library(), judged, given.config);
  RC_ASSERT(nesting.first_violation == "");
  RC_ASSERT(nesting.cases == (given.config.threshold > 0 ? 1U : 0U));
  const PropertyCount darkening = darkening_of(judged.library(), judged);
  RC_ASSERT(darkening.first_violation == "");
  RC_ASSERT(darkening.cases == 1U);
}

/// Verdict on cuts of these nodes at the larger and at the smaller threshold.
std::uint64_t nesting_violations(const std::vector<std::uint32_t>& coarse,
                                 const std::vector<std::uint32_t>& fine) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 1});
  const CutConfig config{0.5F, 1000, 0.25F};
  std::map<bool, std::vector<CutCluster>> clusters;
  for (const std::uint32_t node : coarse) clusters[true].push_back({node, true, {}, {}});
  for (const std::uint32_t node : fine) clusters[false].push_back({node, true, {}, {}});
  const auto make = [&](Cut cut, const CutConfig& asked, const auto&) {
    EXPECT_EQ(asked.black_level, 0);
    cut.clusters = clusters[asked.threshold == config.threshold];
    return cut;
  };
  const PropertyCount count = nesting_of(MadeCuts(judged.tree, make), judged, config);
  EXPECT_EQ(count.cases, 1U);
  return count.violations;
}

TEST(TighterThresholdRefines, AllowsTheSameCutAndOneBelow) {
  const std::uint32_t a = four_lights().node(0).first_child;
  EXPECT_EQ(nesting_violations({0}, {0}), 0U);
  EXPECT_EQ(nesting_violations({0}, {a, a + 1}), 0U);
  EXPECT_EQ(nesting_violations({a, a + 1}, {a + 1, a}), 0U);
}

TEST(TighterThresholdRefines, ConvictsACoarserCutAndOneThatRefinesElsewhere) {
  const LightTree tree = four_lights();
  const std::uint32_t a = tree.node(0).first_child;
  EXPECT_EQ(nesting_violations({a, a + 1}, {0}), 1U);
  ASSERT_FALSE(tree.node(a).is_leaf() && tree.node(a + 1).is_leaf());
  const std::uint32_t inner = tree.node(a).is_leaf() ? a + 1 : a, other = 2 * a + 1 - inner;
  const std::uint32_t below = tree.node(inner).first_child;
  EXPECT_EQ(nesting_violations({inner, other}, {below, below + 1, other}), 0U);
  EXPECT_EQ(nesting_violations({below, below + 1, other}, {inner, other}), 1U);
}

TEST(TighterThresholdRefines, ConvictsNodesThatAreNone) {
  EXPECT_EQ(nesting_violations({0}, {7}), 1U);
  EXPECT_EQ(nesting_violations({7}, {0}), 1U);
}

/// Verdict where what is hidden changes the radiance by a factor.
std::uint64_t darkening_violations(float factor, const std::vector<char>& visible) {
  const JudgedPoint judged(four_lights(), diffuse_point(), visible);
  const auto make = [&](Cut cut, const CutConfig&, const MadeCuts::Visible& seen) {
    for (std::uint32_t i = 0; i < 4; ++i)
      if (!seen(i)) cut.radiance *= factor;
    return cut;
  };
  return darkening_of(MadeCuts(judged.tree, make), judged).violations;
}

TEST(VisibilityOnlyDarkens, ConvictsAHiddenLightThatAddsLight) {
  EXPECT_EQ(darkening_violations(100, {1, 1, 1, 1}), 0U);
  EXPECT_EQ(darkening_violations(100, {0, 1, 1, 1}), 1U);
  EXPECT_EQ(darkening_violations(1, {0, 1, 1, 1}), 0U);
}

// Both results may round, by 2^-23 of all light at most.
TEST(VisibilityOnlyDarkens, AllowsRoundingButNoMore) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 0});
  const auto with_excess = [&](float excess) {
    const auto make = [&](Cut cut, const CutConfig&, const MadeCuts::Visible& seen) {
      cut.radiance = glm::vec3(seen(3) ? 1 : 1 + excess);
      return cut;
    };
    return darkening_of(MadeCuts(judged.tree, make), judged).violations;
  };
  EXPECT_EQ(with_excess(0x1p-22F), 0U);
  EXPECT_EQ(with_excess(0x1p-20F), 1U);
}

TEST(VisibilityOnlyDarkens, ConvictsWhatIsNotANumber) {
  EXPECT_EQ(darkening_violations(std::nanf(""), {0, 1, 1, 1}), 1U);
}

} // namespace
} // namespace lightcuts::oracle
