// SPDX-License-Identifier: MIT
#include <viz/model/cut/icicle.h>

#include <algorithm>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/jobs/seconds_since.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::viz {
namespace {

using oracle::Topology;
using oracle::TreeClaim;
using testing::ElementsAre;
using testing::IsEmpty;
using Kind = IcicleBlockKind;

Topology read(const TreeClaim& claim) {
  oracle::TopologyReading reading = oracle::read_topology(claim, claim.lights.size());
  EXPECT_EQ(reading.defect, "");
  return std::move(reading.topology).value();
}

std::uint32_t add_leaf(TreeClaim& claim, std::uint32_t lights) {
  TreeClaim::Node leaf{.first_light = std::uint32_t(claim.lights.size()), .light_count = lights};
  for (std::uint32_t i = 0; i < lights; ++i)
    claim.lights.push_back(std::uint32_t(claim.lights.size()));
  claim.nodes.push_back(leaf);
  return std::uint32_t(claim.nodes.size() - 1);
}

void set_children(TreeClaim& claim, std::uint32_t node,
                  const std::vector<std::uint32_t>& children) {
  claim.nodes[node] = {.first_child = std::uint32_t(claim.children.size()),
                       .child_count = std::uint32_t(children.size())};
  claim.children.insert(claim.children.end(), children.begin(), children.end());
}

/// Root 0 over leaf 1 (2 lights), node 2 and leaf 3 (1 light); node 2 over leaves 4 (3) and 5 (2).
Topology eight_lights() {
  TreeClaim claim;
  claim.nodes.resize(1);
  add_leaf(claim, 2);
  claim.nodes.emplace_back();
  add_leaf(claim, 1);
  const std::uint32_t a = add_leaf(claim, 3), b = add_leaf(claim, 2);
  set_children(claim, 0, {1, 2, 3});
  set_children(claim, 2, {a, b});
  return read(claim);
}

/// A root over `leaves` leaves of one light each.
Topology broad(std::uint32_t leaves) {
  TreeClaim claim;
  claim.nodes.resize(1);
  std::vector<std::uint32_t> children;
  for (std::uint32_t i = 0; i < leaves; ++i) children.push_back(add_leaf(claim, 1));
  set_children(claim, 0, children);
  return read(claim);
}

/// Splits the lights below each node in two; left(lights) go to the left.
template <class Left>
Topology binary(std::uint32_t lights, Left&& left) {
  TreeClaim claim;
  claim.nodes.reserve(2 * std::size_t(lights));
  claim.children.reserve(2 * std::size_t(lights));
  std::vector<std::uint32_t> counts{lights};
  claim.nodes.emplace_back();
  for (std::uint32_t node = 0; node < claim.nodes.size(); ++node) {
    const std::uint32_t count = counts[node];
    TreeClaim::Node& n = claim.nodes[node];
    if (count == 1) {
      n = {.first_light = std::uint32_t(claim.lights.size()), .light_count = 1};
      claim.lights.push_back(n.first_light);
      continue;
    }
    n = {.first_child = std::uint32_t(claim.children.size()), .child_count = 2};
    const std::uint32_t part = left(count);
    for (const std::uint32_t child : {part, count - part}) {
      claim.children.push_back(std::uint32_t(claim.nodes.size()));
      claim.nodes.emplace_back();
      counts.push_back(child);
    }
  }
  return read(claim);
}

Topology of_library(int lights) {
  LightSet set;
  for (int i = 0; i < lights; ++i)
    set.add_omni({i * 0.618F - float(int(i * 0.618F)), float(i) / float(lights), float(i % 7)},
                 glm::vec3(float(1 + i % 3)));
  return read(oracle::claim_of(build(set)));
}

auto block(std::uint32_t node, std::uint32_t row, float x0, float x1, Kind kind) {
  return testing::AllOf(testing::Field(&IcicleBlock::node, node),
                        testing::Field(&IcicleBlock::row, row),
                        testing::Field(&IcicleBlock::x0, testing::FloatEq(x0)),
                        testing::Field(&IcicleBlock::x1, testing::FloatEq(x1)),
                        testing::Field(&IcicleBlock::kind, kind));
}

constexpr IcicleView eighty{.width = 80, .rows = 10, .row_height = 10};

TEST(Icicle, DrawsEachNodeAsWideAsItsShareOfTheLightsBelowItsParent) {
  const Icicle icicle(eight_lights());
  EXPECT_EQ(icicle.depth(), 3U);
  EXPECT_THAT(
      icicle.blocks(eighty),
      ElementsAre(block(0, 0, 0, 80, Kind::above_cut), block(1, 1, 0, 20, Kind::above_cut),
                  block(2, 1, 20, 70, Kind::above_cut), block(3, 1, 70, 80, Kind::above_cut),
                  block(4, 2, 20, 50, Kind::above_cut), block(5, 2, 50, 70, Kind::above_cut)));
}

TEST(Icicle, TellsWhatIsAboveInAndBelowACut) {
  const Icicle icicle(eight_lights());
  const std::vector<std::uint32_t> nodes{3, 2, 1};
  std::vector<Kind> kinds;
  for (const IcicleBlock& b : icicle.blocks(eighty, icicle.cut(nodes))) kinds.push_back(b.kind);
  EXPECT_THAT(kinds, ElementsAre(Kind::above_cut, Kind::cut, Kind::cut, Kind::cut, Kind::below_cut,
                                 Kind::below_cut));
}

TEST(Icicle, TakesNodesBesideACutOfSomeLightsForAboveIt) {
  const Icicle icicle(eight_lights());
  for (const std::uint32_t node : {1U, 4U})
    for (const IcicleBlock& b : icicle.blocks(eighty, icicle.cut({&node, 1})))
      EXPECT_EQ(b.kind, b.node == node ? Kind::cut : Kind::above_cut) << b.node << ", " << node;
}

TEST(Icicle, LeavesOutWhatIsOutsideTheWindow) {
  const Icicle icicle(eight_lights());
  IcicleView view = eighty;
  view.x0 = 0.25;
  view.x1 = 0.5;
  view.first_row = 1;
  EXPECT_THAT(icicle.blocks(view), ElementsAre(block(2, 0, 0, 80, Kind::above_cut),
                                               block(4, 1, 0, 80, Kind::above_cut)));
  view.rows = 1;
  EXPECT_THAT(icicle.blocks(view), ElementsAre(block(2, 0, 0, 80, Kind::above_cut)));
  view.first_row = 99;
  EXPECT_THAT(icicle.blocks(view), IsEmpty());
}

TEST(Icicle, MergesNeighboursNarrowerThanAPixel) {
  const Icicle icicle(broad(1000));
  IcicleView view{.width = 100, .rows = 5};
  std::vector<IcicleBlock> blocks = icicle.blocks(view);
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_THAT(blocks[1], block(1, 1, 0, 100, Kind::merged));
  EXPECT_EQ(blocks[1].lights, 1000U);

  view.x0 = 0.2505;
  view.x1 = 0.4505;
  blocks = icicle.blocks(view);
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks[1].node, 251U);
  EXPECT_EQ(blocks[1].lights, 201U) << "with the two that are there in part";
}

