// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

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

void check_frequencies(const Draws& of, const Recorder& record) {
  for (const RandomCluster& cluster : of.clusters()) {
    if (cluster.lights.size() < 2) continue;
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
}

} // namespace

const PropertyInfo property::draws_follow_probabilities{
    .name = "draws-follow-probabilities",
    .statement = "Lights are drawn as often as their probabilities say.",
    .formula = "|count / n - probability| <= Bernstein's deviation, for each light",
    .needs = only(Part::sampling),
    .of_draws = check_frequencies,
};

} // namespace lightcuts::oracle
