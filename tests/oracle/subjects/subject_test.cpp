// SPDX-License-Identifier: MIT
#include <oracle/subjects/subject.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/render/builtin/builtin_scenes.h>
#include <lightcuts/render/view/renderer.h>
#include <oracle/subjects/library_subject.h>

#include <tests/oracle/support/judged_point.h>
#include <tests/oracle/support/small_scene.h>

namespace lightcuts::oracle {
namespace {

struct DoubledBound : ClusterKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    return 2.0F * contribution_bound(tree, node, point);
  }
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t node,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    return cluster_estimate(tree, node, point, bound);
  }
};
const auto doubled_bound = std::make_shared<DoubledBound>();

const auto second_is_hidden = [](std::uint32_t light) { return light != 1; };

/// Has no part at all.
struct Mute : SubjectTree {
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<Mute>();
  }
  [[nodiscard]] TreeClaim claim() const override { return {}; }
};

TEST(Parts, HaveNamesAndBitsOfTheirOwn) {
  std::set<std::string> names;
  Parts all = 0;
  for (int i = 0; i < part_count; ++i) {
    const auto part = Part(1U << unsigned(i));
    EXPECT_FALSE(has(all, part));
    all |= only(part);
    EXPECT_TRUE(has(all, part));
    names.insert(name_of(part));
  }
  EXPECT_EQ(names.size(), std::size_t(part_count));
}

TEST(SubjectTree, ThrowsWhereItIsAskedForWhatItHasNot) {
  Mute tree;
  const ShadingPoint point = diffuse_point();
  std::vector<glm::vec3> bounds(1);
  EXPECT_THROW((void)tree.bound(0, point), std::logic_error);
  EXPECT_THROW(tree.bounds(point, bounds), std::logic_error);
  EXPECT_THROW(tree.block_bounds({&point, 1}, bounds), std::logic_error);
  EXPECT_THROW((void)tree.lower_bound(0, point), std::logic_error);
  EXPECT_THROW((void)tree.estimate(0, point, {}), std::logic_error);
  EXPECT_THROW((void)tree.select(point, {}, second_is_hidden), std::logic_error);
  EXPECT_THROW((void)tree.sample(0, point, 0.5), std::logic_error);
  EXPECT_THROW((void)tree.probability(0, point, 0), std::logic_error);
  EXPECT_EQ(tree.library_tree(), nullptr);
}

TEST(LibraryTree, HasTheBoundsOfItsKernel) {
  const LightTree of = four_lights();
  LibraryTree tree(of, doubled_bound);
  std::vector<glm::vec3> all(of.nodes().size());
  tree.bounds(diffuse_point(), all);
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i], 2.0F * contribution_bound(of, i, diffuse_point()));
    EXPECT_EQ(all[i], tree.bound(i, diffuse_point()));
  }
}

