// SPDX-License-Identifier: MIT
#include <oracle/properties/case_properties.h>

#include <cmath>
#include <limits>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <oracle/truth/naive_tree.h>
#include <tests/oracle/support/made_subject.h>
#include <tests/support/cut_promises.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr std::size_t most_of_naive = 12;

// ---- tree-equals-naive

Tally cost_of(const LightTree& tree) {
  Tally tally;
  const auto topology = read_topology(claim_of(tree), tree.lights().size()).topology;
  check_cost(topology.value(), tree.lights(), 0, tally);
  return tally;
}

LightTree dearest_tree(const LightSet& lights) {
  return naive_tree(lights, [](const auto& a, const auto& b) { return -greedy_metric(a, b); });
}

LightSet row(std::size_t count) {
  LightSet lights;
  for (std::size_t i = 0; i < count; ++i) lights.add_omni({i * i, 0, 1}, glm::vec3(1));
  return lights;
}

RC_GTEST_PROP(TreeEqualsNaive, HoldsForTheLibrary, ()) {
  const auto kind = LightKind(*rc::gen::inRange(0, light_kind_count));
  const LightSet lights = (*gen::scene_of(kind, 0, false, int(most_of_naive))).light_set();
  RC_ASSERT(violated(cost_of(build(lights))).empty());
}

TEST(TreeEqualsNaive, ConvictsATreeThatMergesTheFarthestFirst) {
  for (const std::size_t count : {3, 6, 12}) {
    const Tally tally = cost_of(dearest_tree(row(count)));
    EXPECT_THAT(violated(tally), ElementsAre(Property::tree_equals_naive));
    EXPECT_GT(tally[Property::tree_equals_naive].worst_ratio, 1);
  }
}

// The second merge may be any of two; the one that the definition rules out costs a little more.
TEST(TreeEqualsNaive, ConvictsATreeThatIsOneMergeOff) {
  LightSet lights;
  for (const float x : {0.0F, 1.0F, 2.001F}) lights.add_omni({x, 0, 0}, glm::vec3(1));
  EXPECT_THAT(violated(cost_of(naive_tree(lights,
                                          [](const auto& a, const auto& b) {
                                            return a.first == 1 && b.first == 2
                                                       ? 0
                                                       : greedy_metric(a, b);
                                          }))),
              ElementsAre(Property::tree_equals_naive));
}

TEST(TreeEqualsNaive, IsNotAskedOfManyLightsNorOfSeveralKinds) {
  constexpr auto p = Property::tree_equals_naive;
  EXPECT_EQ(cost_of(build(row(most_of_naive)))[p].cases, 1U);
  EXPECT_EQ(cost_of(build(row(most_of_naive + 1)))[p].cases, 0U);
  LightSet two_kinds = row(2);
  two_kinds.add_directional({0, 0, 1}, glm::vec3(1));
  EXPECT_EQ(cost_of(build(two_kinds))[p].cases, 0U);
}

// ---- cuts

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

Tally nesting_of(SubjectTree&& tree, const JudgedPoint& judged, const CutConfig& cut) {
  Tally tally;
  check_nesting({tree, library_parts}, cut, judged.at(), tally);
  return tally;
}

Tally darkening_of(SubjectTree&& tree, const JudgedPoint& judged) {
  Tally tally;
  check_darkening({tree, library_parts}, judged.at(), tally);
  return tally;
}

