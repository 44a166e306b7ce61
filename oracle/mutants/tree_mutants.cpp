// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <oracle/truth/naive_tree.h>

#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

/// The library's tree after `change` of each inner node, children first.
template <void change(const LightSet& lights, std::vector<TreeNode>& nodes, TreeNode& node)>
LightTree changed(const LightSet& lights, std::uint64_t seed) {
  const LightTree tree = build(lights, {seed});
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (!nodes[i].is_leaf()) change(lights, nodes, nodes[i]);
  return {lights, std::move(nodes)};
}

void miss_second_child(const LightSet& /*lights*/, std::vector<TreeNode>& nodes, TreeNode& node) {
  const Box &a = nodes[node.first_child].box, &b = nodes[node.first_child + 1].box;
  node.box = a;
  node.box.extend({b.lo.x, a.lo.y, b.lo.z}); // y is forgotten
  node.box.extend({b.hi.x, a.hi.y, b.hi.z});
}

void take_any_representative(const LightSet& /*lights*/, std::vector<TreeNode>& /*nodes*/,
                             TreeNode& node) {
  node.representative = 0;
}

void take_colour(const LightSet& lights, std::vector<TreeNode>& /*nodes*/, TreeNode& node) {
  const glm::dvec3 colour(lights[node.representative].intensity);
  const double power = node.intensity.x + node.intensity.y + node.intensity.z;
  const double own = colour.x + colour.y + colour.z;
  if (own > 0) node.intensity = colour * (power / own);
}

LightTree stale_child(const LightSet& lights, std::uint64_t seed) {
  LightTree tree = build(lights, {seed});
  // A cluster that is said to be of profiles and has other lights has no table to be bounded by.
  if ((lights.kinds() & only(LightKind::profile)) != 0) return tree;
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  if (nodes.size() > 1) {
    std::swap(nodes[1], nodes[2]);
    std::swap(nodes[1].first_child, nodes[2].first_child); // where they were
    std::swap(nodes[1].kinds, nodes[2].kinds);
  }
  return {lights, std::move(nodes)};
}

double with_representative(const NaiveCluster& a, const NaiveCluster& b) {
  NaiveCluster one = a, none = b;
  one.weight = a.representative_weight;
  none.weight = 0;
  return greedy_metric(one, none);
}

double with_difference(const NaiveCluster& a, const NaiveCluster& b) {
  NaiveCluster one = a, none = b;
  one.weight = std::abs(a.weight - b.weight);
  none.weight = 0;
  return greedy_metric(one, none);
}

template <double metric(const NaiveCluster&, const NaiveCluster&)>
LightTree by_metric(const LightSet& lights, std::uint64_t seed) {
  constexpr std::size_t most = 64; // it takes N^3
  const bool of_one_kind = (lights.kinds() & (lights.kinds() - 1)) == 0;
  return lights.size() <= most && of_one_kind ? naive_tree(lights, metric) : build(lights, {seed});
}

// ---- lights lost or counted twice: a tree over other lights

class RelabelledTree : public LibraryTree {
public:
  /// Light i of the tree is light original[i] of the scene.
  RelabelledTree(std::shared_ptr<const LightTree> tree, std::vector<std::uint32_t> original)
      : LibraryTree(std::move(tree)), original_(std::move(original)) {}

  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<RelabelledTree>(shared_tree(), original_);
  }
  [[nodiscard]] TreeClaim claim() const override {
    TreeClaim claim = LibraryTree::claim();
    for (auto& node : claim.nodes) node.representative = original_[node.representative];
    for (auto& light : claim.lights) light = original_[light];
    return claim;
  }
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    return LibraryTree::select(point, config,
                               [&](std::uint32_t light) { return visible(original_[light]); });
  }

private:
  std::vector<std::uint32_t> original_;
};

/// The library, over those lights of the scene.
template <std::vector<std::uint32_t> chosen(const LightSet& lights)>
class OtherLights : public KernelSubject {
public:
  using KernelSubject::KernelSubject;
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    std::vector<std::uint32_t> original = chosen(lights);
    LightSet set;
    for (const std::uint32_t light : original) set.add(lights[light]);
    if (lights.min_distance() > 0) set.set_min_distance(lights.min_distance());
    return std::make_unique<RelabelledTree>(
        std::make_shared<const LightTree>(lightcuts::build(set, {seed})), std::move(original));
  }
};

template <std::vector<std::uint32_t> chosen(const LightSet& lights)>
std::unique_ptr<Subject> with_lights(const char* name) {
  return std::make_unique<OtherLights<chosen>>(name);
}

std::vector<std::uint32_t> all_of(const LightSet& lights) {
  std::vector<std::uint32_t> list;
  for (std::uint32_t i = 0; i < lights.size(); ++i) list.push_back(i);
  return list;
}

std::vector<std::uint32_t> without_odd_one(const LightSet& lights) {
  std::vector<std::uint32_t> list = all_of(lights);
  if (list.size() > 1 && list.size() % 2 == 1) list.pop_back();
  return list;
}

std::vector<std::uint32_t> with_odd_one_twice(const LightSet& lights) {
  std::vector<std::uint32_t> list = all_of(lights);
  if (list.size() > 1 && list.size() % 2 == 1) list.push_back(list.back());
  return list;
}

std::vector<std::uint32_t> one_per_place(const LightSet& lights) {
  std::vector<std::uint32_t> list;
  for (const std::uint32_t i : all_of(lights))
    if (std::none_of(list.begin(), list.end(),
                     [&](std::uint32_t j) { return lights[i].position == lights[j].position; }))
      list.push_back(i);
  return list;
}

constexpr Mutant tree_catalogue[] = {
    {"box-misses-child", "leaves the second child's y out of the parent's box",
     with_altered<changed<miss_second_child>>},
    {"metric-ignores-intensity", "clusters by size and the intensity of one representative",
     with_altered<by_metric<with_representative>>},
    {"metric-difference", "clusters by the difference of intensities",
     with_altered<by_metric<with_difference>>},
    {"lost-light", "drops the odd light out in pairing", with_lights<without_odd_one>},
    {"double-light", "pairs the odd light out with itself", with_lights<with_odd_one_twice>},
    {"coincident-dropped", "takes lights at one place for one light", with_lights<one_per_place>},
    {"representative-outside", "represents clusters by a light of another one",
     with_altered<changed<take_any_representative>>},
    {"colour-of-representative", "paints clusters in the colour of their representative",
     with_altered<changed<take_colour>>},
    {"stale-child", "swaps two nodes but for the index of their children",
     with_altered<stale_child>},
};

} // namespace

std::span<const Mutant> tree_mutants() { return tree_catalogue; }

} // namespace lightcuts::oracle