TEST(LibraryTree, BoundsBlocksAsTheLibraryDoes) {
  const LightTree of = four_lights();
  LibraryTree tree(of);
  const std::array points{diffuse_point(), diffuse_point({0.5F, 0, 0.25F})};
  std::vector<glm::vec3> all(of.nodes().size());
  tree.block_bounds(points, all);
  for (std::uint32_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(all[i], contribution_bound(of, i, ShadingBlock(points)));
}

/// What is drawn, with copies of the clusters.
struct DrawnCut {
  Cut cut;
  std::vector<CutCluster> clusters;
  explicit DrawnCut(const Cut& of) : cut(of), clusters(of.clusters.begin(), of.clusters.end()) {}
};

// At another point than before, too.
TEST(BatchedTree, DrawsManyAsOneByOne) {
  BatchedTree<> tree(four_lights());
  constexpr std::array<std::uint64_t, 8> queries{3, 1, 4, 1, 5, 9, 2, 6};
  const CutConfig config{0.02F, 2};
  for (const ShadingPoint& point : {diffuse_point(), diffuse_point({1, 1, 0.5F})}) {
    std::vector<DrawnCut> many;
    tree.draws(point, config, queries, second_is_hidden,
               [&](const Cut& cut) { many.emplace_back(cut); });
    ASSERT_EQ(many.size(), queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const DrawnCut one(tree.draw(point, config, queries[i], second_is_hidden));
      EXPECT_EQ(many[i].cut.radiance, one.cut.radiance);
      EXPECT_EQ(many[i].cut.certified_error, one.cut.certified_error);
      ASSERT_EQ(many[i].clusters.size(), one.clusters.size());
      for (std::size_t k = 0; k < one.clusters.size(); ++k) {
        EXPECT_EQ(many[i].clusters[k].node, one.clusters[k].node);
        EXPECT_EQ(many[i].clusters[k].estimate, one.clusters[k].estimate);
      }
    }
    EXPECT_EQ(many[1].cut.radiance, many[3].cut.radiance);
    EXPECT_TRUE(std::any_of(many.begin(), many.end(), [&](const DrawnCut& one) {
      return one.cut.radiance != many.front().cut.radiance;
    })) << "else nothing was drawn";
  }
}

TEST(LibraryTree, SelectsWithItsKernelConfigurationAndVisibility) {
  const LightTree of = four_lights();
  LibraryTree tree(of, doubled_bound);
  for (int again = 0; again < 2; ++again)
    for (const std::uint32_t size : {3U, 2U}) {
      const CutConfig config{0.1F, size};
      CutSelector own(of, config, *doubled_bound);
      const Cut expected = own(diffuse_point(), second_is_hidden);
      const Cut cut = tree.select(diffuse_point(), config, second_is_hidden);
      EXPECT_EQ(cut.radiance, expected.radiance);
      EXPECT_EQ(cut.certified_error, expected.certified_error);
      EXPECT_EQ(cut.clusters.size(), size);
      EXPECT_EQ(cut.shadow_rays, expected.shadow_rays);
      EXPECT_EQ(cut.end, CutEnd::max_size);
    }
}

TEST(LibraryTree, RefusesWhatTheSelectorRefuses) {
  LibraryTree tree(four_lights());
  EXPECT_THROW((void)tree.select(diffuse_point(), {-1, 1}, second_is_hidden), InputError);
  EXPECT_THROW((void)tree.select(diffuse_point(), {0.02F, 0}, second_is_hidden), InputError);
}

TEST(LibraryTree, AnswersTheSameInAnotherThread) {
  LibraryTree tree(four_lights(), doubled_bound);
  const auto other = tree.for_another_thread();
  EXPECT_EQ(other->library_tree(), tree.library_tree());
  EXPECT_EQ(other->bound(0, diffuse_point()), tree.bound(0, diffuse_point()));
  const Cut a = tree.select(diffuse_point(), {0.1F, 3}, second_is_hidden);
  const Cut b = other->select(diffuse_point(), {0.1F, 3}, second_is_hidden);
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_NE(a.clusters.data(), b.clusters.data());
}

TEST(LibrarySubject, GivesTheLibrarysOwnAnswers) {
  const LightTree own = four_lights();
  const auto subject = library_subject();
  EXPECT_EQ(subject->name(), "lightcuts");
  EXPECT_EQ(subject->parts(), all_parts_and_claims);
  const auto tree = subject->build(own.lights(), 1);
  const ShadingPoint point = diffuse_point();
  for (std::uint32_t i = 0; i < own.nodes().size(); ++i) {
    const glm::vec3 bound = contribution_bound(own, i, point);
    EXPECT_EQ(tree->bound(i, point), bound);
    EXPECT_EQ(tree->lower_bound(i, point), contribution_lower_bound(own, i, point));
    EXPECT_EQ(tree->estimate(i, point, bound), cluster_estimate(own, i, point, bound));
  }
  EXPECT_TRUE(subject->refined_before(2, 1));
  EXPECT_FALSE(subject->refined_before(1, 1));
}

TEST(LibrarySubject, TakesTheSeedOfTheTree) {
  LightSet lights;
  for (int i = 0; i < 64; ++i) lights.add_omni({i, 0, 1}, glm::vec3(1));
  const auto representatives = [&](std::uint64_t seed) {
    std::vector<std::uint32_t> list;
    for (const auto& n : library_subject()->build(lights, seed)->claim().nodes)
      list.push_back(n.representative);
    return list;
  };
  EXPECT_EQ(representatives(1), representatives(1));
  EXPECT_NE(representatives(1), representatives(2));
}

TEST(LibrarySubject, SeesAndRendersAsTheLibraryDoes) {
  const Scene scene = shaded_floor_scene(8);
  const SceneView view(scene);
  const auto subject = library_subject();
  const auto point = view.at({8, 6}).value();
  for (std::uint32_t i = 0; i < 8; ++i)
    EXPECT_EQ(subject->sees(view, point, i), view.sees(point, i));
  const LightTree tree = build(scene.lights);
  EXPECT_EQ(subject->render(view, tree, {}).radiance, render(view, tree, {}).radiance);
}

TEST(LocallyOrderedSubject, HasTheOtherBuildersTree) {
  LightSet lights;
  for (int i = 0; i < 40; ++i) lights.add_omni({i, i * i % 7, 0}, glm::vec3(float(1 + i % 3)));
  const auto subject = locally_ordered_subject();
  EXPECT_EQ(subject->name(), "locally-ordered");
  const LightTree own = build(lights, {7, Builder::locally_ordered});
  const TreeClaim expected = claim_of(own);
  const TreeClaim claim = subject->build(lights, 7)->claim();
  EXPECT_EQ(claim.lights, expected.lights);
  EXPECT_NE(claim.lights, claim_of(build(lights, {7})).lights);
}

TEST(PaperSubject, HasThePapersBound) {
  const LightTree own = four_lights();
  const auto subject = paper_subject();
  EXPECT_EQ(subject->name(), "paper");
  EXPECT_EQ(subject->build(own.lights(), 1)->bound(0, diffuse_point()),
            contribution_bound(own, 0, diffuse_point(), BoundRule::product));
}

} // namespace
} // namespace lightcuts::oracle
