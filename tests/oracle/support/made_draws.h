// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <oracle/cases/random_case.h>
#include <oracle/properties/sampling/statistics.h>
#include <tests/oracle/support/judged_point.h>

namespace lightcuts::oracle {

inline constexpr Parts sampled_parts =
    library_parts | only(Part::sampling) | only(Part::random_cuts);
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
using OwnTree = LibraryTree;
using Visible = std::function<bool(std::uint32_t)>;
using Clusters = std::vector<CutCluster>;

inline OwnTree own(const JudgedPoint& judged) { return OwnTree(judged.tree); }

/// What is not as the library has it.
struct Changes {
  std::function<double(double u)> number;                     ///< that sample() draws by
  std::function<void(std::uint32_t node, DrawnLight&)> drawn; ///< by sample()
  std::function<double(std::uint32_t node, std::uint32_t light, double p)> probability;
  std::function<void(Clusters&, std::uint64_t query)> clusters; ///< of draw()
};

class MadeDraws : public OwnTree {
public:
  MadeDraws(const LightTree& tree, Changes changes) : OwnTree(tree), changes_(std::move(changes)) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<MadeDraws>(*this);
  }
  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    DrawnLight drawn = OwnTree::sample(node, point, changes_.number ? changes_.number(u) : u);
    if (changes_.drawn) changes_.drawn(node, drawn);
    return drawn;
  }
  std::vector<double> probabilities(std::uint32_t node, const ShadingPoint& point,
                                    std::span<const std::uint32_t> lights) override {
    std::vector<double> p = OwnTree::probabilities(node, point, lights);
    for (std::size_t i = 0; changes_.probability && i < p.size(); ++i)
      p[i] = changes_.probability(node, lights[i], p[i]);
    return p;
  }
  Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
           const Visible& visible) override {
    ++draws_;
    Cut cut = OwnTree::draw(point, config, query, visible);
    if (!changes_.clusters) return cut;
    clusters_.assign(cut.clusters.begin(), cut.clusters.end());
    changes_.clusters(clusters_, query);
    glm::dvec3 total(0);
    for (const CutCluster& c : clusters_) total += c.estimate;
    cut.radiance = glm::vec3(total);
    cut.clusters = clusters_;
    return cut;
  }
  /// Calls of draw().
  [[nodiscard]] std::uint64_t draws() const { return draws_; }

private:
  Changes changes_;
  Clusters clusters_;
  std::uint64_t draws_ = 0;
};

inline Tally probabilities_of(SubjectTree&& tree, const JudgedPoint& judged) {
  return judged_at(
      tree, judged, [](const Judge& judge, const PointAnswers& of) { judge.odds(of); },
      sampled_parts);
}

inline Tally draws_of(SubjectTree& tree, const JudgedPoint& judged, const CutConfig& cut,
                      const DrawConfig& config = {}) {
  return judged_at(
      tree, judged,
      [&](const Judge& judge, const PointAnswers& of) { judge.draws(of, cut, config); },
      sampled_parts);
}
inline Tally draws_of(SubjectTree&& tree, const JudgedPoint& judged, const CutConfig& cut,
                      const DrawConfig& config = {}) {
  return draws_of(tree, judged, cut, config);
}

inline constexpr std::array random_properties{Property::draws_follow_probabilities,
                                              Property::draws_are_independent,
                                              Property::stochastic_is_unbiased};

/// Cases of what takes many draws.
inline std::uint64_t random_cases(const Tally& tally) {
  std::uint64_t sum = 0;
  for (const Property p : random_properties) sum += tally[p].cases;
  return sum;
}

/// Cuts of one, two, three clusters.
inline CutConfig cut_of(std::uint32_t size) { return {0, size, 0}; }

/// Four lights of colours that importance does not know, so that estimates spread; mostly blue.
inline LightTree coloured_lights() {
  LightSet lights;
  lights.add_omni({0.2F, 0.1F, 0.9F}, {1.2F, 1, 2});
  lights.add_omni({1, 0.4F, 1.3F}, {0.7F, 1, 3.4F});
  lights.add_omni({-1.6F, 1, 1.1F}, {2, 1, 1.8F});
  lights.add_omni({-1.9F, -0.5F, 1.7F}, {1, 1, 4.5F});
  return build(lights);
}

