// SPDX-License-Identifier: MIT
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tests/oracle/support/uniform_sampling.h>

namespace lightcuts::oracle {
namespace {

using testing::HasSubstr;

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

PropertyCount agreement_of(SubjectTree& tree, const JudgedPoint& judged, const CutConfig& cut,
                           Parts parts) {
  constexpr auto p = Property::threads_agree;
  return judged_at(
      tree, judged, [&](const Judge& judge, const PointAnswers& of) { judge.point(of, cut); },
      parts, p)[p];
}

PropertyCount agreement_of(Forgetful::Fault fault, Parts parts = library_parts) {
  const JudgedPoint judged(four_lights(), diffuse_point({0.25F, 0, 0}), {1, 1, 0, 1});
  Forgetful tree(judged.tree);
  tree.fault = fault;
  const PropertyCount count = agreement_of(tree, judged, {0.02F, 3}, parts);
  EXPECT_EQ(count.cases, 1U);
  return count;
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

TEST(ThreadsAgree, ConvictsAnotherDraw) {
  const JudgedPoint judged(four_lights(), diffuse_point(), {1, 1, 1, 1});
  int draws = 0;
  for (const bool counts : {false, true}) {
    UniformSampling tree(judged.tree);
    tree.redraw = [&](DrawnLight drawn) {
      if (counts) drawn.light = std::uint32_t(++draws % 4);
      return drawn;
    };
    const Parts parts = library_parts | only(Part::sampling);
    EXPECT_EQ(agreement_of(tree, judged, {}, parts).violations, counts ? 1U : 0U);
  }
}

} // namespace
} // namespace lightcuts::oracle
