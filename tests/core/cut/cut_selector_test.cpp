// SPDX-License-Identifier: MIT
#include <lightcuts/core/cut/cut_selector.h>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/kernels/contribution_bound.h>
#include <lightcuts/core/kernels/transfer.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/allocation_count.h>
#include <tests/support/cut_promises.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>

namespace lightcuts {
namespace {

using precise::Colour;
using precise::Quad;

RC_GTEST_PROP(CutSelector, KeepsEveryPromise, ()) { RC_ASSERT(broken_promise(*cut_case()) == ""); }

/// Viewer and light mirror each other at a surface that they all but lie in.
struct Glancing {
  Lobe lobe;
  int exponent; ///< n.v = 2^-exponent
  double radiance;
};
constexpr const char* names_of_lobes[] = {"none", "Phong", "Ward", "Cook-Torrance"};

TEST(CutSelector, CertifiesWhatMirrorImagesSendNearTheHorizon) {
  const Glancing rows[] = {
      {Ward{glm::vec3(1), 0.1F}, 39, 1.98943679},
      {Ward{glm::vec3(1), 0x1p-14F}, 28, 5340353.88},
      {CookTorrance{glm::vec3(0), 0.01F}, 34, 19894.36963},
      {CookTorrance{glm::vec3(0), 0x1p-14F}, 28, 8.74963523e10},
  };
  for (const auto& [lobe, first, radiance] : rows)
    for (const int exponent : {first, 50, 100, 149})
      for (const float x : {0.3F, 0.45F, 0.6F}) {
        const glm::vec3 v(x, std::ldexp(1.0F, -exponent), std::sqrt(1 - x * x));
        const ShadingPoint point(glm::vec3(0), {0, 1, 0}, v, {glm::vec3(0), lobe});
        LightSet lights;
        lights.add_omni({-2 * v.x, 2 * v.y, -2 * v.z}, glm::vec3(1));
        const LightTree tree = build(lights);
        const Cut cut = CutSelector(tree)(point, everything);
        const Quad exact = precise::contribution(point, lights[0])[0];
        EXPECT_NEAR(double(exact), radiance, 1e-6 * radiance);
        EXPECT_LE(abs(Quad(cut.radiance.x) - exact), Quad(cut.certified_error.x))
            << names_of_lobes[lobe.index()] << ", n.v = 2^-" << exponent << ", x = " << x;
      }
}

struct InvertedHeap : StoppingRule {
  static bool refined_before(double key, double other) { return key < other; }
  template <class AllObey>
  static bool stops(AllObey&&) {
    return true;
  }
};

/// The library's estimates, other bounds.
struct OtherBound : ClusterKernel {
  [[nodiscard]] glm::dvec3 estimate(const LightTree& tree, std::uint32_t i,
                                    const ShadingPoint& point,
                                    const glm::vec3& bound) const override {
    return cluster_estimate(tree, i, point, bound);
  }
};

struct IntensityOfRepresentative : OtherBound {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t i,
                                const ShadingPoint& point) const override {
    const glm::vec3& own = tree.lights()[tree.node(i).representative].intensity;
    return contribution_bound(tree, i, point) *
           glm::vec3(glm::dvec3(own) / glm::max(tree.node(i).intensity, 0x1p-200));
  }
};

struct BoundOfRepresentative : OtherBound {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t i,
                                const ShadingPoint& point) const override {
    const Light& light = tree.lights()[tree.node(i).representative];
    return glm::vec3(transfer(point, light, tree.lights().min_distance()) * tree.node(i).intensity);
  }
};

struct RedOnly : OtherBound {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t i,
                                const ShadingPoint& point) const override {
    return glm::vec3(contribution_bound(tree, i, point).x);
  }
};

// The lobe underflows in double, but not in real numbers.
TEST(CutSelector, CertifiesWhatUnderflows) {
  LightSet lights;
  lights.add_omni({0, 32, 1}, glm::vec3(1));
  const Material mirror{glm::vec3(0), Phong{glm::vec3(1), 256}};
  const LightTree tree = build(lights);
  CutSelector select(tree);
  const Cut cut = select({glm::vec3(0), {0, 0, 1}, {0, 0, 1}, mirror}, everything);
  EXPECT_EQ(cut.radiance.x, 0);
  EXPECT_GT(cut.certified_error.x, 0);
}

/// The promises that are broken on any of a few hundred cases.
template <class Rule = StoppingRule>
std::set<std::string> convictions(const ClusterKernel& kernel = kernel_for(all_light_kinds)) {
  std::set<std::string> set;
  for (std::uint64_t seed = 1; seed <= 300; ++seed)
    set.insert(broken_promise<Rule>(gen::from_seed(cut_case(), seed), kernel));
  set.erase("");
  return set;
}

