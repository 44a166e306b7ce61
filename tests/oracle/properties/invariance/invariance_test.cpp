// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <oracle/cases/random_case.h>

#include <tests/oracle/support/made_subject.h>

namespace lightcuts::oracle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::array all_seven{
    Property::intensity_scales_exactly,  Property::length_scales_exactly,
    Property::rotation_is_immaterial,    Property::translation_is_immaterial,
    Property::light_order_is_immaterial, Property::split_light_is_immaterial,
    Property::black_light_is_immaterial};

/// What a test multiplies a subject's results by, or adds to them.
using Bend = std::function<float(float value, const LightSet&, const ShadingPoint&)>;

/// The library's tree with bent bounds or radiance.
class Bent : public LibraryTree {
public:
  Bent(const LightTree& of, Bend bound, Bend radiance)
      : LibraryTree(of), bound_(std::move(bound)), radiance_(std::move(radiance)) {}
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    return bent(LibraryTree::bound(node, point), bound_, point);
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    Cut cut = LibraryTree::select(point, config, visible);
    cut.radiance = bent(cut.radiance, radiance_, point);
    return cut;
  }

private:
  [[nodiscard]] glm::vec3 bent(glm::vec3 value, const Bend& by, const ShadingPoint& point) const {
    for (int c = 0; c < 3 && by; ++c) value[c] = by(value[c], tree().lights(), point);
    return value;
  }
  Bend bound_, radiance_;
};

/// Three lights whose places floats can shift and scale, and a point that faces none of the axes.
Case three_lights() {
  Case c;
  const auto add = [&c](const glm::vec3& position, float intensity) {
    c.lights.push_back({.position = position, .intensity = glm::vec3(1, 2, 3) * intensity});
  };
  add({1, 0.5F, 2}, 1);
  add({-1, 0.25F, 3}, 0.5F);
  add({0.5F, -2, 1.5F}, 2);
  c.views.resize(1);
  c.views[0].view.normal = {0.48F, 0.6F, 0.64F};
  c.views[0].view.to_viewer = {0, 0.6F, 0.8F};
  c.views[0].view.material = {glm::vec3(0.5F), Phong{glm::vec3(0.25F), 20}};
  return c;
}

Tally judged(const Subject& subject, const Case& on) {
  Tally tally;
  Judge(subject.parts(), 0, tally).invariance(subject, on);
  return tally;
}

/// What is found wrong with bounds bent so, which has to be what is found with such radiance.
std::vector<Property> violated_by(const Bend& bend) {
  const auto with = [](const Bend& bound, const Bend& radiance) {
    return violated(judged(
        MadeSubject([&](LightTree tree) { return std::make_unique<Bent>(tree, bound, radiance); }),
        three_lights()));
  };
  const std::vector<Property> of_bounds = with(bend, {});
  EXPECT_EQ(of_bounds, with({}, bend));
  return of_bounds;
}

TEST(Invariance, HoldsForTheLibraryInRandomCases) {
  Tally tally;
  for (std::uint64_t i = 0; i < 1500; ++i)
    Judge(library_parts, i, tally).invariance(*library_subject(), random_case(11, i));
  for (const Property p : all_properties) EXPECT_EQ(tally[p].first_violation, "") << info(p).name;
  for (const Property p : all_seven) EXPECT_GT(tally[p].cases, 100U) << info(p).name;
}

TEST(Invariance, HoldsForThePapersBounds) {
  EXPECT_THAT(violated(judged(*paper_subject(), three_lights())), IsEmpty());
}

TEST(Invariance, IsAskedOfAllSevenInTheThreeLights) {
  const Tally tally = judged(*library_subject(), three_lights());
  EXPECT_THAT(violated(tally), IsEmpty());
  for (const Property p : all_seven) EXPECT_EQ(tally[p].cases, 1U) << info(p).name;
}

TEST(Invariance, ConvictsAnAbsoluteEpsilonOfRadiance) {
  EXPECT_THAT(
      violated_by([](float value, const LightSet&, const ShadingPoint&) { return value + 1e-4F; }),
      ElementsAre(Property::intensity_scales_exactly));
}

// The nearest light's distance, with an epsilon against division by 0.
TEST(Invariance, ConvictsAnAbsoluteEpsilonOfLengths) {
  EXPECT_THAT(violated_by([](float value, const LightSet& lights, const ShadingPoint& point) {
                double d2 = std::numeric_limits<double>::max();
                for (const Light& light : lights) {
                  const glm::dvec3 q = glm::dvec3(light.position) - glm::dvec3(point.position());
                  d2 = std::min(d2, glm::dot(q, q));
                }
                return value * float(d2 / (d2 + 1e-4));
              }),
              ElementsAre(Property::length_scales_exactly));
}

TEST(Invariance, ConvictsAnAxisOfTheWorld) {
  EXPECT_THAT(violated_by([](float value, const LightSet&, const ShadingPoint& point) {
                return value * (1 + std::abs(point.normal().z));
              }),
              ElementsAre(Property::rotation_is_immaterial));
}

