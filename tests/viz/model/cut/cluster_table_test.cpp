// SPDX-License-Identifier: MIT
#include <viz/model/cut/cluster_table.h>

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/support/float_limits.h>

namespace lightcuts::viz {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Column = ClusterColumn;

ClusterRow row(std::uint32_t node, std::uint32_t lights, double share = 0) {
  ClusterRow r;
  r.node = node;
  r.lights = lights;
  r.share = share;
  return r;
}

std::vector<std::uint32_t> filtered(const std::vector<ClusterRow>& rows, std::string_view text) {
  const FilterReading reading = read_filter(text);
  EXPECT_EQ(reading.error, "") << text;
  return sorted_and_filtered(rows, Column::node, false, reading.filter);
}

TEST(ClusterRow, ErrsByTheSumOfItsChannelsOnceTheTruthIsKnown) {
  ClusterRow r;
  r.estimate = {1, 2, 3};
  EXPECT_EQ(error(r), std::nullopt);
  r.truth = {1.5, 1, 3};
  EXPECT_EQ(error(r), 1.5);
}

TEST(ClusterTable, HasANameAndAFormulaForEveryColumn) {
  for (int i = 0; i < cluster_column_count; ++i) {
    EXPECT_FALSE(info_of(Column(i)).name.empty());
    EXPECT_FALSE(info_of(Column(i)).help.empty());
  }
  EXPECT_EQ(info_of(Column::share).name, "share");
  EXPECT_EQ(info_of(Column::intensity).unit, "W/sr");
}

TEST(ClusterTable, MakesOneNumberOfEachColumn) {
  ClusterRow r;
  r.node = 1;
  r.depth = 2;
  r.lights = 3;
  r.intensity = {4, 5, 6};
  r.distance = 8;
  r.bound = {1, 9, 2};
  r.estimate = {1, 2, 3};
  r.share = 0.5;
  EXPECT_EQ(scalar_of(r, Column::node), 1);
  EXPECT_EQ(scalar_of(r, Column::depth), 2);
  EXPECT_EQ(scalar_of(r, Column::lights), 3);
  EXPECT_EQ(scalar_of(r, Column::intensity), 15);
  EXPECT_EQ(scalar_of(r, Column::representative), std::nullopt);
  EXPECT_EQ(scalar_of(r, Column::distance), 8);
  EXPECT_EQ(scalar_of(r, Column::bound), 9);
  EXPECT_EQ(scalar_of(r, Column::estimate), 6);
  EXPECT_EQ(scalar_of(r, Column::truth), std::nullopt);
  EXPECT_EQ(scalar_of(r, Column::error), std::nullopt);
  EXPECT_EQ(scalar_of(r, Column::share), 0.5);
  r.representative = 7;
  r.truth = {1, 1, 1};
  EXPECT_EQ(scalar_of(r, Column::representative), 7);
  EXPECT_EQ(scalar_of(r, Column::truth), 3);
  EXPECT_EQ(scalar_of(r, Column::error), 3);
}

TEST(ClusterTable, TakesABoundWithANaNForNaN) {
  for (int c = 0; c < 3; ++c) {
    ClusterRow r;
    r.bound = glm::vec3(1);
    r.bound[c] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(*scalar_of(r, Column::bound)));
  }
}

TEST(ClusterTable, SortsEitherWayAndLeavesEqualRowsInTheirOrder) {
  const std::vector<ClusterRow> rows{row(9, 2), row(8, 1), row(7, 2), row(6, 3)};
  EXPECT_THAT(sorted_and_filtered(rows, Column::lights, false, {}), ElementsAre(1, 0, 2, 3));
  EXPECT_THAT(sorted_and_filtered(rows, Column::lights, true, {}), ElementsAre(3, 0, 2, 1));
  EXPECT_THAT(sorted_and_filtered(rows, Column::node, false, {}), ElementsAre(3, 2, 1, 0));
}

TEST(ClusterTable, PutsNaNAndWhatIsNotKnownLastEitherWay) {
  const std::vector<ClusterRow> rows{row(0, 1, nan), row(1, 1, inf), row(2, 1, nan), row(3, 1, -1)};
  EXPECT_THAT(sorted_and_filtered(rows, Column::share, false, {}), ElementsAre(3, 1, 0, 2));
  EXPECT_THAT(sorted_and_filtered(rows, Column::share, true, {}), ElementsAre(1, 3, 0, 2));

  std::vector<ClusterRow> partly{row(0, 1), row(1, 1), row(2, 1)};
  partly[1].truth = {1, 1, 1};
  partly[2].truth = {2, 2, 2};
  EXPECT_THAT(sorted_and_filtered(partly, Column::truth, false, {}), ElementsAre(1, 2, 0));
  EXPECT_THAT(sorted_and_filtered(partly, Column::error, true, {}), ElementsAre(2, 1, 0));
}

