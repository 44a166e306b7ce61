// SPDX-License-Identifier: MIT
#include <oracle/explain/explain.h>

#include <algorithm>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oracle/cases/random_case.h>
#include <oracle/mutants/mutants.h>
#include <oracle/subjects/library_subject.h>

#include <tests/oracle/support/made_subject.h>

namespace lightcuts::oracle {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

/// Two lights straight above a white point: (1 + 3)/pi, 1/pi of one.
Case two_lights_above() {
  Case on;
  on.lights = {{.position = {0, 0, 1}, .intensity = {1, 0, 1}},
               {.position = {0, 0, 1}, .intensity = {3, 0, 1}}};
  on.views = {{{.material = {glm::vec3(1), {}}}, {}}};
  return on;
}

std::string explained(const char* mutant, Property property, const Case& on) {
  return explain(*mutant_named(mutant)->subject(), {property, on, "", 0});
}

TEST(Explain, ShowsWhereABoundFallsBelowTheTruth) {
  const std::string text = explained("intensity-of-representative",
                                     Property::bound_dominates_contribution, two_lights_above());
  EXPECT_THAT(text, HasSubstr("node 0 of 3: 2 lights"));
  EXPECT_THAT(text, ContainsRegex("  q +\\(0, 0, 1\\)\n"));
  EXPECT_THAT(text, ContainsRegex("\\|q\\|\\^2 +1\n"));
  EXPECT_THAT(text, ContainsRegex("n\\.l +1\n"));
  EXPECT_THAT(text, ContainsRegex("falloff +1 "));
  EXPECT_THAT(text, ContainsRegex("BRDF +0\\.31830988618379067"));
  // 3/pi, and its double.
  EXPECT_THAT(text, ContainsRegex("contribution +0\\.95492965855137201"));
  EXPECT_THAT(text, HasSubstr("0x1.e8ec8a4aeacc4p-1"));
  EXPECT_THAT(text, ContainsRegex("box from +\\(0, 0, 1\\)\n  to +\\(0, 0, 1\\)\n"));
  EXPECT_THAT(text, ContainsRegex("min \\|q\\| +1\n"));
  EXPECT_THAT(text, ContainsRegex("max n\\.l falloff +1 "));
  EXPECT_THAT(text, ContainsRegex("intensity +4 +0 +2\n"));
  EXPECT_THAT(text, ContainsRegex("truth, 700 bits +1\\.2732395447351626862 +0 "));
  EXPECT_THAT(text, ContainsRegex("the library's bound +1\\.27323"));
  EXPECT_THAT(text, HasSubstr("they part here: channel "));
}

TEST(Explain, ShowsTheFactorsOfABlocksBoundAndOfThePointWhereItFallsShort) {
  Case on = two_lights_above();
  on.views.push_back(on.views.front());
  on.views[1].view.position = {0, 0, 0.5F}; // where they are twice as near
  const std::string text = explained("block-corner-forgotten", Property::block_bound_dominates, on);
  EXPECT_THAT(text, HasSubstr("view 1\n"));
  EXPECT_THAT(text, HasSubstr("node 0 of 3: 2 lights"));
  EXPECT_THAT(text, HasSubstr("the block of 2 points"));
  EXPECT_THAT(text, ContainsRegex("points from +\\(0, 0, 0\\)\n  to +\\(0, 0, 0\\.5\\)\n"));
  EXPECT_THAT(text, ContainsRegex("suprema over it +from this point +from the block\n"));
  EXPECT_THAT(text, ContainsRegex("min \\|q\\| +0\\.5 +0\\.5\n"));
  EXPECT_THAT(text, ContainsRegex("max n\\.l falloff +4 +4 "));
  EXPECT_THAT(text, ContainsRegex("truth, 700 bits +5\\.09295")); // 16/pi
  EXPECT_THAT(text, ContainsRegex("library, the block +5\\.0929"));
  EXPECT_THAT(text, ContainsRegex("subject, the block +1\\.2732"));
  EXPECT_THAT(text, HasSubstr("the subject's bound of the block 1.27"));
  EXPECT_THAT(text, ContainsRegex("leaves 1\\.0+[0-9]* for n\\.l falloff; light [01] has 4"));
}

TEST(Explain, ShowsTheErrorOfAnEstimate) {
  Case on = two_lights_above();
  on.views[0].hidden = {0, 1};
  const auto paper = paper_subject();
  EXPECT_THAT(explain(*paper, {Property::bound_dominates_error, on, "", 0}),
              HasSubstr("It holds."));
  const std::string text =
      explained("intensity-of-representative", Property::bound_shrinks_on_refinement, on);
  EXPECT_THAT(text, AllOf(HasSubstr("bound of node 1"), HasSubstr("bound of node 2"),
                          HasSubstr("they part here: channel")));
}

/// All bounds are the one that a test gives.
class OneBoundTree : public LibraryTree {
public:
  OneBoundTree(LightTree tree, float bound) : LibraryTree(std::move(tree)), bound_(bound) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<OneBoundTree>(tree(), bound_);
  }
  glm::vec3 bound(std::uint32_t, const ShadingPoint&) override { return glm::vec3(bound_); }

private:
  float bound_;
};

