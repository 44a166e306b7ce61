// SPDX-License-Identifier: MIT
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <tests/oracle/support/judged_point.h>
#include <tests/support/cut_promises.h>
#include <tests/support/float_limits.h>

namespace lightcuts::oracle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

constexpr auto cut_partitions = Property::cut_partitions_lights;
constexpr auto obeys = Property::cut_obeys_threshold;
constexpr auto certified = Property::certified_error_holds;
constexpr auto exact_at_zero = Property::zero_threshold_is_exact;
constexpr auto drift = Property::total_does_not_drift;
constexpr auto finite_cuts = Property::results_are_finite;

/// The library's cut of the four lights at a point, for a test to spoil.
struct CutToSpoil {
  JudgedPoint judged{four_lights(), diffuse_point({0.25F, 0, 0}), {1, 1, 1, 1}};
  CutConfig config;
  std::vector<CutCluster> clusters;
  Cut cut;

  explicit CutToSpoil(const CutConfig& c) : config(c) {
    CutSelector select(judged.tree, config);
    cut = select(judged.point, [](std::uint32_t) { return true; });
    clusters.assign(cut.clusters.begin(), cut.clusters.end());
  }

  [[nodiscard]] std::vector<Property> violated() {
    cut.clusters = clusters;
    LibraryTree library = judged.library();
    return oracle::violated(
        judged_at(library, judged, [this](const Judge& judge, const PointAnswers& of) {
          judge.cut(of, config, cut);
        }));
  }

  /// Sets radiance and certified error to what the clusters make of them.
  void sum_anew() {
    glm::dvec3 total(0), bounds(0);
    for (const CutCluster& c : clusters) {
      total += c.estimate;
      bounds += glm::dvec3(c.bound);
    }
    for (int c = 0; c < 3; ++c) {
      cut.radiance[c] = to_float(total[c]);
      cut.certified_error[c] = certified_error(total[c], bounds[c]);
    }
  }
};

constexpr CutConfig two_clusters{0, 2};
constexpr CutConfig all_lights{0, 1000};

RC_GTEST_PROP(CutProperties, HoldForTheLibrary, ()) {
  const CutCase given = *cut_case();
  std::vector<char> visible;
  for (std::uint32_t i = 0; i < given.scene.lights.size(); ++i)
    visible.push_back(given.visibility()(i) ? 1 : 0);
  const JudgedPoint judged(build(given.scene.light_set()), given.scene.view.point(), visible);
  LibraryTree library = judged.library();
  const Tally tally = judged_at(library, judged, [&](const Judge& judge, const PointAnswers& of) {
    judge.cuts(of, {&given.config, 1});
  });
  for (const Property p : all_properties) RC_ASSERT(tally[p].first_violation == "");
  for (const Property p : {cut_partitions, obeys, certified, drift, finite_cuts})
    RC_ASSERT(tally[p].cases == 1U);
}

TEST(CutProperties, HoldForUnspoiltCuts) {
  EXPECT_THAT(CutToSpoil(two_clusters).violated(), IsEmpty());
  EXPECT_THAT(CutToSpoil(all_lights).violated(), IsEmpty());
}

TEST(CutProperties, ConvictALostLight) {
  CutToSpoil spoilt(all_lights);
  spoilt.clusters.pop_back();
  spoilt.sum_anew();
  EXPECT_THAT(spoilt.violated(), ElementsAre(cut_partitions, certified, exact_at_zero));
}

TEST(CutProperties, ConvictALostClusterEvenWhereItsLightIsCertified) {
  CutToSpoil spoilt(two_clusters);
  spoilt.clusters.pop_back();
  spoilt.sum_anew();
  spoilt.cut.certified_error = glm::vec3(1e6F);
  EXPECT_THAT(spoilt.violated(), Contains(cut_partitions));
}

TEST(CutProperties, ConvictNoClusterAtAll) {
  CutToSpoil spoilt(two_clusters);
  spoilt.clusters.clear();
  EXPECT_THAT(spoilt.violated(), Contains(cut_partitions));
}