RC_GTEST_PROP(CaseProperties, OfCutsHoldForTheLibrary, ()) {
  const CutCase given = *cut_case();
  std::vector<char> visible;
  for (std::uint32_t i = 0; i < given.scene.lights.size(); ++i)
    visible.push_back(given.visibility()(i) ? 1 : 0);
  const JudgedPoint judged(build(given.scene.light_set()), given.scene.view.point(), visible);
  const Tally nesting = nesting_of(judged.library(), judged, given.config);
  RC_ASSERT(nesting[Property::tighter_threshold_refines].first_violation == "");
  RC_ASSERT(nesting[Property::tighter_threshold_refines].cases ==
            (given.config.threshold > 0 ? 1U : 0U));
  const Tally darkening = darkening_of(judged.library(), judged);
  RC_ASSERT(darkening[Property::visibility_only_darkens].first_violation == "");
  RC_ASSERT(darkening[Property::visibility_only_darkens].cases == 1U);
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
  const Tally tally = nesting_of(MadeCuts(judged.tree, make), judged, config);
  EXPECT_EQ(tally[Property::tighter_threshold_refines].cases, 1U);
  return tally[Property::tighter_threshold_refines].violations;
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
  return darkening_of(MadeCuts(judged.tree, make), judged)[Property::visibility_only_darkens]
      .violations;
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
    return darkening_of(MadeCuts(judged.tree, make), judged)[Property::visibility_only_darkens]
        .violations;
  };
  EXPECT_EQ(with_excess(0x1p-22F), 0U);
  EXPECT_EQ(with_excess(0x1p-20F), 1U);
}

TEST(VisibilityOnlyDarkens, ConvictsWhatIsNotANumber) {
  EXPECT_EQ(darkening_violations(std::nanf(""), {0, 1, 1, 1}), 1U);
}

// ---- refinement-order-is-strict

class Ordering : public KernelSubject {
public:
  using Before = bool (*)(double, double);
  explicit Ordering(Before before) : KernelSubject("ordering"), before_(before) {}
  [[nodiscard]] bool refined_before(double bound, double other) const override {
    return before_(bound, other);
  }

private:
  Before before_;
};

std::string fault_of_order(const Subject& subject) {
  Tally tally;
  check_refinement_order(subject, 0, tally);
  EXPECT_EQ(tally[Property::refinement_order_is_strict].cases, 1U);
  return tally[Property::refinement_order_is_strict].first_violation;
}

TEST(RefinementOrderIsStrict, HoldsForTheLibraryAndForAnyStrictOrder) {
  EXPECT_EQ(fault_of_order(*library_subject()), "");
  EXPECT_EQ(fault_of_order(*paper_subject()), "");
  EXPECT_EQ(fault_of_order(Ordering([](double a, double b) { return a < b; })), "");
  EXPECT_EQ(fault_of_order(Ordering([](double, double) { return false; })), "");
}

TEST(RefinementOrderIsStrict, ConvictsTheOrderThatHasEquals) {
  EXPECT_THAT(fault_of_order(Ordering([](double a, double b) { return a >= b; })),
              HasSubstr("each is refined before the other"));
}

// inf - inf is not a number.
TEST(RefinementOrderIsStrict, ConvictsADifferenceThatInfinitySpoils) {
  EXPECT_THAT(fault_of_order(Ordering([](double a, double b) { return !(a - b <= 0); })),
              HasSubstr("bounds inf and inf: each is refined before the other"));
}

TEST(RefinementOrderIsStrict, ConvictsWhatGoesRoundInCircles) {
  EXPECT_THAT(fault_of_order(Ordering([](double a, double b) {
                const auto kind = [](double v) { return v == 0 ? 0 : v < 1 ? 1 : 2; };
                return (kind(a) + 1) % 3 == kind(b);
              })),
              HasSubstr("not before, but something lies between"));
}

TEST(RefinementOrderIsStrict, ConvictsTiesWithinATolerance) {
  EXPECT_THAT(fault_of_order(Ordering([](double a, double b) { return a > b + 1; })),
              HasSubstr("differ, but both tie with a third"));
}

// ---- threads-agree

/// A tree that counts what it is asked, and bends answers by that and by who asks.
class Forgetful : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  enum class Fault {
    none,
    bound_again,
    bound_elsewhere,
    estimate_again,
    cut_again,
    cut_elsewhere
  } fault{};
  bool elsewhere = false;

  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    auto other = std::make_unique<Forgetful>(*this);
    other->elsewhere = true;
    return other;
  }
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    const bool bends = (fault == Fault::bound_again && ++asked_ > 1) ||
                       (fault == Fault::bound_elsewhere && elsewhere && node == 3);
    const glm::vec3 bound = LibraryTree::bound(node, point);
    return bends ? glm::vec3(bound.x, std::nextafter(bound.y, 0.0F), bound.z) : bound;
  }
  glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                      const glm::vec3& bound) override {
    const glm::dvec3 e = LibraryTree::estimate(node, point, bound);
    return fault == Fault::estimate_again ? e * (1 + 0x1p-52 * ++asked_) : e;
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    Cut cut = LibraryTree::select(point, config, visible);
    if (fault == Fault::cut_again && ++asked_ > 1) cut.certified_error *= 2.0F;
    if (fault == Fault::cut_elsewhere && elsewhere) cut.clusters = cut.clusters.subspan(1);
    return cut;
  }