TEST(ClusterFilter, KeepsRowsForWhichAllConditionsHold) {
  const std::vector<ClusterRow> rows{row(0, 5, 0.1), row(1, 10, 0.2), row(2, 20, 1e-3),
                                     row(3, 40, 0.4)};
  EXPECT_THAT(filtered(rows, ""), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(filtered(rows, "lights>10"), ElementsAre(2, 3));
  EXPECT_THAT(filtered(rows, "lights>=10"), ElementsAre(1, 2, 3));
  EXPECT_THAT(filtered(rows, "lights<10"), ElementsAre(0));
  EXPECT_THAT(filtered(rows, "lights<=10"), ElementsAre(0, 1));
  EXPECT_THAT(filtered(rows, "node=2"), ElementsAre(2));
  EXPECT_THAT(filtered(rows, "node!=2"), ElementsAre(0, 1, 3));
  EXPECT_THAT(filtered(rows, "  lights>5\tshare>1e-3 "), ElementsAre(1, 3));
  EXPECT_THAT(filtered(rows, "lights>5 lights<10"), IsEmpty());
  EXPECT_THAT(filtered(rows, "share<inf share>-inf"), ElementsAre(0, 1, 2, 3));
}

TEST(ClusterFilter, KnowsWhichRepresentativesAreSeen) {
  std::vector<ClusterRow> rows{row(0, 1), row(1, 1)};
  rows[1].visible = false;
  EXPECT_THAT(filtered(rows, "visible"), ElementsAre(0));
  EXPECT_THAT(filtered(rows, "hidden"), ElementsAre(1));
  EXPECT_THAT(filtered(rows, "hidden visible"), IsEmpty());
}

TEST(ClusterFilter, KnowsHowTheirVisibilityWasFoundByName) {
  std::vector<ClusterRow> rows{row(0, 1), row(1, 1), row(2, 1), row(3, 1), row(4, 1)};
  for (std::uint32_t i = 0; i < sight_names.size(); ++i) rows[i].sight = Sight(i);
  EXPECT_THAT(filtered(rows, "sight=seen"), ElementsAre(0));
  EXPECT_THAT(filtered(rows, "sight=hidden"), ElementsAre(1));
  EXPECT_THAT(filtered(rows, "sight!=ray"), ElementsAre(0, 1, 3)); // not of what nobody knows
  EXPECT_THAT(filtered(rows, "sight=share node=3"), ElementsAre(3));
  EXPECT_EQ(scalar_of(rows[4], Column::sight), std::nullopt);
  EXPECT_THAT(read_filter("sight=3").error,
              HasSubstr("\"sight=3\": ends in none of seen hidden ray share"));
}

TEST(ClusterFilter, AcceptsNoNaNAndNothingUnknown) {
  const std::vector<ClusterRow> rows{row(0, 1, nan)};
  for (const char* text : {"share<1", "share>1", "share=1", "share!=1", "error>=0", "truth!=1"})
    EXPECT_THAT(filtered(rows, text), IsEmpty()) << text;
}

TEST(ClusterFilter, NamesTheWordItCannotRead) {
  const auto problem = [](std::string_view text) { return read_filter(text).error; };
  EXPECT_THAT(problem("lights>1 size>2"), HasSubstr("\"size>2\": not one of node depth"));
  EXPECT_THAT(problem("lights>1 lights"), HasSubstr("\"lights\": after the name"));
  EXPECT_THAT(problem("lights=>1"), HasSubstr("\"lights=>1\": after the name"));
  EXPECT_THAT(problem("lights>"), HasSubstr("\"lights>\": ends in no number"));
  EXPECT_THAT(problem("lights>1x"), HasSubstr("\"lights>1x\": ends in no number"));
  EXPECT_THAT(problem("lights>nan"), HasSubstr("\"lights>nan\": ends in no number"));
  EXPECT_THAT(problem("lights > 10"), HasSubstr("\"lights\": after the name"));
  EXPECT_THAT(problem(">10"), HasSubstr("\">10\": not one of"));
  EXPECT_THAT(problem("invisible"), HasSubstr("\"invisible\": not one of"));
}

TEST(ClusterFilter, GoesByTheWordsBeforeTheOneItCannotRead) {
  const std::vector<ClusterRow> rows{row(0, 5), row(1, 10)};
  const FilterReading reading = read_filter("lights>5 lig lights>10");
  EXPECT_NE(reading.error, "");
  EXPECT_THAT(sorted_and_filtered(rows, Column::node, false, reading.filter), ElementsAre(1));
}

} // namespace
} // namespace lightcuts::viz