TEST(CutProperties, ConvictADoubledCluster) {
  CutToSpoil spoilt(all_lights);
  spoilt.clusters.push_back(spoilt.clusters.front());
  spoilt.sum_anew();
  EXPECT_THAT(spoilt.violated(), ElementsAre(cut_partitions, certified, exact_at_zero));
}

TEST(CutProperties, ConvictAClusterInsideAnother) {
  CutToSpoil spoilt({0, 1});
  ASSERT_EQ(spoilt.clusters.size(), 1U);
  spoilt.clusters.push_back({1, true, glm::dvec3(0), glm::vec3(0)});
  spoilt.config.max_size = 2;
  EXPECT_THAT(spoilt.violated(), ElementsAre(cut_partitions));
}

// To the nearest float is at most half an ulp, which the formula gives as 2^-24: up to one.
TEST(CutProperties, ConvictARadianceThatDrifted) {
  for (const float towards : {0.0F, inf}) {
    CutToSpoil spoilt(two_clusters);
    float& blue = spoilt.cut.radiance.z;
    blue = std::nextafter(std::nextafter(blue, towards), towards);
    EXPECT_THAT(spoilt.violated(), ElementsAre(drift));
  }
}

// The smallest float that is at least the error, then the largest that is not.
TEST(CutProperties, ConvictACertifiedErrorThatIsOneUlpTooSmall) {
  for (int c = 0; c < 3; ++c) {
    CutToSpoil spoilt(two_clusters);
    const Exact error = abs(Exact(spoilt.cut.radiance[c]) - spoilt.judged.truth.exact_seen(0, c));
    float limit = error.convert_to<float>();
    if (limit < error) limit = std::nextafter(limit, inf);
    spoilt.cut.certified_error[c] = limit;
    EXPECT_THAT(spoilt.violated(), IsEmpty());
    spoilt.cut.certified_error[c] = std::nextafter(limit, 0.0F);
    EXPECT_THAT(spoilt.violated(), ElementsAre(certified));
  }
}

TEST(CutProperties, ConvictNumbersThatAreNone) {
  CutToSpoil radiance(two_clusters);
  radiance.cut.radiance.x = std::nanf("");
  EXPECT_THAT(radiance.violated(), ElementsAre(drift, certified, finite_cuts));
  CutToSpoil error(two_clusters);
  error.cut.certified_error.y = std::nanf("");
  EXPECT_THAT(error.violated(), ElementsAre(certified, finite_cuts));
  CutToSpoil negative(two_clusters);
  negative.cut.certified_error.z = -1;
  EXPECT_THAT(negative.violated(), ElementsAre(certified, finite_cuts));
}

TEST(CutProperties, ConvictInfiniteRadiance) {
  CutToSpoil spoilt(two_clusters);
  spoilt.cut.radiance.x = inf;
  EXPECT_THAT(spoilt.violated(), ElementsAre(drift, certified, finite_cuts));
  spoilt.cut.certified_error.x = inf;
  EXPECT_THAT(spoilt.violated(), ElementsAre(drift));
}

TEST(CutProperties, ConvictACutLargerThanTheLargestSize) {
  CutToSpoil spoilt(two_clusters);
  spoilt.config.max_size = 1;
  EXPECT_THAT(spoilt.violated(), ElementsAre(obeys));
}

TEST(CutProperties, ConvictAFalseClaimOfTheLargestSize) {
  CutToSpoil spoilt({1.0F, 1000});
  ASSERT_EQ(spoilt.cut.end, CutEnd::converged);
  spoilt.cut.end = CutEnd::max_size;
  EXPECT_THAT(spoilt.violated(), ElementsAre(obeys));
}

TEST(CutProperties, ConvictACutThatEndedBeforeTheLargestSize) {
  CutToSpoil spoilt(two_clusters);
  ASSERT_EQ(spoilt.cut.end, CutEnd::max_size);
  spoilt.config.max_size = 3;
  EXPECT_THAT(spoilt.violated(), ElementsAre(obeys));
}

TEST(CutProperties, ConvictASilentStopAtTheLargestSize) {
  CutToSpoil spoilt(two_clusters);
  spoilt.cut.end = CutEnd::converged;
  EXPECT_THAT(spoilt.violated(), ElementsAre(obeys));
}

