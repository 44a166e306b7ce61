// SPDX-License-Identifier: MIT
#include <lightcuts/render/shafts/shaft_prover.h>

#include <cstdlib>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include <tests/render/shafts/nasty_scene.h>

namespace lightcuts {
namespace {

struct Proofs {
  int seen = 0, hidden = 0, wrong = 0;
};

void lights_of(const LightTree& tree, std::uint32_t node, std::vector<glm::vec3>& positions) {
  if (tree.node(node).is_leaf()) {
    positions.push_back(tree.lights()[tree.node(node).representative].position);
    return;
  }
  lights_of(tree, tree.node(node).first_child, positions);
  lights_of(tree, tree.node(node).first_child + 1, positions);
}

/// Goes down the tree as far as nothing is proven, and asks a ray of each point and light of what
/// is.
template <class Rules>
class Judge {
public:
  Judge(const TriangleMesh& mesh, const std::vector<glm::vec3>& origins, const LightSet& lights)
      : occluder_(mesh), triangles_(mesh), tree_(build(lights)), origins_(origins),
        prover_(triangles_, origins) {
    std::vector<std::uint32_t> all(origins.size());
    std::iota(all.begin(), all.end(), 0U);
    prover_.start(all);
    judge(0, {});
  }
  Proofs found;

private:
  void judge(std::uint32_t node, const ProvenVisibility::Proof& within) {
    const auto proof = prover_.prove(tree_.node(node), within);
    if (proof.sight != ProvenSight::unknown) {
      const bool hidden = proof.sight == ProvenSight::hidden;
      ++(hidden ? found.hidden : found.seen);
      if (!holds(node, hidden)) ++found.wrong;
    } else if (!tree_.node(node).is_leaf()) {
      judge(tree_.node(node).first_child, proof);
      judge(tree_.node(node).first_child + 1, proof);
    }
  }
  [[nodiscard]] bool holds(std::uint32_t node, bool hidden) const {
    std::vector<glm::vec3> lights;
    lights_of(tree_, node, lights);
    for (const glm::vec3& origin : origins_)
      for (const glm::vec3& light : lights)
        if (occluder_.occluded(shadow_ray(origin, light)) != hidden) return false;
    return true;
  }

