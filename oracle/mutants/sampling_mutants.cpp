// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include <lightcuts/core/numerics/splitmix.h>

#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

/// The library's tree, but for how it draws.
class OtherDraws : public BatchedTree<> {
public:
  using BatchedTree::BatchedTree;
  /// Lights each cluster of the library's cut by what sample() draws.
  Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
           const std::function<bool(std::uint32_t)>& visible) override {
    return lit(chosen(point, config), point, query, visible);
  }
  /// The cut is chosen once, and shares of children are computed once.
  void draws(const ShadingPoint& point, const CutConfig& config,
             std::span<const std::uint64_t> queries,
             const std::function<bool(std::uint32_t)>& visible,
             const std::function<void(const Cut&)>& take) override {
    const Cut cut = chosen(point, config);
    shares_.forget();
    shares_of_ = &point;
    for (const std::uint64_t query : queries) take(lit(cut, point, query, visible));
    shares_of_ = nullptr;
  }
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    if (&point != shares_of_) return LibraryTree::sample(node, point, u);
    const LightSample s = sample_light(shares_, tree(), node, point, u);
    return {s.light, s.probability};
  }

protected:
  /// The random number of a cluster.
  [[nodiscard]] virtual double number(std::uint64_t query, std::uint32_t node) const {
    return random_number(1, query, node);
  }
  [[nodiscard]] glm::dvec3 light_of(std::uint32_t light, const ShadingPoint& point,
                                    const std::function<bool(std::uint32_t)>& visible) const {
    const Light& one = tree().lights()[light];
    if (!visible(light)) return glm::dvec3(0);
    return transfer(point, one, tree().lights().min_distance()) * glm::dvec3(one.intensity);
  }
  virtual glm::dvec3 estimate_of(std::uint32_t node, const ShadingPoint& point, std::uint64_t query,
                                 const std::function<bool(std::uint32_t)>& visible) {
    const DrawnLight drawn = sample(node, point, number(query, node));
    if (drawn.probability == 0) return glm::dvec3(0);
    return light_of(drawn.light, point, visible) / drawn.probability;
  }

private:
  [[nodiscard]] Cut chosen(const ShadingPoint& point, const CutConfig& config) {
    return select(point, config, [](std::uint32_t) { return true; });
  }
  Cut lit(Cut cut, const ShadingPoint& point, std::uint64_t query,
          const std::function<bool(std::uint32_t)>& visible) {
    clusters_.assign(cut.clusters.begin(), cut.clusters.end());
    glm::dvec3 total(0);
    for (CutCluster& c : clusters_) {
      c.estimate = estimate_of(c.node, point, query, visible);
      total += c.estimate;
    }
    for (int c = 0; c < 3; ++c) cut.radiance[c] = to_float(total[c]);
    cut.clusters = clusters_;
    return cut;
  }

  std::vector<CutCluster> clusters_;
  SharesAtPoint<HierarchicalImportance> shares_;
  const ShadingPoint* shares_of_ = nullptr; ///< at which draws() are being made
};

/// Numbers of its own at each level, not u: asked again, it draws another light.
class RandomNumberLost : public CopiedPerThread<RandomNumberLost, OtherDraws> {
public:
  using CopiedPerThread<RandomNumberLost, OtherDraws>::CopiedPerThread;
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double /*u*/) override {
    return OtherDraws::sample(node, point, double(splitmix64(count_++) >> 11) * 0x1p-53);
  }

private:
  std::uint64_t count_ = 0;
};

class OneNumberForAll : public CopiedPerThread<OneNumberForAll, OtherDraws> {
public:
  using CopiedPerThread<OneNumberForAll, OtherDraws>::CopiedPerThread;

protected:
  [[nodiscard]] double number(std::uint64_t query, std::uint32_t /*node*/) const override {
    return random_number(1, query, 0);
  }
};

/// Two successive queries have the same numbers.
class QueriesInPairs : public CopiedPerThread<QueriesInPairs, OtherDraws> {
public:
  using CopiedPerThread<QueriesInPairs, OtherDraws>::CopiedPerThread;

protected:
  [[nodiscard]] double number(std::uint64_t query, std::uint32_t node) const override {
    return random_number(1, query / 2, node);
  }
};

