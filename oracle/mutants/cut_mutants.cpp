// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <lightcuts/core/cut/certified_error.h>

#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

// ---- other rules

struct HeapInverted : StoppingRule {
  static bool refined_before(double key, double other) { return key < other; }
  template <class AllObey>
  static bool stops(AllObey&&) {
    return true;
  }
};

struct AverageChannelTest : StoppingRule {
  static bool obeys(const glm::vec3& bound, const glm::dvec3& total, const CutConfig& config) {
    double ratios = 0;
    for (int c = 0; c < 3; ++c)
      if (bound[c] > config.black_level) ratios += bound[c] / total[c];
    return ratios / 3 <= config.threshold;
  }
};

struct ComparatorNotStrict : StoppingRule {
  static bool refined_before(double key, double other) { return key >= other; }
};

struct CacheAcrossPoints : LibraryKernel {
  [[nodiscard]] glm::vec3 bound(const LightTree& tree, std::uint32_t node,
                                const ShadingPoint& point) const override {
    const auto known = bounds.find(node);
    if (known != bounds.end()) return known->second;
    return bounds[node] = LibraryKernel::bound(tree, node, point);
  }
  mutable std::map<std::uint32_t, glm::vec3> bounds;
};

/// Selects by cached bounds; asked for one, it computes it.
class CachingTree : public LibraryTree {
public:
  explicit CachingTree(std::shared_ptr<const LightTree> tree)
      : LibraryTree(std::move(tree), std::make_shared<CacheAcrossPoints>()) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<CachingTree>(shared_tree());
  }
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    return contribution_bound(tree(), node, point);
  }
};

// ---- the library's cut, spoilt

/// A cut in the making.
struct OpenCut {
  const LightTree& tree;
  const ShadingPoint& point;
  const CutConfig& config;
  const std::function<bool(std::uint32_t)>& visible;
  Cut cut;
  std::vector<CutCluster> clusters;

  /// As the library has it for an inner node on the way to the cut.
  [[nodiscard]] glm::dvec3 estimate(std::uint32_t node) const {
    const Light& one = tree.lights()[tree.node(node).representative];
    const glm::vec3 from = viewed_from(one.kind, point.position());
    if (dot_between(point.normal(), from, one.position) > 0 &&
        !visible(tree.node(node).representative))
      return glm::dvec3(0);
    return cluster_estimate(tree, node, point, contribution_bound(tree, node, point));
  }

  /// The nodes that were refined, parents first.
  [[nodiscard]] std::vector<std::uint32_t> refined() const {
    std::vector<bool> in_cut(tree.nodes().size(), false);
    for (const CutCluster& c : clusters) in_cut[c.node] = true;
    std::vector<std::uint32_t> list;
    if (!in_cut[0]) list.push_back(0);
    for (std::size_t at = 0; at < list.size(); ++at)
      for (const std::uint32_t child :
           {tree.node(list[at]).first_child, tree.node(list[at]).first_child + 1})
        if (!in_cut[child] && !tree.node(child).is_leaf()) list.push_back(child);
    return list;
  }

  /// Calls add(estimate, sign) for each refinement: the parent out, its children in.
  template <class Add>
  void replay(const Add& add) const {
    add(estimate(0), 1.0);
    for (const std::uint32_t node : refined()) {
      add(estimate(node), -1.0);
      add(estimate(tree.node(node).first_child), 1.0);
      add(estimate(tree.node(node).first_child + 1), 1.0);
    }
  }

  void set_radiance(const glm::dvec3& total) {
    for (int c = 0; c < 3; ++c) cut.radiance[c] = to_float(total[c]);
  }

  /// Radiance and certified error of what is left of the clusters.
  void sum_anew() {
    glm::dvec3 total(0), bounds(0);
    for (const CutCluster& c : clusters) {
      total += c.estimate;
      bounds += glm::dvec3(c.bound);
    }
    set_radiance(total);
    for (int c = 0; c < 3; ++c) cut.certified_error[c] = certified_error(total[c], bounds[c]);
  }
};

template <void spoil(OpenCut&)>
class SpoiltTree : public CopiedPerThread<SpoiltTree<spoil>> {
public:
  using CopiedPerThread<SpoiltTree<spoil>>::CopiedPerThread;
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    const Cut cut = LibraryTree::select(point, config, visible);
    OpenCut open{this->tree(), point, config,
                 visible,      cut,   {cut.clusters.begin(), cut.clusters.end()}};
    spoil(open);
    clusters_ = std::move(open.clusters);
    open.cut.clusters = clusters_;
    return open.cut;
  }

private:
  std::vector<CutCluster> clusters_;
};

void lose_popped(OpenCut& open) {
  const auto popped = std::max_element(
      open.clusters.begin(), open.clusters.end(),
      [](const CutCluster& a, const CutCluster& b) { return a.bound.x < b.bound.x; });
  if (open.cut.end != CutEnd::converged || popped->bound.x == 0) return;
  open.clusters.erase(popped);
  open.sum_anew();
}

void lose_leaf(OpenCut& open) {
  const auto leaf =
      std::find_if(open.clusters.begin(), open.clusters.end(),
                   [&](const CutCluster& c) { return open.tree.node(c.node).is_leaf(); });
  if (open.clusters.size() == 1 || leaf == open.clusters.end()) return;
  open.clusters.erase(leaf);
  open.sum_anew();
}