  Occluder occluder_;
  TriangleTree triangles_;
  LightTree tree_;
  const std::vector<glm::vec3>& origins_;
  BasicShaftProver<Rules> prover_;
};

template <class Rules>
Proofs campaign(int scenes) {
  Proofs all;
  for (int seed = 0; seed < scenes; ++seed) {
    const NastyScene scene{std::uint64_t(seed)};
    const Proofs found = Judge<Rules>(scene.mesh, scene.origins, scene.lights).found;
    all.seen += found.seen;
    all.hidden += found.hidden;
    all.wrong += found.wrong;
  }
  return all;
}

constexpr int scenes = 1500;

/// LIGHTCUTS_SHAFT_SCENES in the environment: how many.
TEST(ShaftProver, ProvesWhatRaysAnswer) {
  const char* wanted = std::getenv("LIGHTCUTS_SHAFT_SCENES");
  const Proofs found = campaign<ShaftRules>(wanted != nullptr ? std::atoi(wanted) : scenes);
  EXPECT_EQ(found.wrong, 0);
  EXPECT_GT(found.seen, scenes / 2);
  EXPECT_GT(found.hidden, scenes / 4);
}

// Broken ones, each of which the same campaign convicts.

struct ShrunkenShaft : ShaftRules {
  static Shaft shaft(const Box& from, const Box& to) {
    const glm::vec3 middle = 0.5F * (to.lo + to.hi);
    return {from, {middle, middle}};
  }
};

struct NoMargin : ShaftRules {
  static double margin() { return 0; }
  static bool misses(const FlatTriangle& t, const RayEnds& ends, double separation) {
    double lo = 1e30, hi = -1e30;
    for (int k = 0; k < 8; ++k) {
      const glm::dvec3 y((k & 1) != 0 ? ends.to.hi.x : ends.to.lo.x,
                         (k & 2) != 0 ? ends.to.hi.y : ends.to.lo.y,
                         (k & 4) != 0 ? ends.to.hi.z : ends.to.lo.z);
      lo = std::min(lo, t.height(y));
      hi = std::max(hi, t.height(y));
    }
    for (const glm::dvec3& x : ends.origins) {
      lo = std::min(lo, t.height(x));
      hi = std::max(hi, t.height(x));
    }
    return separation >= 0 || lo >= 0 || hi <= 0;
  }
};

struct CoveredAtTheCentre : ShaftRules {
  static bool covers(const FlatTriangle& t, const FlatTriangle& partner, const RayEnds& ends) {
    RayEnds centre;
    const glm::vec3 from = 0.5F * (ends.from.lo + ends.from.hi);
    const glm::vec3 to = 0.5F * (ends.to.lo + ends.to.hi);
    centre.start_at({&from, 1});
    centre.end_in({to, to});
    return certainly_covers(t, partner, centre);
  }
};

struct InheritedFromAnother : ShaftRules {
  static std::uint32_t inherited(const ProvenVisibility::Proof& within) {
    static std::uint32_t before = 0; // of the cluster asked for before
    if (within.candidates == 0) before = 0;
    return std::exchange(before, within.candidates);
  }
};

TEST(ShaftProver, BrokenShaftsAreConvicted) {
  EXPECT_GT(campaign<ShrunkenShaft>(scenes).wrong, 0);
  EXPECT_GT(campaign<NoMargin>(scenes).wrong, 0);
  EXPECT_GT(campaign<CoveredAtTheCentre>(scenes).wrong, 0);
  EXPECT_GT(campaign<InheritedFromAnother>(scenes).wrong, 0);
}

// Those that prove nothing wrong, but too little.

struct WithoutSides : ShaftRules {
  static Shaft shaft(const Box& from, const Box& to) {
    Box both = from;
    both.extend(to);
    return {both, both};
  }
};

struct OwnBoxCounted : ShaftRules {
  static bool misses(const FlatTriangle& t, const RayEnds& ends, double separation) {
    RayEnds box = ends;
    box.origins.clear();
    for (const float x : {ends.from.lo.x, ends.from.hi.x})
      for (const float y : {ends.from.lo.y, ends.from.hi.y}) {
        box.origins.emplace_back(x, y, ends.from.lo.z);
        box.origins.emplace_back(x, y, ends.from.hi.z);
      }
    return certainly_missed(t, box, separation);
  }
};

struct SlopeBesideBox {
  TriangleMesh mesh;
  std::vector<glm::vec3> origins;
  LightSet lights;

  SlopeBesideBox() {
    mesh.positions = {{-1, -1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, 1, 1}};
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
    for (int i = 0; i < 16; ++i) {
      const Hit hit{0, {0.3F + 0.01F * float(i % 4), 0.3F + 0.01F * float(i / 4)}, 1};
      origins.push_back(surface_point(mesh, hit, {1, -1, 0}).ray_origin);
    }
    for (int i = 0; i < 4; ++i) lights.add_omni({-3, 3 + 0.1F * float(i), 3}, glm::vec3(1));
    for (int i = 0; i < 400; ++i) { // a wall of strips, within the box around the shaft
      const auto first = std::uint32_t(mesh.positions.size());
      const float x = -0.6F - 0.01F * float(i);
      mesh.positions.insert(mesh.positions.end(), {{x, 1, 3}, {x - 0.01F, 1, 3}, {x, 0.9F, 3.1F}});
      mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
  }
  template <class Rules>
  [[nodiscard]] Proofs proofs() const {
    return Judge<Rules>(mesh, origins, lights).found;
  }
};

TEST(ShaftProver, SeesPastWhatIsBesideTheShaftAndItsOwnSurface) {
  const SlopeBesideBox scene;
  EXPECT_EQ(scene.proofs<ShaftRules>().seen, 1) << "all lights at once";
  EXPECT_EQ(scene.proofs<OwnBoxCounted>().seen, 0);
  EXPECT_EQ(scene.proofs<WithoutSides>().seen, 0);
}

} // namespace
} // namespace lightcuts
