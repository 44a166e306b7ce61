// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <oracle/properties/sampling/cluster_odds.h>
#include <oracle/properties/sampling/statistics.h>

namespace lightcuts::oracle {

/// How many draws there are.
struct DrawConfig {
  double false_alarms = 1e-6; ///< chance of any, in all cases of a run taken together
  std::uint64_t cases = 1;    ///< that share false_alarms, each test having its Sidak share
  std::uint64_t max_draws = 4'000'000;
  std::uint64_t seed = 1;
};

/// A cluster of a random cut: which of its lights may light it.
struct RandomCluster : ClusterOdds {
  Wide mean{};                  ///< of the estimate, occlusion included, per channel
  std::array<Spread, 3> spread; ///< of the estimate

  RandomCluster(const PointAnswers& answers, std::uint32_t node);
};

/// What is gathered of random cuts.
struct DrawSums {
  std::array<long double, 3> radiance{};
  std::vector<long double>
      products;               ///< of two clusters' deviations, in the order of Draws::pairs()
  long double successive = 0; ///< of the radiances' deviations in each two successive queries
  bool same_cut = true;
};

/// Random cuts at a point, by queries of which each second one follows the one before, drawn when
/// first asked for: so many that a bias of 1 % of the mean in
/// any channel, and a light that is drawn with a probability 0.05 off, each go unnoticed with a
/// probability of at most 0.001. Independence is tested with the same draws and states no power.
/// Of a subject that makes no random cuts, lights are drawn from the root and its children.
class Draws {
public:
  const PointAnswers& point;
  const CutConfig& cut;

  Draws(const PointAnswers& answers, const CutConfig& asked, const DrawConfig& config);

  /// How many draws there are; none where that takes more than max_draws, or nothing is to be seen.
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double rate() const { return rate_; } ///< of false alarms, for one test
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] const std::vector<RandomCluster>& clusters() const { return clusters_; }
  /// The root, where it is none of clusters(): the way down to a light is longest from there.
  [[nodiscard]] const std::optional<RandomCluster>& whole() const { return whole_; }
  /// Indices of those of clusters() that are looked at two by two: each two of few, else
  /// neighbours.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& pairs() const {
    return pairs_;
  }
  /// The channel in which most is to be seen.
  [[nodiscard]] std::size_t brightest_channel() const { return channel_; }
  /// How the radiance of a random cut is spread.
  [[nodiscard]] const Spread& spread(std::size_t channel) const { return spread_[channel]; }
  [[nodiscard]] const DrawSums& sums() const;

private:
  void of_random_cuts(const DrawConfig& config);
  void of_single_draws(const DrawConfig& config);
  [[nodiscard]] std::optional<std::uint64_t> needed(std::uint64_t most, bool unbiased) const;
  [[nodiscard]] DrawSums drawn() const;
  void pair_up();
  void add(const Cut& one, DrawSums& sums) const;

  std::uint64_t seed_, count_ = 0;
  double rate_ = 0;
  std::vector<RandomCluster> clusters_;
  std::optional<RandomCluster> whole_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  std::size_t channel_ = 0;
  std::array<Spread, 3> spread_;
  mutable std::optional<DrawSums> sums_;
};

} // namespace lightcuts::oracle