TEST(CutPromises, ConvictWhatIsBrokenAndOnlyThat) {
  EXPECT_TRUE(convictions().empty());
  EXPECT_TRUE(convictions<InvertedHeap>().contains("stops at max_size only"));
  EXPECT_TRUE(convictions(IntensityOfRepresentative()).contains("certified error holds"));
  EXPECT_TRUE(convictions(BoundOfRepresentative()).contains("certified error holds"));
  EXPECT_TRUE(convictions(RedOnly()).contains("certified error holds"));
}

RC_GTEST_PROP(CutSelector, AtZeroThresholdIsExact, ()) {
  CutCase cut_case_ = *cut_case();
  cut_case_.config = {0, 1000, 0};
  const LightTree tree = build(cut_case_.scene.light_set());
  const ShadingPoint point = cut_case_.scene.view.point();
  CutSelector select(tree, cut_case_.config);
  const Cut cut = select(point, cut_case_.visibility());
  const Colour exact = precise::sum(tree.lights(), point, cut_case_.visibility());
  RC_ASSERT(cut.end == CutEnd::converged);
  for (int c = 0; c < 3; ++c) {
    if (cut.radiance[c] == inf) {
      RC_ASSERT(exact[c] * (1 + estimate_error) > Quad(std::numeric_limits<float>::max()));
      continue;
    }
    // 2^-149: a subnormal is not relatively exact.
    RC_ASSERT(abs(Quad(cut.radiance[c]) - exact[c]) <=
              exact[c] * estimate_error * (1 + estimate_error) + Quad(0x1p-149));
  }
}

std::set<std::uint32_t> nodes_of(const Cut& cut) {
  std::set<std::uint32_t> nodes;
  for (const CutCluster& c : cut.clusters) nodes.insert(c.node);
  return nodes;
}

/// Whether no node of `coarse` lies below one of `fine`, both being partitions.
bool refines(const LightTree& tree, const std::set<std::uint32_t>& fine,
             const std::set<std::uint32_t>& coarse) {
  std::vector<std::uint32_t> open;
  const auto open_children = [&](std::uint32_t i) {
    if (const std::uint32_t child = tree.node(i).first_child; child != 0)
      open.insert(open.end(), {child, child + 1});
  };
  for (const std::uint32_t node : fine) open_children(node);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    if (coarse.contains(i)) return false;
    open_children(i);
  }
  return true;
}

RC_GTEST_PROP(CutSelector, ASmallerThresholdRefinesTheCutOfALargerOne, ()) {
  CutCase given = *cut_case();
  given.config.black_level = 0;
  const LightTree tree = build(given.scene.light_set());
  const ShadingPoint point = given.scene.view.point();
  std::set<std::uint32_t> coarse{0};
  for (const float threshold : {1e6F, 8.0F, 2.0F, 0.5F, 0.1F, 0.02F, 0.003F, 1e-6F, 0.0F}) {
    given.config.threshold = threshold;
    CutSelector select(tree, given.config);
    const std::set<std::uint32_t> fine = nodes_of(select(point, given.visibility()));
    RC_ASSERT(refines(tree, fine, coarse));
    coarse = fine;
  }
}

bool same(const Cut& a, const Cut& b) {
  return a.radiance == b.radiance && a.certified_error == b.certified_error && a.end == b.end &&
         std::equal(a.clusters.begin(), a.clusters.end(), b.clusters.begin(), b.clusters.end(),
                    [](const CutCluster& x, const CutCluster& y) {
                      return x.node == y.node && x.estimate == y.estimate && x.bound == y.bound;
                    });
}

RC_GTEST_PROP(CutSelector, YieldsTheSameBitsAgainAndAfterAnotherPoint, ()) {
  const CutCase given = *cut_case();
  const ShadingPoint other = (*gen::scene(1)).view.point();
  const LightTree tree = build(given.scene.light_set());
  const ShadingPoint point = given.scene.view.point();
  CutSelector fresh(tree, given.config), used(tree, given.config);
  (void)used(other, everything);
  RC_ASSERT(same(fresh(point, given.visibility()), used(point, given.visibility())));
}

RC_GTEST_PROP(CutSelector, DoesNotAllocateOnceWarm, ()) {
  const CutCase given = *cut_case();
  const LightTree tree = build(given.scene.light_set());
  const ShadingPoint point = given.scene.view.point();
  CutSelector select(tree, given.config);
  (void)select(point, everything);
  const std::size_t before = allocation_count();
  (void)select(point, everything);
  const std::size_t after = allocation_count();
  RC_ASSERT(before == after);
}

ShadingPoint floor_at(const glm::vec3& position) {
  return {position, {0, 0, 1}, {0, 0, 1}, {glm::vec3(1)}};
}

LightSet row(int count) {
  LightSet lights;
  for (int i = 0; i < count; ++i) lights.add_omni({i, 0, 1}, glm::vec3(1));
  return lights;
}