TEST(Invariance, ConvictsAPlaceInTheWorld) {
  EXPECT_THAT(violated_by([](float value, const LightSet&, const ShadingPoint& point) {
                return point.position() == glm::vec3(0) ? value : 1.01F * value;
              }),
              ElementsAre(Property::translation_is_immaterial));
}

// By the first light's share of the distance to it and to the last.
TEST(Invariance, ConvictsTheOrderOfLights) {
  EXPECT_THAT(violated_by([](float value, const LightSet& lights, const ShadingPoint& point) {
                double nearest = std::numeric_limits<double>::max(), first = 0;
                for (std::uint32_t i = 0; i < lights.size(); ++i) {
                  const glm::dvec3 q =
                      glm::dvec3(lights[i].position) - glm::dvec3(point.position());
                  if (i == 0) first = glm::dot(q, q);
                  nearest = std::min(nearest, glm::dot(q, q));
                }
                return first == nearest ? value : 1.01F * value;
              }),
              ElementsAre(Property::light_order_is_immaterial));
}

TEST(Invariance, ConvictsTheNumberOfLights) {
  EXPECT_THAT(violated_by([](float value, const LightSet& lights, const ShadingPoint&) {
                int lit = 0;
                for (const Light& light : lights) lit += light.intensity.x > 0 ? 1 : 0;
                return value * float(lit);
              }),
              ElementsAre(Property::split_light_is_immaterial));
}

TEST(Invariance, ConvictsWhatBlackLightsDo) {
  EXPECT_THAT(violated_by([](float value, const LightSet& lights, const ShadingPoint&) {
                for (const Light& light : lights)
                  if (light.intensity == glm::vec3(0)) return 1.01F * value;
                return value;
              }),
              ElementsAre(Property::black_light_is_immaterial));
}

/// Of what is scaled, bounds and radiance must not err by a single ulp; of all else, by no more
/// than rounding.
TEST(Invariance, AllowsRoundingOfWhatIsNotScaledOnly) {
  const auto off = [](float ulps) {
    return [ulps](float value, const LightSet& lights, const ShadingPoint& point) {
      const bool changed = lights[0].intensity.x > 100 || lights[0].intensity.x == 16 ||
                           point.position() != glm::vec3(0);
      return changed ? value * (1 + ulps * 0x1p-23F) : value;
    };
  };
  EXPECT_THAT(violated_by(off(1)),
              ElementsAre(Property::intensity_scales_exactly, Property::length_scales_exactly));
  EXPECT_THAT(violated_by(off(8)),
              ElementsAre(Property::intensity_scales_exactly, Property::length_scales_exactly,
                          Property::translation_is_immaterial));
}

TEST(Invariance, ConvictsAResultThatIsNotANumberAfterTheChange) {
  EXPECT_THAT(violated_by([](float value, const LightSet& lights, const ShadingPoint&) {
                return lights.size() == 6 ? std::nanf("") : value;
              }),
              ElementsAre(Property::split_light_is_immaterial));
}

TEST(Invariance, IsNotAskedForWhatFloatsCannotSay) {
  Case c = three_lights();
  c.lights[0].position.x = 1e-8F; // 1 + 1e-8 rounds
  EXPECT_EQ(judged(*library_subject(), c)[Property::translation_is_immaterial].cases, 0U);
  c.lights[0].intensity.x = 0x1p125F;
  const Tally tally = judged(*library_subject(), c);
  EXPECT_EQ(tally[Property::intensity_scales_exactly].cases, 0U);
  EXPECT_EQ(tally[Property::length_scales_exactly].cases, 0U);
  c.lights.resize(1);
  EXPECT_EQ(judged(*library_subject(), c)[Property::light_order_is_immaterial].cases, 0U);
}

TEST(Invariance, AsksForPartsThatThereAreOnly) {
  const MadeSubject without_cuts(
      [](LightTree tree) {
        return std::make_unique<BentTree>(tree, [](std::uint32_t, glm::vec3 b) { return b; });
      },
      only(Part::bounds));
  EXPECT_THAT(violated(judged(without_cuts, three_lights())), IsEmpty());
}

// A turned box is another bound, and as right.
TEST(Invariance, IsAPromiseOfThisLibraryAloneAndAWasteOfOthers) {
  const Bend bent = [](float value, const LightSet&, const ShadingPoint& point) {
    return value * (1 + std::abs(point.normal().z));
  };
  const auto with = [&](Parts parts) {
    return judged(
        MadeSubject([&](LightTree tree) { return std::make_unique<Bent>(tree, bent, Bend{}); },
                    parts),
        three_lights());
  };
  const Tally ours = with(library_parts), others = with(library_parts & ~only(Part::library_rules));
  EXPECT_EQ(ours.violations(), 1U);
  EXPECT_EQ(ours.wasteful(), 0U);
  EXPECT_EQ(others.violations(), 0U);
  EXPECT_EQ(others.wasteful(), 1U);
  EXPECT_THAT(broken(others), ElementsAre(Property::rotation_is_immaterial));
}

} // namespace
} // namespace lightcuts::oracle