/// Those as two clusters of two, or otherwise.
struct FourLights : testing::Test {
  const JudgedPoint judged{coloured_lights(), diffuse_point(), {1, 1, 1, 1}};

  [[nodiscard]] MadeDraws with(Changes changes) const { return {judged.tree, std::move(changes)}; }
  [[nodiscard]] MadeDraws
  with_clusters(std::function<void(Clusters&, std::uint64_t)> clusters) const {
    return with({.clusters = std::move(clusters)});
  }
  [[nodiscard]] MadeDraws scaled(double by) const {
    return with_clusters([by](Clusters& all, std::uint64_t) {
      for (CutCluster& c : all) c.estimate *= by;
    });
  }
  /// Light by the random number u.
  [[nodiscard]] glm::dvec3 lit(std::uint32_t node, double u) const {
    const DrawnLight drawn = own(judged).sample(node, judged.point, u);
    const Wide f = contribution(judged.tree.lights()[drawn.light], judged.point, 0);
    return glm::dvec3(f[0], f[1], f[2]) / drawn.probability;
  }
  [[nodiscard]] glm::dvec3 mean(std::uint32_t node) const {
    const Wide& f = judged.truth.seen(node);
    return {f[0], f[1], f[2]};
  }
  /// Of the estimate of a cluster; blue is the brightest channel.
  [[nodiscard]] Spread spread(std::uint32_t node, int channel = 2) const {
    const std::span<const std::uint32_t> lights = judged.topology.all_lights(node);
    Spread s;
    for (const std::uint32_t light : lights) {
      const double p = own(judged).probability(node, judged.point, light);
      const Wide all = contribution(judged.tree.lights()[light], judged.point, 0);
      const auto f = double(all[std::size_t(channel)]);
      s.variance += p * std::pow(f / p - mean(node)[channel], 2);
      s.range = std::max(s.range, std::abs(f / p - mean(node)[channel]));
    }
    return s;
  }
  [[nodiscard]] std::vector<std::uint32_t> nodes(const CutConfig& cut) const {
    OwnTree tree = own(judged);
    std::vector<std::uint32_t> list;
    for (const CutCluster& c : tree.draw(judged.point, cut, 0, [](auto) { return true; }).clusters)
      list.push_back(c.node);
    return list;
  }
  /// What the documentation of DrawConfig says that each test has and how many draws there are.
  [[nodiscard]] double rate(std::size_t clusters, const DrawConfig& config) const {
    // The mean's channels, successive queries, each light of the clusters and of the root, pairs.
    const std::size_t of_root = clusters > 1 ? 4 : 0;
    return sidak(sidak(config.false_alarms, config.cases),
                 3 + 1 + 4 + of_root + clusters * (clusters - 1) / 2);
  }
  [[nodiscard]] std::uint64_t draws(const CutConfig& cut, const DrawConfig& config) const {
    std::uint64_t most = 0;
    const auto take = [&](double deviation, const Spread& of) {
      most = std::max(most, draws_to_notice(deviation, of, rate(nodes(cut).size(), config), 0.001,
                                            config.max_draws)
                                .value());
    };
    for (int c = 0; c < 3; ++c) {
      Spread sum;
      for (const std::uint32_t node : nodes(cut)) {
        sum.variance += spread(node, c).variance;
        sum.range += spread(node, c).range;
      }
      take(0.01 * mean(0)[c], sum);
    }
    take(0.05, {0.25, 1});
    return most;
  }
};

/// A random case that is judged by draws.
struct Lottery {
  Case on;
  JudgedPoint judged;

  explicit Lottery(std::uint64_t index)
      : on(random_case(1, 500 * index + 499)),
        judged(build(on.light_set(), {on.seed}), on.views[0].view.point(), visible(on)) {}
  static std::vector<char> visible(const Case& of) {
    std::vector<char> list(of.lights.size(), 1);
    for (const std::uint32_t hidden : of.views[0].hidden) list[hidden] = 0;
    return list;
  }
};

} // namespace lightcuts::oracle