TEST(Icicle, CountsTheCutsNodesThatAMergedRunHides) {
  const Icicle icicle(binary(1024, [](std::uint32_t n) { return n / 2; }));
  const IcicleView view{.width = 100, .rows = 20};
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t i = 1023; i < 2047; ++i) leaves.push_back(i);
  std::vector<IcicleBlock> blocks = icicle.blocks(view, icicle.cut(leaves));
  EXPECT_EQ(blocks.back().kind, Kind::merged);
  EXPECT_EQ(blocks.back().depth, 7U);
  EXPECT_EQ(blocks.back().cut_nodes, 1024U);

  const std::vector<std::uint32_t> halves{1, 2};
  blocks = icicle.blocks(view, icicle.cut(halves));
  EXPECT_EQ(blocks.back().cut_nodes, 0U) << "it is below them";
}

/// What is drawn of a tree, one node after the other.
struct Plain {
  std::vector<std::uint32_t> wide; ///< nodes
  std::uint64_t narrow_lights = 0;
};

void add_plain(const Topology& tree, const IcicleView& view, std::uint32_t node, double begin,
               Plain& out) {
  const double total = tree.light_count(0), count = tree.light_count(node);
  if (begin + count <= view.x0 * total || begin >= view.x1 * total) return;
  if (count < (view.x1 - view.x0) * total / view.width) {
    out.narrow_lights += tree.light_count(node);
    return;
  }
  out.wide.push_back(node);
  for (const std::uint32_t child : tree.children(node)) {
    add_plain(tree, view, child, begin, out);
    begin += tree.light_count(child);
  }
}

