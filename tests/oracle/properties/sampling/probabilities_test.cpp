// SPDX-License-Identifier: MIT
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/oracle/support/uniform_sampling.h>
#include <tests/support/float_limits.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

template <class Change>
Tally judged_sampling(Change&& change, const ShadingPoint& point = diffuse_point()) {
  const JudgedPoint judged(four_lights(), point, {1, 1, 1, 1});
  UniformSampling tree(judged.tree);
  change(tree);
  return judged_at(
      tree, judged, [](const Judge& judge, const PointAnswers& of) { judge.odds(of); },
      library_parts | only(Part::sampling));
}

const ShadingPoint facing_away({0, 0, 0}, {0, 0, -1}, {0, 0, -1}, {glm::vec3(0.5F)});

TEST(Probabilities, AreRightForUniformDraws) {
  const Tally tally = judged_sampling([](UniformSampling&) {});
  EXPECT_THAT(violated(tally), IsEmpty());
  EXPECT_EQ(tally[Property::probabilities_sum_to_one].cases, 7U);
  EXPECT_EQ(tally[Property::contributing_lights_are_drawn].cases, 4U + 2 * 4U);
  // Ten numbers each, and both sides of the root's three borders.
  EXPECT_EQ(tally[Property::draws_state_their_probability].cases, 7U * 10 + 2 * 3 + 10);
}

TEST(Probabilities, ConvictASumThatIsNotOne) {
  for (const double factor : {1 - 0x1p-40, 0.5})
    EXPECT_THAT(violated(judged_sampling([factor](UniformSampling& tree) {
                  tree.bend = [factor](std::uint32_t, double p) { return factor * p; };
                })),
                ElementsAre(Property::probabilities_sum_to_one));
}

TEST(Probabilities, ConvictALightThatIsNeverDrawn) {
  const Tally tally = judged_sampling([](UniformSampling& tree) {
    tree.bend = [](std::uint32_t light, double p) { return light == 2 ? 0 : p; };
  });
  EXPECT_THAT(tally[Property::contributing_lights_are_drawn].first_violation,
              HasSubstr("light 2 of node 0 contributes and is never drawn"));
}

TEST(Probabilities, AllowWhatDoesNotContributeNeverToBeDrawn) {
  const auto never = [](UniformSampling& tree) {
    tree.bend = [](std::uint32_t, double) { return 0; };
    tree.redraw = [](DrawnLight) { return DrawnLight{}; };
  };
  EXPECT_THAT(violated(judged_sampling(never, facing_away)), IsEmpty());
  EXPECT_THAT(
      violated(judged_sampling(never)),
      ElementsAre(Property::probabilities_sum_to_one, Property::contributing_lights_are_drawn));
}

TEST(Probabilities, ConvictADrawWithAnotherProbability) {
  EXPECT_THAT(violated(judged_sampling([](UniformSampling& tree) {
                tree.redraw = [](DrawnLight drawn) {
                  drawn.probability *= 1 - 0x1p-40;
                  return drawn;
                };
              })),
              ElementsAre(Property::draws_state_their_probability));
}

TEST(Probabilities, ConvictADrawFromAnotherCluster) {
  for (const std::uint32_t foreign : {0U, 4U, 0xFFFFFFFFU})
    EXPECT_THAT(violated(judged_sampling([foreign](UniformSampling& tree) {
                  tree.redraw = [foreign](DrawnLight drawn) {
                    return DrawnLight{foreign, drawn.probability};
                  };
                })),
                ElementsAre(Property::draws_state_their_probability));
}

TEST(Probabilities, ConvictADrawOfNothingWhereThereIsSomething) {
  EXPECT_THAT(violated(judged_sampling([](UniformSampling& tree) {
                tree.redraw = [](DrawnLight) { return DrawnLight{}; };
              })),
              ElementsAre(Property::draws_state_their_probability));
}

TEST(Probabilities, ConvictNumbersThatAreNone) {
  for (const double bad : {std::nan(""), -0.25, 1.5, double(inf)}) {
    const auto broken = violated(judged_sampling([bad](UniformSampling& tree) {
      tree.bend = [bad](std::uint32_t light, double p) { return light == 0 ? bad : p; };
    }));
    EXPECT_THAT(broken, testing::Contains(Property::results_are_finite)) << bad;
    EXPECT_THAT(broken, testing::Contains(Property::probabilities_sum_to_one)) << bad;
  }
}

TEST(Probabilities, MayRoundOnEachLevel) {
  EXPECT_THAT(violated(judged_sampling([](UniformSampling& tree) {
                tree.redraw = [](DrawnLight drawn) {
                  if (drawn.probability < 1)
                    drawn.probability = std::nextafter(drawn.probability, 0);
                  return drawn;
                };
              })),
              IsEmpty());
}

/// Draws what is in no cluster by one number.
class WrongByOneNumber : public UniformSampling {
public:
  WrongByOneNumber(const LightTree& tree, double number) : UniformSampling(tree), number_(number) {}
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    if (u == number_) return {99, 0.25};
    return UniformSampling::sample(node, point, u);
  }

private:
  double number_;
};

TEST(Probabilities, ConvictWhatIsDrawnByTheEndsOfRandomNumbersAndAtBorders) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 1});
  for (const double number : {0.0, 1 - 0x1p-53, 0.5, 0.5 - 0x1p-54}) {
    WrongByOneNumber tree(judged.tree, number);
    EXPECT_THAT(
        violated(judged_at(
            tree, judged, [](const Judge& judge, const PointAnswers& of) { judge.odds(of); },
            library_parts | only(Part::sampling))),
        ElementsAre(Property::draws_state_their_probability))
        << number;
  }
}

} // namespace
} // namespace lightcuts::oracle