TEST(CutSelector, OfNoLightsIsBlackAndEmpty) {
  const LightTree tree;
  CutSelector select(tree);
  const Cut cut = select(floor_at({0, 0, 0}), everything);
  EXPECT_TRUE(cut.clusters.empty());
  EXPECT_EQ(cut.radiance, glm::vec3(0));
  EXPECT_EQ(cut.certified_error, glm::vec3(0));
  EXPECT_EQ(cut.end, CutEnd::converged);
}

TEST(CutSelector, OfOneLightIsThatLight) {
  const LightTree tree = build(row(1));
  CutSelector select(tree);
  const Cut cut = select(floor_at({0, 0, 0}), everything);
  ASSERT_EQ(cut.clusters.size(), 1U);
  EXPECT_EQ(cut.shadow_rays, 1U);
  EXPECT_FLOAT_EQ(cut.radiance.x, float(std::numbers::inv_pi));
}

TEST(CutSelector, ScalesTheRepresentativeToTheIntensityOfTheCluster) {
  LightSet lights;
  for (int i = 0; i < 3; ++i) lights.add_omni({0, 0, 1}, {i, i * i, 0});
  const LightTree tree = build(lights);
  CutSelector select(tree, {.max_size = 1});
  const Cut cut = select(floor_at({0, 0, 0}), everything);
  EXPECT_FLOAT_EQ(cut.radiance.x, 3 * float(std::numbers::inv_pi));
  EXPECT_FLOAT_EQ(cut.radiance.y, 5 * float(std::numbers::inv_pi));
  EXPECT_EQ(cut.radiance.z, 0);
}

TEST(CutSelector, RefinesADarkPointToTheEnd) {
  const LightTree tree = build(row(20));
  CutSelector select(tree);
  const Cut cut = select(floor_at({0, 0, 0}), [](std::uint32_t) { return false; });
  EXPECT_EQ(cut.clusters.size(), 20U);
  EXPECT_EQ(cut.radiance, glm::vec3(0));
  EXPECT_EQ(cut.end, CutEnd::converged);
}

TEST(CutSelector, StopsADarkPointAtBlackLevel) {
  const LightTree tree = build(row(20));
  CutSelector select(tree, {.black_level = 1});
  const Cut cut = select(floor_at({0, 0, 0}), [](std::uint32_t) { return false; });
  EXPECT_LT(cut.clusters.size(), 20U);
  EXPECT_EQ(cut.end, CutEnd::black_level);
  for (const CutCluster& c : cut.clusters) EXPECT_LE(c.bound.x, 1);
}

TEST(CutSelector, SendsNoShadowRaysFromBelow) {
  const LightTree tree = build(row(20));
  CutSelector select(tree);
  const Cut cut = select(floor_at({0, 0, 2}), everything);
  EXPECT_EQ(cut.shadow_rays, 0U);
  EXPECT_EQ(cut.clusters.size(), 1U);
}

TEST(CutSelector, GoesOnInAChannelThatIsAllButDark) {
  LightSet lights = row(30);
  for (int i = 0; i < 30; ++i) lights.add_omni({i, 1, 1}, {0, 1e-8F, 0});
  const LightTree tree = build(lights);
  CutSelector select(tree, {.threshold = 0.01F});
  EXPECT_EQ(select(floor_at({0, 0, 0}), everything).end, CutEnd::converged);
}

TEST(CutConfig, NamesTheFieldItRefuses) {
  const auto refusal = [](const CutConfig& config) -> std::string {
    try {
      validate(config);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({}), "");
  EXPECT_NE(refusal({.threshold = -0.1F}).find("threshold"), std::string::npos);
  EXPECT_NE(refusal({.threshold = nan}).find("threshold"), std::string::npos);
  EXPECT_NE(refusal({.black_level = nan}).find("black_level"), std::string::npos);
  EXPECT_NE(refusal({.max_size = 0}).find("max_size"), std::string::npos);
}

RC_GTEST_PROP(CutSelector, CertifiesLessAndCastsNoRayWhereNothingOccludes, ()) {
  const gen::Scene scene = *gen::scene();
  const LightTree tree = build(scene.light_set());
  const ShadingPoint point = scene.view.point();
  const auto never_asked = [](std::uint32_t) -> bool { throw std::logic_error("asked"); };
  const auto all_seen = [](std::uint32_t) { return true; };
  CutConfig config{0.3F, 5};
  CutSelector select(tree, config);
  const Cut asking = select(point, all_seen);
  config.unoccluded = true;
  CutSelector select_unoccluded(tree, config);
  const Cut cut = select_unoccluded(point, never_asked);
  RC_ASSERT(cut.radiance == asking.radiance);
  RC_ASSERT(cut.shadow_rays == 0U);
  RC_ASSERT(promises::certified(cut, precise::sum(tree.lights(), point, all_seen)));
  for (int c = 0; c < 3; ++c) RC_ASSERT(cut.certified_error[c] <= asking.certified_error[c]);
}

} // namespace
} // namespace lightcuts
