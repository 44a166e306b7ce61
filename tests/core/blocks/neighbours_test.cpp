// SPDX-License-Identifier: MIT
#include <lightcuts/core/blocks/neighbours.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/core/blocks/lit_block.h>

namespace lightcuts {
namespace {

using testing::ElementsAre;

BlockPoint at(const glm::vec3& position, const glm::vec3& normal = {0, 1, 0},
              const Material& material = {}) {
  return {ShadingPoint(position, normal, {0, 1, 0}, material), glm::vec2(0)};
}

TEST(GroupsOfLikeLobes, PartWhatABlockMayNotHaveTogether) {
  const Material diffuse{glm::vec3(0.5F), {}};
  const Material shiny{glm::vec3(0.5F), Phong{glm::vec3(0.5F), 20}};
  const Material darker{glm::vec3(0.1F), Phong{glm::vec3(0.1F), 20}};
  const Material sharper{glm::vec3(0.5F), Phong{glm::vec3(0.5F), 21}};
  const glm::vec3 up(0, 1, 0);
  const std::vector<BlockPoint> points{at({}, up, diffuse), at({}, up, shiny), at({}, up, sharper),
                                       at({}, up, darker), at({}, up, diffuse)};
  EXPECT_THAT(groups_of_like_lobes(points),
              ElementsAre(ElementsAre(0, 4), ElementsAre(1, 3), ElementsAre(2)));
  EXPECT_THAT(groups_of_like_lobes({}), testing::IsEmpty());
}

TEST(Parted, PartsAtTheGapOfTheWidestAxis) {
  const std::vector<BlockPoint> points{at({0, 0, 9}), at({1, 0, 0}), at({0, 2, 0.5F}),
                                       at({0, 0, 8})};
  const auto [near, far] = parted(points, {0, 1, 2, 3});
  EXPECT_THAT(near, ElementsAre(1, 2));
  EXPECT_THAT(far, ElementsAre(0, 3));
}

TEST(Parted, PartsByNormalsWhereTheyDiffer) {
  const std::vector<BlockPoint> points{at({0, 0, 0}, {1, 0, 0}), at({9, 0, 0}, {0, 1, 0}),
                                       at({1, 0, 0}, {0, 1, 0}), at({8, 0, 0}, {1, 0, 0})};
  const auto [near, far] = parted(points, {0, 1, 2, 3});
  EXPECT_THAT(near, ElementsAre(1, 2));
  EXPECT_THAT(far, ElementsAre(0, 3));
}

TEST(Parted, LeavesNeitherPartEmptyWhereAllPointsAreOne) {
  const std::vector<BlockPoint> points(3, at({1, 2, 3}));
  const auto [near, far] = parted(points, {0, 1, 2});
  EXPECT_THAT(near, ElementsAre(0));
  EXPECT_THAT(far, ElementsAre(1, 2));
}

TEST(Parted, CopesWithTheEndsOfTheRange) {
  const std::vector<BlockPoint> points{at({3e38F, 0, 0}), at({-3e38F, 0, 0})};
  const auto [near, far] = parted(points, {0, 1});
  EXPECT_THAT(near, ElementsAre(1));
  EXPECT_THAT(far, ElementsAre(0));
}

} // namespace
} // namespace lightcuts