TEST(CutProperties, ConvictABoundOverTheThreshold) {
  CutToSpoil spoilt({1.0F, 1000});
  ASSERT_EQ(spoilt.cut.end, CutEnd::converged);
  ASSERT_LT(spoilt.clusters.size(), 4U);
  EXPECT_THAT(spoilt.violated(), IsEmpty());
  double worst = 0;
  for (const CutCluster& c : spoilt.clusters)
    worst = std::max(worst, double(c.bound.x) / promises::total(spoilt.cut).x);
  spoilt.config.threshold = std::nextafter(static_cast<float>(worst), 2.0F);
  EXPECT_THAT(spoilt.violated(), IsEmpty());
  spoilt.config.threshold = std::nextafter(spoilt.config.threshold, 0.0F);
  spoilt.config.threshold = std::nextafter(spoilt.config.threshold, 0.0F);
  EXPECT_THAT(spoilt.violated(), ElementsAre(obeys));
}

TEST(CutProperties, TakeTheBoundOfTheSubjectNotThatOfTheCut) {
  CutToSpoil spoilt({1.0F, 1000});
  spoilt.config.threshold = 1e-6F;
  for (CutCluster& c : spoilt.clusters) c.bound = glm::vec3(0);
  EXPECT_THAT(spoilt.violated(), Contains(obeys));
}

TEST(CutProperties, AllowBoundsUpToTheBlackLevel) {
  CutToSpoil spoilt({1.0F, 1000});
  spoilt.config.threshold = 0;
  spoilt.config.black_level = 1e6F;
  spoilt.cut.end = CutEnd::black_level;
  EXPECT_THAT(spoilt.violated(), IsEmpty());
  spoilt.config.black_level = 1e-6F;
  EXPECT_THAT(spoilt.violated(), Contains(obeys));
}

TEST(CutProperties, ConvictAnInexactCutAtThresholdZero) {
  CutToSpoil spoilt({1.0F, 1000});
  spoilt.config.threshold = 0;
  EXPECT_THAT(spoilt.violated(), ElementsAre(obeys, exact_at_zero));
}

// With a black level, or too small a size, nothing exact was asked for.
TEST(CutProperties, AskForExactnessOnlyWhereItIsPromised) {
  CutToSpoil spoilt({1.0F, 1000});
  spoilt.config = {0, 1000, 1e6F};
  EXPECT_THAT(spoilt.violated(), Not(Contains(exact_at_zero)));
  spoilt.config = {0, 3, 0};
  EXPECT_THAT(spoilt.violated(), Not(Contains(exact_at_zero)));
}

// All clusters within the threshold, with no help of the black level.
constexpr CutConfig easily_converged{100, 1000};
// Nothing but the black level lets the root pass.
constexpr CutConfig black_enough{0, 1000, 1e30F};

TEST(CutProperties, ConvictAnEndByABlackLevelThatNoClusterNeeds) {
  CutToSpoil spoilt(easily_converged);
  ASSERT_EQ(spoilt.cut.end, CutEnd::converged);
  EXPECT_THAT(spoilt.violated(), IsEmpty());
  spoilt.cut.end = CutEnd::black_level;
  EXPECT_THAT(spoilt.violated(), ElementsAre(obeys));
}

TEST(CutProperties, ConvictAConvergedCutThatNeedsTheBlackLevel) {
  CutToSpoil spoilt(black_enough);
  ASSERT_EQ(spoilt.cut.end, CutEnd::black_level);
  EXPECT_THAT(spoilt.violated(), IsEmpty());
  spoilt.cut.end = CutEnd::converged;
  EXPECT_THAT(spoilt.violated(), ElementsAre(obeys));
}

TEST(CutProperties, ConvictALargestSizeThatNothingWaitedFor) {
  for (CutConfig config : {easily_converged, black_enough}) {
    config.max_size = 1;
    CutToSpoil spoilt(config);
    EXPECT_THAT(spoilt.violated(), IsEmpty());
    spoilt.cut.end = CutEnd::max_size;
    EXPECT_THAT(spoilt.violated(), ElementsAre(obeys));
  }
}

