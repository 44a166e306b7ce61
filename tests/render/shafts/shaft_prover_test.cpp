// SPDX-License-Identifier: MIT
#include <lightcuts/render/shafts/shaft_prover.h>

#include <numeric>

#include <gtest/gtest.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/view/occluder.h>
#include <lightcuts/render/view/surface_point.h>

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

// That all that is proven is so is judged by the oracle, proven-visibility-holds; these prove
// nothing wrong, but too little.

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
    for (int u = 0; u < 4; ++u)
      for (int v = 0; v < 4; ++v) {
        const Hit hit{0, {0.3F + 0.01F * float(u), 0.3F + 0.01F * float(v)}, 1};
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