private:
  int asked_ = 0;
};

PropertyCount agreement_of(Forgetful::Fault fault, Parts parts = library_parts) {
  const JudgedPoint judged(four_lights(), diffuse_point({0.25F, 0, 0}), {1, 1, 0, 1});
  Forgetful tree(judged.tree);
  tree.fault = fault;
  Tally tally;
  check_agreement({tree, parts}, {0.02F, 3}, judged.at(), tally);
  EXPECT_EQ(tally[Property::threads_agree].cases, 1U);
  return tally[Property::threads_agree];
}

TEST(ThreadsAgree, HoldsForTheLibrary) {
  EXPECT_EQ(agreement_of(Forgetful::Fault::none).violations, 0U);
}

TEST(ThreadsAgree, ConvictsAnotherAnswerTheSecondTime) {
  EXPECT_THAT(agreement_of(Forgetful::Fault::bound_again).first_violation,
              HasSubstr("another bound of node 0 from the same tree, asked again"));
  EXPECT_THAT(agreement_of(Forgetful::Fault::estimate_again).first_violation,
              HasSubstr("another estimate of node 0 from the same tree, asked again"));
  EXPECT_THAT(agreement_of(Forgetful::Fault::cut_again).first_violation,
              HasSubstr("another cut from the same tree, asked again"));
}

TEST(ThreadsAgree, ConvictsAnotherAnswerElsewhere) {
  EXPECT_THAT(agreement_of(Forgetful::Fault::bound_elsewhere).first_violation,
              HasSubstr("another bound of node 3 from another thread's tree"));
  EXPECT_THAT(agreement_of(Forgetful::Fault::cut_elsewhere).first_violation,
              HasSubstr("another cut from another thread's tree"));
}

TEST(ThreadsAgree, AsksForPartsThatThereAreOnly) {
  const Parts no_bounds = library_parts & ~only(Part::bounds);
  EXPECT_EQ(agreement_of(Forgetful::Fault::bound_again, no_bounds).violations, 0U);
  EXPECT_EQ(agreement_of(Forgetful::Fault::cut_again, only(Part::bounds)).violations, 0U);
}

// ---- probabilities

/// Draws each light of a cluster alike; `bend` changes the probability that is stated of a light,
/// `redraw` what sample() makes of it.
class Sampling : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<Sampling>(*this);
  }
  std::function<double(std::uint32_t light, double p)> bend = [](std::uint32_t, double p) {
    return p;
  };
  std::function<DrawnLight(DrawnLight)> redraw = [](DrawnLight drawn) { return drawn; };

  double probability(std::uint32_t node, const ShadingPoint&, std::uint32_t light) override {
    return bend(light, 1.0 / tree().node(node).light_count);
  }
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    const auto topology = read_topology(claim(), tree().lights().size()).topology.value();
    const auto lights = topology.all_lights(node);
    const std::uint32_t light = lights[std::size_t(u * double(lights.size()))];
    return redraw({light, probability(node, point, light)});
  }
};

template <class Change>
Tally judged_sampling(Change&& change, const ShadingPoint& point = diffuse_point()) {
  const JudgedPoint judged(four_lights(), point, {1, 1, 1, 1});
  Sampling tree(judged.tree);
  change(tree);
  Tally tally;
  check_probabilities({tree, library_parts | only(Part::sampling)}, judged.at(), tally);
  return tally;
}

const ShadingPoint facing_away({0, 0, 0}, {0, 0, -1}, {0, 0, -1}, {glm::vec3(0.5F)});