/// A root with so many leaves, which share four lights, bounded by what is far too much.
class EvenLeaves : public SubjectTree {
public:
  explicit EvenLeaves(std::uint32_t leaves) {
    claim_.nodes = {{.first_child = 0, .child_count = leaves}};
    for (std::uint32_t i = 0; i < leaves; ++i) {
      claim_.nodes.push_back({.first_light = i * (4 / leaves), .light_count = 4 / leaves});
      claim_.children.push_back(i + 1);
    }
    claim_.lights = {0, 1, 2, 3};
  }
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<EvenLeaves>(*this);
  }
  [[nodiscard]] TreeClaim claim() const override { return claim_; }
  glm::vec3 bound(std::uint32_t, const ShadingPoint&) override { return glm::vec3(1e9F); }

private:
  TreeClaim claim_;
};

/// What is wrong with a cut of these nodes whose first estimate is so many times the truth.
Tally cut_of(EvenLeaves tree, const std::vector<std::uint32_t>& nodes, double factor,
             const CutConfig& config, CutEnd end) {
  const LightSet lights = four_lights().lights();
  const Topology topology = read_topology(tree.claim(), lights.size()).topology.value();
  const ShadingPoint point = diffuse_point();
  const std::vector<char> visible{1, 0, 1, 1};
  Truth truth;
  truth.evaluate(topology, lights, point, visible);
  std::vector<CutCluster> clusters(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Wide& exact_one = truth.seen(nodes[i]);
    clusters[i].node = nodes[i];
    clusters[i].estimate = glm::dvec3(exact_one[0], exact_one[1], exact_one[2]);
  }
  clusters[0].estimate *= factor;
  Cut cut;
  cut.end = end;
  cut.clusters = clusters;
  Tally tally;
  constexpr Parts parts = only(Part::cuts) | only(Part::bounds);
  Judge(parts, 0, tally, obeys).cut({{tree, parts}, {0, point, visible, truth}}, config, cut);
  return tally;
}

/// Of two leaves.
Tally cut_of_leaves(double factor, float threshold) {
  return cut_of(EvenLeaves(2), {1, 2}, factor, {threshold, 1000}, CutEnd::converged);
}

TEST(LeavesOfSeveralLights, ObeyWhereTheirEstimateDoesWhateverTheirBound) {
  EXPECT_THAT(violated(cut_of_leaves(1, 0)), IsEmpty());
  EXPECT_THAT(violated(cut_of_leaves(1 + 0x1p-25, 0)), IsEmpty());
  EXPECT_THAT(violated(cut_of_leaves(1.01, 0.02F)), IsEmpty());
}

// Their bounds are above the threshold and below the black level.
TEST(LeavesOfSeveralLights, MayNeedTheBlackLevel) {
  EXPECT_THAT(violated(cut_of(EvenLeaves(2), {1, 2}, 1, {0.02F, 1000, 2e9F}, CutEnd::black_level)),
              IsEmpty());
  EXPECT_THAT(violated(cut_of(EvenLeaves(2), {1, 2}, 1, {1e12F, 1000, 2e9F}, CutEnd::black_level)),
              ElementsAre(obeys));
}

TEST(LeavesOfSeveralLights, AreConvictedWhereTheirEstimateIsOffByMoreThanTheThreshold) {
  EXPECT_THAT(violated(cut_of_leaves(1.01, 0)), ElementsAre(obeys));
  EXPECT_THAT(violated(cut_of_leaves(2, 0.02F)), ElementsAre(obeys));
}

TEST(NodesOfManyChildren, EndACutThatTheyWouldMakeTooLarge) {
  const auto root_of = [](std::uint32_t leaves, std::uint32_t max_size) {
    return violated(cut_of(EvenLeaves(leaves), {0}, 1, {0.02F, max_size}, CutEnd::max_size));
  };
  EXPECT_THAT(root_of(4, 1), IsEmpty());
  EXPECT_THAT(root_of(4, 3), IsEmpty());
  EXPECT_THAT(root_of(4, 4), ElementsAre(obeys));
  EXPECT_THAT(root_of(2, 1), IsEmpty());
  EXPECT_THAT(root_of(2, 2), ElementsAre(obeys));
}

} // namespace
} // namespace lightcuts::oracle
