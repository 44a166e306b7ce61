// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <oracle/cases/random_pixels.h>
#include <oracle/properties/sampling/draws.h>

namespace lightcuts::oracle {
namespace {

/// How often each of the cluster's lights is drawn.
std::vector<std::uint64_t> counts_of(const Draws& of, const RandomCluster& cluster) {
  const std::uint64_t seed = hashed(of.seed(), cluster.node);
  std::vector<std::uint64_t> counts(cluster.lights.size(), 0);
  std::vector<double> random;
  std::vector<DrawnLight> drawn;
  for (std::uint64_t done = 0; done < of.count(); done += random.size()) {
    random.resize(std::min<std::uint64_t>(of.count() - done, 4096));
    for (std::size_t i = 0; i < random.size(); ++i)
      random[i] = double(hashed(seed, done + i) >> 11) * 0x1p-53;
    drawn.resize(random.size());
    of.point.judged.tree.samples(cluster.node, of.point.at.point, random, drawn);
    for (const DrawnLight& one : drawn) {
      if (one.probability == 0) continue;
      const auto found = std::find(cluster.lights.begin(), cluster.lights.end(), one.light);
      if (found != cluster.lights.end()) ++counts[std::size_t(found - cluster.lights.begin())];
    }
  }
  return counts;
}

void check_cluster(const Draws& of, const RandomCluster& cluster, const Recorder& record) {
  if (cluster.lights.size() < 2) return;
  const std::vector<std::uint64_t> counts = counts_of(of, cluster);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double p = cluster.p[i];
    const double allowed =
        bernstein_deviation({p * (1 - p), std::max(p, 1 - p)}, of.count(), of.rate());
    const double off = std::abs(double(counts[i]) / double(of.count()) - p);
    record(off <= allowed, ratio_of(off, allowed), [&] {
      return fmt::format("{}: light {} of node {} has probability {:.6g} and was drawn {} times "
                         "of {}",
                         of.point.at.text(), cluster.lights[i], cluster.node, p, counts[i],
                         of.count());
    });
  }
}

void check_frequencies(const Draws& of, const Recorder& record) {
  for (const RandomCluster& cluster : of.clusters()) check_cluster(of, cluster, record);
  if (of.whole()) check_cluster(of, *of.whole(), record);
}

// ---- trees of many lights, group by group

// Shared by all such trees of a run; see draw_config in judge.cpp.
constexpr double group_false_alarms = 1e-7;
constexpr std::uint64_t most_trees = 100'000;
constexpr std::size_t least_lights = 41; // fewer: light by light
constexpr std::size_t group_draws = 16'384;

/// Lights that have something in common, and how often one of them is drawn.
struct Group {
  std::string what;
  double probability = 0;
  std::uint64_t drawn = 0;
};

/// Every light is in several groups: by where in the tree it is, by its index, and by which of its
/// siblings it is, so that a turn that is wrong far down shows, too, however rare each light is.
class Groups {
public:
  explicit Groups(const ClusterOdds& of) : groups_of_(of.point.at.lights().size()) {
    const Topology& topology = of.point.topology();
    const std::size_t count = of.lights.size();
    std::vector<std::uint32_t> rank(groups_of_.size(), 0);
    for (std::uint32_t node = 0; node < topology.size(); ++node) {
      const auto own = topology.lights(node);
      for (std::uint32_t i = 0; own.size() > 1 && i < own.size(); ++i) rank[own[i]] = i;
      const auto children = topology.children(node);
      for (std::uint32_t k = 0; k < children.size(); ++k)
        for (const std::uint32_t light : topology.lights(children[k]))
          if (topology.lights(children[k]).size() == 1) rank[light] = k;
    }
    for (std::uint32_t part = 0; part < parts; ++part)
      groups_.push_back({fmt::format("the {}. sixteenth of the tree", part + 1)});
    for (std::uint32_t rest = 0; rest < rests; ++rest)
      groups_.push_back({fmt::format("lights whose index is {} modulo {}", rest, rests)});
    for (std::uint32_t k = 0; k < ranks; ++k)
      groups_.push_back({fmt::format("lights that are child {} of their parents", k)});
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t light = of.lights[i];
      groups_of_[light] = {std::uint32_t(i * parts / count), parts + light % rests,
                           parts + rests + std::min(rank[light], std::uint32_t(ranks - 1))};
      for (const std::uint32_t group : groups_of_[light]) groups_[group].probability += of.p[i];
    }
  }

  void count(std::uint32_t light) {
    if (light >= groups_of_.size()) return; // convicted elsewhere
    for (const std::uint32_t group : groups_of_[light]) ++groups_[group].drawn;
  }
  [[nodiscard]] const std::vector<Group>& all() const { return groups_; }

private:
  static constexpr std::uint32_t parts = 16, rests = 8, ranks = 4;

  std::vector<Group> groups_;
  std::vector<std::array<std::uint32_t, 3>> groups_of_; ///< by light
};

void check_groups(const ClusterOdds& of, const Recorder& record) {
  if (of.node != 0 || of.lights.size() < least_lights) return;
  Groups groups(of);
  std::vector<double> random(4096);
  std::vector<DrawnLight> drawn(random.size());
  for (std::uint64_t done = 0; done < group_draws; done += random.size()) {
    for (std::size_t i = 0; i < random.size(); ++i)
      random[i] = double(hashed(group_draws, done + i) >> 11) * 0x1p-53;
    of.point.judged.tree.samples(of.node, of.point.at.point, random, drawn);
    for (const DrawnLight& one : drawn)
      if (one.probability > 0) groups.count(one.light);
  }
  const double rate = sidak(sidak(group_false_alarms, most_trees), groups.all().size());
  for (const Group& group : groups.all()) {
    const double p = std::clamp(group.probability, 0.0, 1.0);
    const double allowed =
        bernstein_deviation({p * (1 - p), std::max(p, 1 - p)}, group_draws, rate) + 0x1p-40;
    const double off = std::abs(double(group.drawn) / double(group_draws) - p);
    record(off <= allowed, ratio_of(off, allowed), [&] {
      return fmt::format("{}: {}, {} in all, have probability {:.6g} together, and of {} draws {} "
                         "were of them",
                         of.point.at.text(), group.what, of.lights.size(), p, group_draws,
                         group.drawn);
    });
  }
}

} // namespace

const PropertyInfo property::draws_follow_probabilities{
    .name = "draws-follow-probabilities",
    .statement = "Lights are drawn as often as their probabilities say.",
    .formula = "|count / n - probability| <= Bernstein's deviation, for each light, of many lights "
               "for groups of them",
    .needs = only(Part::sampling),
    .of_odds = check_groups,
    .of_draws = check_frequencies,
};

} // namespace lightcuts::oracle
