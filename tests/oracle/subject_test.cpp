// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/subject.h>

#include <gtest/gtest.h>
#include <lightcuts/input_error.h>

#include "judged_point.h"

namespace lightcuts::oracle {
namespace {

struct DoubledBound : LightcutsRules {
  template <class OneLobe>
  static glm::vec3 bound(const LightTree& tree, std::uint32_t node, const ShadingPoint& point,
                         const OneLobe& lobe) {
    return 2.0F * LightcutsRules::bound(tree, node, point, lobe);
  }
};

const auto second_is_hidden = [](std::uint32_t light) { return light != 1; };

TEST(RulesSubject, HasTheBoundOfItsRules) {
  const LightTree tree = four_lights();
  const RulesSubject<DoubledBound> subject("doubled", tree);
  EXPECT_EQ(subject.name(), "doubled");
  EXPECT_EQ(&subject.tree(), &tree);
  EXPECT_EQ(subject.bound(0, diffuse_point()),
            2.0F * contribution_bound(tree, 0, diffuse_point(), NoLobe()));
}

TEST(RulesSubject, SelectsWithItsRulesConfigurationAndVisibility) {
  const LightTree tree = four_lights();
  const RulesSubject<DoubledBound> subject("doubled", tree);
  const CutConfig config{0.1F, 3};
  BasicCutSelector<DoubledBound> own(tree, config);
  const Cut expected = own(diffuse_point(), second_is_hidden);
  const auto selector = subject.selector(config);
  for (int again = 0; again < 2; ++again) {
    const Cut cut = selector->select(diffuse_point(), second_is_hidden);
    EXPECT_EQ(cut.radiance, expected.radiance);
    EXPECT_EQ(cut.certified_error, expected.certified_error);
    EXPECT_EQ(cut.clusters.size(), 3U);
    EXPECT_EQ(cut.shadow_rays, expected.shadow_rays);
    EXPECT_EQ(cut.end, CutEnd::max_size);
  }
}

TEST(RulesSubject, RefusesWhatTheSelectorRefuses) {
  const LightTree tree = four_lights();
  const RulesSubject<LightcutsRules> subject("lightcuts", tree);
  EXPECT_THROW((void)subject.selector({-1, 1}), InputError);
  EXPECT_THROW((void)subject.selector({0.02F, 0}), InputError);
}

} // namespace
} // namespace lightcuts::oracle