TEST(Icicle, DrawsAllThatAPlainWalkThroughTheTreeFinds) {
  const Topology tree = of_library(3000);
  const Icicle icicle(tree);
  for (const double x0 : {0.0, 0.1234, 0.777}) {
    const IcicleView view{.x0 = x0, .x1 = x0 + 0.2, .width = 110, .rows = 1000};
    Plain plain;
    add_plain(tree, view, 0, 0, plain);
    std::vector<std::uint32_t> wide;
    std::uint64_t narrow_lights = 0;
    for (const IcicleBlock& b : icicle.blocks(view))
      if (b.kind == Kind::merged)
        narrow_lights += b.lights;
      else
        wide.push_back(b.node);
    EXPECT_THAT(wide, testing::UnorderedElementsAreArray(plain.wide));
    EXPECT_EQ(narrow_lights, plain.narrow_lights);
    EXPECT_GT(narrow_lights, 50U);
  }
}

TEST(Icicle, DrawsTheBlocksOfARowSideBySide) {
  const Icicle icicle(of_library(3000));
  const IcicleView view{.x0 = 0.1234, .x1 = 0.3, .width = 300, .rows = 1000};
  float x = 0;
  std::uint32_t row = 0;
  for (const IcicleBlock& b : icicle.blocks(view)) {
    if (b.row != row) x = 0;
    row = b.row;
    EXPECT_GE(b.x0, x) << "in row " << row;
    EXPECT_GT(b.x1, b.x0);
    EXPECT_LE(b.x1, 300);
    x = b.x1;
  }
  EXPECT_GT(row, 5U);
}

TEST(Icicle, ShowsTheSameRowsFromWhicheverOneItBegins) {
  const Icicle icicle(of_library(3000));
  IcicleView view{.x0 = 0.2, .x1 = 0.7, .width = 500, .rows = 100};
  const std::vector<IcicleBlock> all = icicle.blocks(view);
  for (std::uint32_t first = 1; first < 12; ++first) {
    view.first_row = first;
    std::vector<std::uint32_t> expected, found;
    for (const IcicleBlock& b : all)
      if (b.depth >= first) expected.push_back(b.node);
    for (const IcicleBlock& b : icicle.blocks(view)) found.push_back(b.node);
    EXPECT_EQ(found, expected) << "from row " << first;
  }
}

TEST(Icicle, FindsTheNodeUnderAPixel) {
  const Icicle icicle(eight_lights());
  EXPECT_EQ(icicle.node_at(eighty, {79, 9}), 0U);
  EXPECT_EQ(icicle.node_at(eighty, {19.9F, 10}), 1U);
  EXPECT_EQ(icicle.node_at(eighty, {20, 10}), 2U);
  EXPECT_EQ(icicle.node_at(eighty, {49, 25}), 4U);
  EXPECT_EQ(icicle.node_at(eighty, {51, 25}), 5U);
  EXPECT_EQ(icicle.node_at(eighty, {10, 25}), std::nullopt) << "below a leaf";
  EXPECT_EQ(icicle.node_at(eighty, {40, 35}), std::nullopt) << "below all";
  EXPECT_EQ(icicle.node_at(eighty, {80, 5}), std::nullopt) << "to the right";
  EXPECT_EQ(icicle.node_at(eighty, {-1, 5}), std::nullopt) << "to the left";
  EXPECT_EQ(icicle.node_at(eighty, {5, -1}), std::nullopt) << "above";
}

TEST(Icicle, FindsTheVeryNodeOfAMergedRun) {
  const Icicle icicle(broad(1000));
  const IcicleView view{.width = 100, .rows = 5, .row_height = 10};
  for (std::uint32_t i = 0; i < 1000; ++i)
    EXPECT_EQ(icicle.node_at(view, {(float(i) + 0.5F) / 10, 15}), 1 + i);
}