/// Random numbers that go on from draw to draw: asked the same again, it draws others, as well
/// distributed.
class DrawsGoOn : public CopiedPerThread<DrawsGoOn, OtherDraws> {
public:
  using CopiedPerThread<DrawsGoOn, OtherDraws>::CopiedPerThread;

protected:
  [[nodiscard]] double number(std::uint64_t query, std::uint32_t node) const override {
    return random_number(++count_, query, node);
  }

private:
  mutable std::uint64_t count_ = 0;
};

/// One light for its probability, another one to shade with.
class ResampledBetween : public CopiedPerThread<ResampledBetween, OtherDraws> {
public:
  using CopiedPerThread<ResampledBetween, OtherDraws>::CopiedPerThread;

protected:
  glm::dvec3 estimate_of(std::uint32_t node, const ShadingPoint& point, std::uint64_t query,
                         const std::function<bool(std::uint32_t)>& visible) override {
    const DrawnLight drawn = sample(node, point, random_number(1, query, node));
    const DrawnLight again = sample(node, point, random_number(2, query, node));
    if (drawn.probability == 0 || again.probability == 0) return glm::dvec3(0);
    return light_of(again.light, point, visible) / drawn.probability;
  }
};

/// Where a draw goes from a cluster: to the first child or the second, with that probability, and
/// by which number from there.
struct Step {
  bool to_first;
  double probability, number;
};

Step step_by(const ChildShares& share, double u) {
  const bool first = u < share.first;
  const double p = first ? share.first : share.second;
  return {first, p, std::min((first ? u : u - share.first) / p, 1 - 0x1p-53)};
}

/// Draws from the cluster by shares(node) of its children, each step as step(shares, u) has it.
template <class Shares, class StepBy>
DrawnLight descended(const LightTree& tree, std::uint32_t node, double u, const Shares& shares,
                     const StepBy& step) {
  double p = 1;
  while (!tree.node(node).is_leaf()) {
    const ChildShares share = shares(node);
    if (share.first == 0 && share.second == 0) return {};
    const Step next = step(share, u);
    u = next.number;
    p *= next.probability;
    node = tree.node(node).first_child + (next.to_first ? 0 : 1);
  }
  return {tree.node(node).representative, p};
}

/// Draws by importance, each step by another rule.
template <Step step(const ChildShares&, double u)>
class OtherSteps : public CopiedPerThread<OtherSteps<step>, OtherDraws> {
public:
  using CopiedPerThread<OtherSteps<step>, OtherDraws>::CopiedPerThread;
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    const auto shares = [&](std::uint32_t i) {
      return HierarchicalImportance::shares(this->tree(), i, point);
    };
    return descended(this->tree(), node, u, shares, step);
  }
};

/// Goes on with u p where it should with u / p.
Step inverse_step(const ChildShares& share, double u) {
  const Step right = step_by(share, u);
  return {right.to_first, right.probability,
          (right.to_first ? u : u - share.first) * right.probability};
}

/// Goes to the first child for u up to its share, and at u = 0 to one that has none, as if it had
/// the least.
Step border_is_first_step(const ChildShares& share, double u) {
  if (u != share.first) return step_by(share, u);
  const double p = std::max(share.first, min_share);
  return {true, p, std::min(u / p, 1 - 0x1p-53)};
}

/// Has used up its random number after six steps.
class SixTurns : public CopiedPerThread<SixTurns, OtherDraws> {
public:
  using CopiedPerThread<SixTurns, OtherDraws>::CopiedPerThread;
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    const auto shares = [&](std::uint32_t i) {
      return HierarchicalImportance::shares(this->tree(), i, point);
    };
    int turns = 0;
    return descended(this->tree(), node, u, shares, [&](const ChildShares& share, double number) {
      return step_by(share, turns++ < 6 ? number : 0.5);
    });
  }
};