void never_subtract(OpenCut& open) {
  glm::dvec3 total(0);
  open.replay([&](const glm::dvec3& e, double sign) {
    if (sign > 0) total += e;
  });
  open.set_radiance(total);
}

void subtract_by_wrong_scale(OpenCut& open) {
  glm::dvec3 total(0);
  for (const CutCluster& c : open.clusters) total += c.estimate;
  for (const std::uint32_t node : open.refined()) {
    const std::uint32_t child = open.tree.node(node).first_child;
    // The parent leaves with its child's intensity: the rest stays.
    const glm::dvec3 kept = open.tree.node(node).intensity - open.tree.node(child).intensity;
    for (int c = 0; c < 3; ++c)
      if (kept[c] > 0)
        total[c] += open.estimate(node)[c] * (kept[c] / open.tree.node(node).intensity[c]);
  }
  open.set_radiance(total);
}

void keep_parents_light(OpenCut& open) {
  for (const std::uint32_t node : open.refined())
    for (CutCluster& c : open.clusters) {
      const std::uint32_t first = open.tree.node(node).first_child;
      const bool is_child = c.node == first || c.node == first + 1;
      if (is_child && open.tree.node(c.node).representative == open.tree.node(node).representative)
        c.estimate = open.estimate(node);
    }
  open.sum_anew();
}

void say_converged(OpenCut& open) { open.cut.end = CutEnd::converged; }

void say_no_black_level(OpenCut& open) {
  if (open.cut.end == CutEnd::black_level) open.cut.end = CutEnd::converged;
}

void halve_where_unoccluded(OpenCut& open) {
  if (open.config.unoccluded) open.cut.certified_error *= 0.5F;
}

void add_in_floats(OpenCut& open) {
  glm::vec3 total(0);
  open.replay([&](const glm::dvec3& e, double sign) { total += glm::vec3(sign * e); });
  open.cut.radiance = glm::max(total, glm::vec3(0));
}

void subtract_without_summing_anew(OpenCut& open) {
  glm::dvec3 total(0);
  open.replay([&](const glm::dvec3& e, double sign) { total += sign * e; });
  for (int c = 0; c < 3; ++c) open.cut.radiance[c] = float(total[c]); // may be below 0
}

// ---- another configuration

template <CutConfig other(const CutConfig&, LibraryTree&, const ShadingPoint&)>
class ReconfiguredTree : public CopiedPerThread<ReconfiguredTree<other>> {
public:
  using CopiedPerThread<ReconfiguredTree<other>>::CopiedPerThread;
  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    Cut cut = LibraryTree::select(point, other(config, *this, point), visible);
    if (cut.end == CutEnd::black_level) cut.end = CutEnd::converged;
    return cut;
  }
};

CutConfig one_more(const CutConfig& config, LibraryTree&, const ShadingPoint&) {
  CutConfig other = config;
  ++other.max_size;
  return other;
}

CutConfig by_first_guess(const CutConfig& config, LibraryTree& tree, const ShadingPoint& point) {
  const glm::dvec3 guess = tree.estimate(0, point, tree.bound(0, point));
  CutConfig other = config;
  other.threshold = 0;
  other.black_level = std::max(config.black_level,
                               to_float(config.threshold * std::max({guess.x, guess.y, guess.z})));
  return other;
}

// ---- the catalogue

constexpr Mutant cut_catalogue[] = {
    {"heap-inverted", "refines the smallest bound first, and stops on it", with_rule<HeapInverted>},
    {"popped-is-lost", "does not put back the cluster that was found good enough",
     with_tree<SpoiltTree<lose_popped>>},
    {"leaf-is-lost", "does not put back a leaf", with_tree<SpoiltTree<lose_leaf>>},
    {"never-subtracts-parent", "adds the children without taking the parent out",
     with_tree<SpoiltTree<never_subtract>>},
    {"wrong-refinement-scale", "takes the parent out with the intensity of its child",
     with_tree<SpoiltTree<subtract_by_wrong_scale>>},
    {"shared-representative-unscaled",
     "leaves the child that has the parent's representative the parent's light",
     with_tree<SpoiltTree<keep_parents_light>>},
    {"average-channel-test", "compares the mean of the channels' ratios with the threshold",
     with_rule<AverageChannelTest>},
    {"threshold-on-first-guess", "takes the threshold of the root's estimate for good",
     with_tree<ReconfiguredTree<by_first_guess>>},
    {"stops-at-size-silently", "calls a cut converged that has reached its largest size",
     with_tree<SpoiltTree<say_converged>>},
    {"black-level-unsaid", "calls a cut converged that needed the black level",
     with_tree<SpoiltTree<say_no_black_level>>},
    {"half-if-unoccluded", "certifies half the error where nothing can be occluded",
     with_tree<SpoiltTree<halve_where_unoccluded>>},
    {"drift", "adds and subtracts in floats", with_tree<SpoiltTree<add_in_floats>>},
    {"cache-across-points", "reuses bounds of one shading point at the next",
     with_tree<CachingTree>},
    {"comparator-not-strict", "refines each of two equal bounds before the other",
     with_rule<ComparatorNotStrict>},
    {"negative-total", "goes below 0 where estimates are taken out of a total",
     with_tree<SpoiltTree<subtract_without_summing_anew>>},
    {"capacity-off-by-one", "refines once more at the largest size",
     with_tree<ReconfiguredTree<one_more>>},
};

} // namespace

std::span<const Mutant> cut_mutants() { return cut_catalogue; }

} // namespace lightcuts::oracle