std::string explained_with_bound(float bound, const Case& on) {
  const MadeSubject subject(
      [&](LightTree tree) { return std::make_unique<OneBoundTree>(std::move(tree), bound); });
  return explain(subject, {Property::bound_dominates_contribution, on, "", 0});
}

TEST(Explain, ShowsATruthBelowTheRangeOfDoubles) {
  Case on;
  on.lights = {{.position = {2.2245F, 0, 1}, .intensity = {1, 1, 1}}};
  on.views = {{{.material = {glm::vec3(0), Phong{glm::vec3(1), 1000}}}, {}}};
  const std::string text = explained_with_bound(0, on);
  EXPECT_THAT(text, ContainsRegex("true contribution [0-9.]+e-38[0-9],[ \n]+bound 0\n"));
  EXPECT_THAT(text, ContainsRegex("truth [0-9.]+e-38[0-9] > the subject's bound 0\n"));
}

TEST(Explain, ShowsRatiosThatAreNearlyOne) {
  Case on = two_lights_above();
  on.lights.pop_back();
  float bound = 0;
  double ratio = 2; // of the contribution to the float below it
  for (float i = 1; ratio > 1 + 1e-9; ++i) {
    on.lights[0].intensity = glm::vec3(i);
    const double truth = double(i) / std::numbers::pi;
    bound = static_cast<float>(truth);
    if (bound < truth) ratio = truth / double(bound);
  }
  EXPECT_THAT(explained_with_bound(bound, on), ContainsRegex(", 1 \\+ [0-9.]+e-[0-9]+ times\n"));
}

TEST(Explain, DoesNotChooseAmongFactors) {
  Case on = two_lights_above();
  EXPECT_THAT(explained_with_bound(0.25F, on),
              ContainsRegex("for n\\.l falloff; light [01] has 1\n"));
  for (Light& light : on.lights) {
    light.kind = LightKind::oriented;
    light.axis = {0.8F, 0, -0.6F};
  }
  EXPECT_THAT(explained_with_bound(0.25F, on),
              ContainsRegex("for n\\.l falloff emission; light [01] has 0\\.[56]"));
}

/// A bright light and dim ones, on which refining the smallest bound first stops too early.
Counterexample cut_counterexample() {
  const auto subject = mutant_named("heap-inverted")->subject();
  const HuntResult result = hunt(*subject, {.cases = 1000, .waste = false});
  return shrunk(*subject, *result.found);
}

TEST(Explain, ShowsTheRefinementOfACut) {
  const Counterexample c = cut_counterexample();
  const std::string text = explained("heap-inverted", c.property, c.on);
  EXPECT_THAT(text, HasSubstr("cut: threshold "));
  EXPECT_THAT(text, ContainsRegex("  0 +[0-9]+ .* refined\n"));
  EXPECT_THAT(text, HasSubstr("in the cut\n"));
  EXPECT_THAT(text, HasSubstr("sum of estimates"));
  EXPECT_THAT(text, HasSubstr("certified error"));
  EXPECT_THAT(text, HasSubstr("truth, 700 bits"));
  EXPECT_THAT(text, HasSubstr("they part here: the bound of node "));
}

/// Refines less the smaller the threshold.
class BackwardTree : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    CutConfig backward = config;
    backward.threshold = config.threshold < 0.5F ? 100 : 0;
    return LibraryTree::select(point, backward, visible);
  }
};

TEST(Explain, ShowsBothCutsWhereTheSecondDoesNotRefineTheFirst) {
  Case on = two_lights_above();
  on.cut.threshold = 0.5F;
  const std::string text =
      explain(subject_with<BackwardTree>(), {Property::tighter_threshold_refines, on, "", 0});
  EXPECT_THAT(text, ContainsRegex("cut: threshold 0\\.5(.|\n)*cut: threshold 0\\.125"));
  EXPECT_THAT(text, HasSubstr("they part here: "));
  EXPECT_THAT(text, HasSubstr("does not refine"));
}

/// Each hidden light makes all brighter.
class GlowingTree : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    Cut cut = LibraryTree::select(point, config, visible);
    for (std::uint32_t light = 0; light < 2; ++light)
      if (!visible(light)) cut.radiance *= 100;
    return cut;
  }
};