/// Draws by other shares of the children.
template <ChildShares shares(const LightTree&, std::uint32_t node, const ShadingPoint&)>
class OtherShares : public CopiedPerThread<OtherShares<shares>, OtherDraws> {
public:
  using CopiedPerThread<OtherShares<shares>, OtherDraws>::CopiedPerThread;
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    const auto of = [&](std::uint32_t i) { return shares(this->tree(), i, point); };
    return descended(this->tree(), node, u, of, step_by);
  }
  std::vector<double> probabilities(std::uint32_t node, const ShadingPoint& point,
                                    std::span<const std::uint32_t> lights) override {
    std::vector<double> known(this->tree().lights().size(), 0);
    visit(node, point, 1, known);
    std::vector<double> result;
    for (const std::uint32_t light : lights) result.push_back(known[light]);
    return result;
  }

private:
  void visit(std::uint32_t node, const ShadingPoint& point, double p, std::vector<double>& known) {
    const TreeNode& n = this->tree().node(node);
    if (n.is_leaf()) {
      known[n.representative] = p;
      return;
    }
    const ChildShares share = shares(this->tree(), node, point);
    visit(n.first_child, point, p * share.first, known);
    visit(n.first_child + 1, point, p * share.second, known);
  }
};

/// Weighs a child by the light at its box's centre: 0 if that lies below the horizon.
ChildShares shares_by_centre(const LightTree& tree, std::uint32_t node, const ShadingPoint& point) {
  const auto weight = [&](std::uint32_t i) {
    const TreeNode& n = tree.node(i);
    const glm::vec3 centre = glm::vec3(0.5 * (glm::dvec3(n.box.lo) + glm::dvec3(n.box.hi)));
    const glm::vec3 from = viewed_from(n.kind(), point.position());
    const double facing = dot_between(point.normal(), from, centre);
    return facing > 0 ? n.intensity.x + n.intensity.y + n.intensity.z : 0.0;
  };
  const std::uint32_t child = tree.node(node).first_child;
  return shares_of(weight(child), weight(child + 1));
}

/// Divides by the probability by intensity, but draws by importance.
class PdfMismatch : public CopiedPerThread<PdfMismatch, OtherDraws> {
public:
  using CopiedPerThread<PdfMismatch, OtherDraws>::CopiedPerThread;
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    DrawnLight drawn = OtherDraws::sample(node, point, u);
    if (drawn.probability > 0)
      drawn.probability =
          light_probability(IntensityImportance(), tree(), node, drawn.light, point);
    return drawn;
  }
};

/// Rounds the random number to a float, which may be 1.
class NumberInFloat : public CopiedPerThread<NumberInFloat, OtherDraws> {
public:
  using CopiedPerThread<NumberInFloat, OtherDraws>::CopiedPerThread;
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    const auto rounded = double(float(u));
    return rounded < 1 ? OtherDraws::sample(node, point, rounded) : DrawnLight{};
  }
};

constexpr Mutant sampling_catalogue[] = {
    {"random-number-lost", "draws by other numbers than the one it is given",
     with_tree<RandomNumberLost>},
    {"one-number-for-all", "draws from all clusters of a cut by one random number",
     with_tree<OneNumberForAll>},
    {"queries-in-pairs", "draws by the same numbers for two successive queries",
     with_tree<QueriesInPairs>},
    {"six-turns", "has no random number left after six steps down the tree", with_tree<SixTurns>},
    {"draws-go-on", "draws by what numbers come next, and not by those that the query decides",
     with_tree<DrawsGoOn>},
    {"resampled-between", "divides the light of one draw by the probability of another",
     with_tree<ResampledBetween>},
    {"dead-branch", "never draws from a child whose centre lies below the horizon",
     with_tree<OtherShares<shares_by_centre>>},
    {"inverse-probability", "goes on down the tree with u p in place of u / p",
     with_tree<OtherSteps<inverse_step>>},
    {"pdf-mismatch", "states the probability by intensity of what it draws by importance",
     with_tree<PdfMismatch>},
    {"random-number-in-float", "rounds the random number to a float, and draws nothing by 1",
     with_tree<NumberInFloat>},
    {"border-is-first", "goes to the first child for u up to its share, though that may be 0",
     with_tree<OtherSteps<border_is_first_step>>},
};

} // namespace

std::span<const Mutant> sampling_mutants() { return sampling_catalogue; }

} // namespace lightcuts::oracle