TEST(Probabilities, AreRightForUniformDraws) {
  const Tally tally = judged_sampling([](Sampling&) {});
  EXPECT_THAT(violated(tally), IsEmpty());
  EXPECT_EQ(tally[Property::probabilities_sum_to_one].cases, 7U);
  EXPECT_EQ(tally[Property::contributing_lights_are_drawn].cases, 4U + 2 * 4U);
  EXPECT_EQ(tally[Property::draws_state_their_probability].cases, 7U * 8);
}

TEST(Probabilities, ConvictASumThatIsNotOne) {
  for (const double factor : {1 - 0x1p-40, 0.5})
    EXPECT_THAT(violated(judged_sampling([factor](Sampling& tree) {
                  tree.bend = [factor](std::uint32_t, double p) { return factor * p; };
                })),
                ElementsAre(Property::probabilities_sum_to_one));
}

TEST(Probabilities, ConvictALightThatIsNeverDrawn) {
  const Tally tally = judged_sampling([](Sampling& tree) {
    tree.bend = [](std::uint32_t light, double p) { return light == 2 ? 0 : p; };
  });
  EXPECT_THAT(tally[Property::contributing_lights_are_drawn].first_violation,
              HasSubstr("light 2 of node 0 contributes and is never drawn"));
}

TEST(Probabilities, AllowWhatDoesNotContributeNeverToBeDrawn) {
  const auto never = [](Sampling& tree) {
    tree.bend = [](std::uint32_t, double) { return 0; };
    tree.redraw = [](DrawnLight) { return DrawnLight{}; };
  };
  EXPECT_THAT(violated(judged_sampling(never, facing_away)), IsEmpty());
  EXPECT_THAT(
      violated(judged_sampling(never)),
      ElementsAre(Property::probabilities_sum_to_one, Property::contributing_lights_are_drawn));
}

TEST(Probabilities, ConvictADrawWithAnotherProbability) {
  EXPECT_THAT(violated(judged_sampling([](Sampling& tree) {
                tree.redraw = [](DrawnLight drawn) {
                  drawn.probability = std::nextafter(drawn.probability, 0);
                  return drawn;
                };
              })),
              ElementsAre(Property::draws_state_their_probability));
}

TEST(Probabilities, ConvictADrawFromAnotherCluster) {
  for (const std::uint32_t foreign : {0U, 4U, 0xFFFFFFFFU})
    EXPECT_THAT(violated(judged_sampling([foreign](Sampling& tree) {
                  tree.redraw = [foreign](DrawnLight drawn) {
                    return DrawnLight{foreign, drawn.probability};
                  };
                })),
                ElementsAre(Property::draws_state_their_probability));
}

TEST(Probabilities, ConvictADrawOfNothingWhereThereIsSomething) {
  EXPECT_THAT(violated(judged_sampling(
                  [](Sampling& tree) { tree.redraw = [](DrawnLight) { return DrawnLight{}; }; })),
              ElementsAre(Property::draws_state_their_probability));
}

TEST(Probabilities, ConvictNumbersThatAreNone) {
  for (const double bad : {std::nan(""), -0.25, 1.5, double(inf)}) {
    const auto broken = violated(judged_sampling([bad](Sampling& tree) {
      tree.bend = [bad](std::uint32_t light, double p) { return light == 0 ? bad : p; };
    }));
    EXPECT_THAT(broken, testing::Contains(Property::results_are_finite)) << bad;
    EXPECT_THAT(broken, testing::Contains(Property::probabilities_sum_to_one)) << bad;
  }
}

TEST(ThreadsAgree, ConvictsAnotherDraw) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 1});
  int draws = 0;
  for (const bool counts : {false, true}) {
    Sampling tree(judged.tree);
    tree.redraw = [&](DrawnLight drawn) {
      if (counts) drawn.light = std::uint32_t(++draws % 4);
      return drawn;
    };
    Tally tally;
    check_agreement({tree, library_parts | only(Part::sampling)}, {}, judged.at(), tally);
    EXPECT_EQ(tally[Property::threads_agree].violations, counts ? 1U : 0U);
  }
}

} // namespace
} // namespace lightcuts::oracle