TEST(Explain, ShowsTheCutsWithAndWithoutWhatIsHidden) {
  Case on = two_lights_above();
  on.views[0].hidden = {0};
  const std::string text =
      explain(subject_with<GlowingTree>(), {Property::visibility_only_darkens, on, "", 0});
  EXPECT_THAT(text, ContainsRegex("cut: (.|\n)*in the cut\n(.|\n)*cut: (.|\n)*hidden"));
  EXPECT_THAT(text, HasSubstr("they part here: "));
  EXPECT_THAT(text, HasSubstr("with all lights seen"));
}

/// Has a cluster twice, and a node that is none.
class StrayingTree : public LibraryTree {
public:
  using LibraryTree::LibraryTree;
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    Cut cut = LibraryTree::select(point, config, visible);
    clusters_.assign(cut.clusters.begin(), cut.clusters.end());
    clusters_.push_back(clusters_.front());
    clusters_.push_back({99, true, {}, {}});
    cut.clusters = clusters_;
    return cut;
  }

private:
  std::vector<CutCluster> clusters_;
};

TEST(Explain, ShowsClustersOfACutThatAreTwiceInItOrNone) {
  const std::string text = explain(subject_with<StrayingTree>(),
                                   {Property::cut_partitions_lights, two_lights_above(), "", 0});
  EXPECT_THAT(text, ContainsRegex("  [0-2] +once more, or no node at all\n"));
  EXPECT_THAT(text, ContainsRegex("  99 +once more, or no node at all\n"));
  EXPECT_THAT(text, HasSubstr("beyond the 3 nodes there are: 99"));
}

/// Says of the library's tree what is not so.
class Liar : public Subject {
public:
  explicit Liar(void (*lie)(TreeClaim&)) : lie_(lie) {}

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Parts parts() const override { return 0; }
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return std::make_unique<LyingTree>(lightcuts::build(lights, {seed}), lie_);
  }

private:
  class LyingTree : public SubjectTree {
  public:
    LyingTree(LightTree tree, void (*lie)(TreeClaim&)) : tree_(std::move(tree)), lie_(lie) {}
    [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
      return std::make_unique<LyingTree>(tree_, lie_);
    }
    [[nodiscard]] TreeClaim claim() const override {
      TreeClaim claim = claim_of(tree_);
      lie_(claim);
      return claim;
    }

  private:
    LightTree tree_;
    void (*lie_)(TreeClaim&);
  };

  void (*lie_)(TreeClaim&);
  std::string name_ = "liar";
};

TEST(Explain, ShowsWhatIsWrongWithATree) {
  const auto text = [](Property property, void (*lie)(TreeClaim&)) {
    return explain(Liar(lie), {property, two_lights_above(), "", 0});
  };
  EXPECT_THAT(text(Property::tree_partitions_lights,
                   [](TreeClaim& c) {
                     c.lights = {0, 0};
                   }),
              AllOf(HasSubstr("node 1: lights 0"), HasSubstr("node 2: lights 0"),
                    HasSubstr("they part here: light 0 is in 2 leaves")));
  EXPECT_THAT(text(Property::tree_partitions_lights,
                   [](TreeClaim& c) {
                     c.children = {1, 9};
                   }),
              HasSubstr("they part here: node 0 has node 9 of 3 as a child"));
  EXPECT_THAT(
      text(Property::tree_conserves_intensity,
           [](TreeClaim& c) { c.nodes[0].intensity = glm::dvec3(5); }),
      AllOf(ContainsRegex("intensity +5 +5 +5\n"), ContainsRegex("its lights' total +4 +0 +2\n")));
  EXPECT_THAT(text(Property::representative_belongs,
                   [](TreeClaim& c) { c.nodes[1].representative = c.nodes[2].representative; }),
              HasSubstr("they part here: node "));
}

TEST(Explain, SaysThatItHolds) {
  const std::string text = explain(
      *library_subject(), {Property::bound_dominates_contribution, two_lights_above(), "", 0});
  EXPECT_THAT(text, HasSubstr("It holds."));
  EXPECT_THAT(text, HasSubstr("light 1: omni, position (0, 0, 1), intensity (3, 0, 1)"));
}

/// Columns of the longest line.
std::size_t width(const std::string& text) {
  std::istringstream lines(text);
  std::size_t most = 0;
  for (std::string line; std::getline(lines, line);) most = std::max(most, line.size());
  return most;
}

TEST(Explain, StaysWithinAHundredColumns) {
  for (const char* name : {"heap-inverted", "intensity-of-representative"}) {
    const auto subject = mutant_named(name)->subject();
    for (std::uint64_t index = 0; index < 60; ++index) {
      const Case on = random_case(3, index);
      for (const Property p : all_properties)
        if (const auto message = failure_of(*subject, p, on)) {
          const std::string text = explain(*subject, {p, on, *message, index});
          EXPECT_LE(width(text), 100U) << text;
          EXPECT_THAT(text, HasSubstr("It does not hold: "));
        }
    }
  }
}

} // namespace
} // namespace lightcuts::oracle