TEST(Icicle, FindsOnlyWhatIsDrawn) {
  const Icicle icicle(binary(1024, [](std::uint32_t n) { return n / 2; }));
  const IcicleView view{.width = 100, .rows = 20, .row_height = 10};
  EXPECT_TRUE(icicle.node_at(view, {50, 75}).has_value());
  EXPECT_EQ(icicle.node_at(view, {50, 85}), std::nullopt) << "below a run";
}

TEST(Icicle, FindsEveryBlockAtItsMiddle) {
  const Icicle icicle(of_library(3000));
  const IcicleView view{.x0 = 0.3, .x1 = 0.31, .width = 500, .first_row = 3, .rows = 100};
  for (const IcicleBlock& b : icicle.blocks(view))
    EXPECT_EQ(icicle.node_at(view, {(b.x0 + b.x1) / 2, (float(b.row) + 0.5F) * view.row_height}),
              b.node);
}

double under(const IcicleView& view, float x) {
  return view.x0 + double(x) / view.width * (view.x1 - view.x0);
}

TEST(Icicle, ZoomKeepsThePointUnderTheCursor) {
  const Icicle icicle(broad(1000000));
  IcicleView view{.x0 = 0.3, .x1 = 0.7, .width = 1000};
  for (const float x : {0.0F, 333.0F, 500.0F, 999.0F}) {
    const double point = under(view, x);
    for (const double factor : {1.1, 2.0, 100.0, 0.9})
      EXPECT_NEAR(under(icicle.zoomed(view, x, factor), x), point, 1e-15) << x << ", " << factor;
    EXPECT_DOUBLE_EQ(icicle.zoomed(view, x, 2).x1 - icicle.zoomed(view, x, 2).x0, 0.2);
  }
}

TEST(Icicle, ZoomEndsAtOneLightAndAtTheWholeTree) {
  const Icicle icicle(broad(1000));
  const IcicleView view{.x0 = 0.3, .x1 = 0.7, .width = 1000};
  const IcicleView near = icicle.zoomed(view, 100, 1e9);
  EXPECT_NEAR(near.x1 - near.x0, 0.001, 1e-15);
  EXPECT_NEAR(under(near, 100), under(view, 100), 1e-15);
  const IcicleView far = icicle.zoomed(view, 100, 1e-9);
  EXPECT_EQ(far.x0, 0);
  EXPECT_EQ(far.x1, 1);
}

TEST(Icicle, PansByPixelsAndRowsWithinTheTree) {
  const Icicle icicle(of_library(3000));
  const IcicleView view{.x0 = 0.3, .x1 = 0.7, .width = 400, .first_row = 3, .rows = 5};
  const IcicleView moved = icicle.panned(view, 100, 2);
  EXPECT_NEAR(moved.x0, 0.2, 1e-12);
  EXPECT_NEAR(moved.x1, 0.6, 1e-12);
  EXPECT_EQ(moved.first_row, 1U);
  const IcicleView right = icicle.panned(view, 1e9F, 99);
  EXPECT_EQ(right.x0, 0);
  EXPECT_NEAR(right.x1, 0.4, 1e-12);
  EXPECT_EQ(right.first_row, 0U);
  const IcicleView left = icicle.panned(view, -1e9F, -9999);
  EXPECT_NEAR(left.x0, 0.6, 1e-12);
  EXPECT_EQ(left.x1, 1);
  EXPECT_EQ(left.first_row, icicle.depth() - 5);
}

TEST(Icicle, ShowsANodeInTheMiddleThird) {
  const Topology tree = of_library(3000);
  const Icicle icicle(tree);
  const IcicleView view{.width = 300, .rows = 4};
  int in_the_middle = 0;
  for (std::uint32_t node = 0; node < tree.size(); ++node) {
    const IcicleView shown = icicle.showing(view, node);
    const glm::dvec2 at = icicle.extent(shown, node);
    EXPECT_GE(shown.x0, 0);
    EXPECT_LE(shown.x1, 1);
    EXPECT_GE(at.x, -1e-6);
    EXPECT_LE(at.y, 300 + 1e-6);
    EXPECT_GE(at.y - at.x, 100 - 1e-6);
    if (std::abs(at.x - 100) < 1e-6 && std::abs(at.y - 200) < 1e-6) ++in_the_middle;
    EXPECT_GE(icicle.depth_of(node), shown.first_row);
    EXPECT_LT(icicle.depth_of(node), shown.first_row + 4);
  }
  EXPECT_GT(in_the_middle, 5900) << "all but those beside an edge";
}

