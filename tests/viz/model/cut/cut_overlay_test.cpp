// SPDX-License-Identifier: MIT
#include <viz/model/cut/cut_overlay.h>

#include <algorithm>
#include <limits>
#include <set>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/support/float_limits.h>

namespace lightcuts::viz {
namespace {

using testing::Each;
using testing::Field;
using testing::SizeIs;

constexpr glm::vec3 shaded_at{1, 2, 3}, up{0, 0, 1}, none{0};

/// A unit cube shaded_at x = node, its representative in the middle.
ClusterRow boxed_row(std::uint32_t node, float bound) {
  ClusterRow r;
  r.node = node;
  r.lights = 10;
  r.representative = node;
  r.bound = glm::vec3(bound);
  r.box = {{float(node), 0, 0}, {float(node) + 1, 1, 1}};
  r.has_box = true;
  r.representative_position = {float(node) + 0.5F, 0.5F, 0.5F};
  return r;
}

OverlayOptions by_bound() { return {.colour_by = ClusterColour::bound}; }
OverlayOptions only_boxes() { return {.colour_by = ClusterColour::bound, .lines = false}; }
OverlayOptions only_lines() { return {.boxes = false}; }

TEST(CutOverlay, DrawsTheTwelveEdgesOfABox) {
  const std::vector<ClusterRow> rows{boxed_row(5, 1)};
  const Overlay overlay = overlay_of(shaded_at, none, rows, only_boxes());
  ASSERT_THAT(overlay.lines, SizeIs(12));
  std::set<std::array<float, 6>> edges;
  for (const ColouredLine& line : overlay.lines) {
    EXPECT_EQ(glm::length(line.a - line.b), 1);
    EXPECT_TRUE(rows[0].box.contains(line.a) && rows[0].box.contains(line.b));
    edges.insert({line.a.x, line.a.y, line.a.z, line.b.x, line.b.y, line.b.z});
  }
  EXPECT_THAT(edges, SizeIs(12)) << "no two alike";
}

TEST(CutOverlay, DrawsNoBoxWhereThereIsNoneOrNoExtent) {
  std::vector<ClusterRow> rows{boxed_row(1, 1), boxed_row(2, 1)};
  rows[0].has_box = false;
  rows[1].box.hi = rows[1].box.lo;
  EXPECT_THAT(overlay_of(shaded_at, none, rows, only_boxes()).lines, SizeIs(0));
}

TEST(CutOverlay, DrawsTheBoxesOfTheLargestValuesTheLargestOnTop) {
  const std::vector<ClusterRow> rows{boxed_row(0, 3), boxed_row(1, 1), boxed_row(2, 5),
                                     boxed_row(3, 2)};
  OverlayOptions options = only_boxes();
  options.most_boxes = 2;
  const Overlay overlay = overlay_of(shaded_at, none, rows, options);
  ASSERT_THAT(overlay.lines, SizeIs(24));
  EXPECT_EQ(overlay.lines[0].a.x, 0);
  EXPECT_EQ(overlay.lines[12].a.x, 2);
}

TEST(CutOverlay, ColoursBoxesByTheirValue) {
  const std::vector<ClusterRow> rows{boxed_row(0, 1), boxed_row(1, 100)};
  const Overlay overlay = overlay_of(shaded_at, none, rows, only_boxes());
  const HeatMapScale scale = cluster_scale(rows, ClusterColour::bound);
  EXPECT_EQ(overlay.lines.front().colour, cluster_colour(1.0, scale));
  EXPECT_EQ(overlay.lines.back().colour, cluster_colour(100.0, scale));
  EXPECT_NE(overlay.lines.front().colour, overlay.lines.back().colour);
}

TEST(CutOverlay, IsGreyWhereTheErrorIsNotKnown) {
  const std::vector<ClusterRow> rows{boxed_row(0, 1)};
  const Overlay overlay = overlay_of(shaded_at, none, rows, {.lines = false});
  EXPECT_THAT(overlay.lines, Each(Field(&ColouredLine::colour, unknown_colour)));
}

TEST(CutOverlay, DrawsLinesToRepresentativesThatTellWhetherTheyAreSeen) {
  std::vector<ClusterRow> rows{boxed_row(0, 1), boxed_row(1, 1), boxed_row(2, 1)};
  rows[1].visible = false;
  rows[2].representative = oracle::TreeClaim::unsaid;
  const Overlay overlay = overlay_of(shaded_at, none, rows, only_lines());
  ASSERT_THAT(overlay.lines, SizeIs(2));
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(overlay.lines[i].a, shaded_at);
    EXPECT_EQ(overlay.lines[i].b, rows[i].representative_position);
  }
  EXPECT_EQ(overlay.lines[0].colour, seen_colour);
  EXPECT_EQ(overlay.lines[1].colour, blocked_colour);
  EXPECT_THAT(overlay.points, SizeIs(3)) << "and the shading point";
}

TEST(CutOverlay, DrawsLinesThatTellHowItWasFoundWhatIsSeen) {
  std::vector<ClusterRow> rows{boxed_row(0, 1), boxed_row(1, 1), boxed_row(2, 1), boxed_row(3, 1)};
  for (std::uint32_t i = 0; i < rows.size(); ++i) rows[i].sight = Sight(i);
  rows[1].visible = false;
  const Overlay overlay = overlay_of(shaded_at, none, rows, only_lines());
  ASSERT_THAT(overlay.lines, SizeIs(4));
  const Rgba8 expected[] = {proven_seen_colour, proven_hidden_colour, seen_colour, share_colour};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(overlay.lines[i].colour, expected[i]) << i;
}

TEST(CutOverlay, DrawsTheNormalAsAnArrowAsLongAsFitsTheScene) {
  OverlayOptions options;
  options.scene_diagonal = 100;
  for (const glm::vec3& normal : {up, -up, glm::vec3(1, 0, 0), glm::vec3(0.6F, -0.8F, 0)}) {
    const Overlay overlay = overlay_of(shaded_at, normal, {}, options);
    ASSERT_THAT(overlay.lines, SizeIs(5));
    EXPECT_EQ(overlay.lines[0].a, shaded_at);
    EXPECT_LT(glm::length(overlay.lines[0].b - (shaded_at + 5.0F * normal)), 1e-5);
    for (int i = 1; i < 5; ++i) {
      EXPECT_EQ(overlay.lines[i].a, overlay.lines[0].b);
      EXPECT_NEAR(glm::length(overlay.lines[i].b - overlay.lines[i].a), 1.077, 1e-3);
    }
  }
  EXPECT_THAT(overlay_of(shaded_at, none, {}, options).lines, SizeIs(0));
}

TEST(CutOverlay, DrawsTheSelectedClusterOnTopBrighterAndThicker) {
  const std::vector<ClusterRow> rows{boxed_row(0, 1), boxed_row(1, 2), boxed_row(2, 3)};
  OverlayOptions options = by_bound();
  options.selected = 0;
  options.most_boxes = 1;
  const Overlay overlay = overlay_of(shaded_at, none, rows, options);
  const std::size_t n = overlay.lines.size();
  ASSERT_EQ(n, 12U + 2U + 12U + 1U) << "box 2, lines 1 and 2, then those of 0";
  for (std::size_t i = 14; i < 26; ++i) {
    EXPECT_EQ(overlay.lines[i].colour, selected_colour);
    EXPECT_GT(overlay.lines[i].width, overlay.lines[0].width);
  }
  EXPECT_GT(overlay.lines.back().width, overlay.lines[12].width);
  EXPECT_EQ(overlay.points.back().colour, selected_colour);
}

TEST(CutOverlay, DrawsTheSelectedClusterEvenWhereNothingElseIsAskedFor) {
  const std::vector<ClusterRow> rows{boxed_row(0, 1), boxed_row(1, 2)};
  const OverlayOptions options{.selected = 1, .boxes = false, .lines = false};
  EXPECT_THAT(overlay_of(shaded_at, none, rows, options).lines, SizeIs(13));
}

TEST(ClusterScale, GoesFromTheSmallestToTheLargestValue) {
  const std::vector<ClusterRow> rows{boxed_row(0, 3), boxed_row(1, 8), boxed_row(2, 0),
                                     boxed_row(3, 0.5F), boxed_row(4, 1)};
  const HeatMapScale scale = cluster_scale(rows, ClusterColour::bound);
  EXPECT_EQ(scale.lo, 0.5F);
  EXPECT_EQ(scale.hi, 8);
  EXPECT_TRUE(scale.logarithmic);
}

TEST(ClusterScale, HasFourDecadesAtMostAndNoInfinity) {
  const std::vector<ClusterRow> rows{boxed_row(0, 1e-20F), boxed_row(1, 8),
                                     boxed_row(2, std::numeric_limits<float>::infinity()),
                                     boxed_row(3, std::numeric_limits<float>::quiet_NaN())};
  const HeatMapScale scale = cluster_scale(rows, ClusterColour::bound);
  EXPECT_FLOAT_EQ(scale.lo, 8e-4F);
  EXPECT_EQ(scale.hi, 8);
  EXPECT_EQ(cluster_scale({}, ClusterColour::error).hi, 1);
}

TEST(ClusterColours, MarkWhatIsNoNumber) {
  const HeatMapScale scale{1, 100, true};
  EXPECT_EQ(cluster_colour(std::nullopt, scale), unknown_colour);
  EXPECT_EQ(cluster_colour(std::nan(""), scale), Rgba8(nan_colour, 255));
  EXPECT_EQ(cluster_colour(inf, scale), Rgba8(infinity_colour, 255));
  EXPECT_EQ(cluster_colour(0.0, scale), cluster_colour(1.0, scale));
  const Rgba8 dark = cluster_colour(0.0, scale);
  EXPECT_GT(int(dark.r) + dark.g + dark.b, 100) << "to be seen";
}

} // namespace
} // namespace lightcuts::viz