TEST(Icicle, ShowsAllOfTheTree) {
  const Icicle icicle(eight_lights());
  const IcicleView all =
      icicle.whole({.x0 = 0.3, .x1 = 0.4, .width = 77, .first_row = 2, .rows = 2});
  EXPECT_EQ(all.x0, 0);
  EXPECT_EQ(all.x1, 1);
  EXPECT_EQ(all.first_row, 0U);
  EXPECT_EQ(all.width, 77);
}

TEST(Icicle, HasNoBlocksWithoutLights) {
  const Icicle icicle{Topology()};
  EXPECT_EQ(icicle.depth(), 0U);
  EXPECT_THAT(icicle.blocks(eighty), IsEmpty());
  EXPECT_EQ(icicle.node_at(eighty, {5, 5}), std::nullopt);
  EXPECT_EQ(icicle.zoomed(eighty, 5, 2).x1, 1);
  EXPECT_THAT(icicle.blocks(eighty, icicle.cut({})), IsEmpty());
}

TEST(Icicle, PassesOverLeavesWithoutLights) {
  TreeClaim claim;
  claim.nodes.resize(1);
  std::vector<std::uint32_t> children;
  for (const std::uint32_t lights : {0U, 1U, 0U, 0U, 1U, 0U})
    children.push_back(add_leaf(claim, lights));
  set_children(claim, 0, children);
  const Icicle icicle(read(claim));
  const IcicleView view{.width = 2, .rows = 2, .row_height = 1};
  EXPECT_THAT(icicle.blocks(view),
              ElementsAre(block(0, 0, 0, 2, Kind::above_cut), block(2, 1, 0, 1, Kind::above_cut),
                          block(5, 1, 1, 2, Kind::above_cut)));
  EXPECT_EQ(icicle.node_at(view, {0.5F, 1.5F}), 2U);
  EXPECT_EQ(icicle.node_at(view, {1.5F, 1.5F}), 5U);
}

/// The slowest of several views, with a cut of about a thousand nodes.
double slowest_view(const char* name, const Topology& tree) {
  const auto begin = Clock::now();
  const Icicle icicle(tree);
  const double building = 1000 * seconds_since(begin);
  std::vector<std::uint32_t> nodes(tree.parents_first().begin() + 1000,
                                   tree.parents_first().begin() + 2000);
  const IcicleCut cut = icicle.cut(nodes);
  double slowest = 0;
  std::size_t most = 0;
  for (const double zoom : {1.0, 3.0, 50.0, 1000.0, 100000.0})
    for (const std::uint32_t first : {0U, 10U, icicle.depth() / 2}) {
      IcicleView view{.width = 1280, .first_row = first, .rows = 60};
      view = icicle.zoomed(view, 500, zoom);
      double fastest = 1e9; // of three: what else runs on the machine does not count
      for (int repeat = 0; repeat < 3; ++repeat) {
        const auto start = Clock::now();
        most = std::max(most, icicle.blocks(view, cut).size());
        fastest = std::min(fastest, 1000 * seconds_since(start));
      }
      slowest = std::max(slowest, fastest);
    }
  std::printf("%s: %u levels, built in %.0f ms, at most %zu blocks, %.3f ms\n", name,
              icicle.depth(), building, most, slowest);
  return slowest;
}

TEST(Icicle, IsLaidOutWhileAFrameWaits) {
  constexpr std::uint32_t million = 1000000;
  constexpr double lax = 30; // milliseconds: the machine may be busy
  EXPECT_LT(slowest_view("balanced", binary(million, [](auto n) { return n / 2; })), lax);
  EXPECT_LT(slowest_view("uneven", binary(million, [](auto n) { return n - (n + 29) / 30; })), lax);
  EXPECT_LT(slowest_view("comb", binary(million, [](auto) { return 1U; })), lax);
  EXPECT_LT(slowest_view("broad", broad(million)), lax);
}

} // namespace
} // namespace lightcuts::viz
