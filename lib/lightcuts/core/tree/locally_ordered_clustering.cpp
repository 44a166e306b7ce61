// SPDX-License-Identifier: MIT
#include <lightcuts/core/tree/locally_ordered_clustering.h>

#include <algorithm>
#include <limits>
#include <utility>

#include <lightcuts/core/tree/morton_order.h>

namespace lightcuts {
namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

/// The clusters in their order, as a list from which merged ones go out. A round asks only those
/// whose surroundings have changed: a merge changes those of 2 search_radius others and more at
/// most, so all rounds together take a time proportional to the number of clusters, even where
/// each merges one pair only.
class Surroundings {
public:
  Surroundings(std::vector<Cluster> clusters, Dendrogram& record)
      : clusters_(std::move(clusters)), record_(record), links_(clusters_.size()),
        choice_(clusters_.size()), is_asked_(clusters_.size(), 1) {
    const auto n = static_cast<std::uint32_t>(clusters_.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      links_[i] = {i == 0 ? nobody : i - 1, i + 1 == n ? nobody : i + 1};
      asked_.push_back(i);
    }
  }

  Cluster merged_to_one() {
    for (std::size_t left = clusters_.size(); left > 1;) {
      record_.leave_if_cancelled();
      for (const std::uint32_t place : asked_) choice_[place] = cheapest_partner(place);
      const std::vector<Pair> pairs = mutual_choices();
      for (const std::uint32_t place : asked_) is_asked_[place] = 0;
      asked_.clear();
      for (const Pair& pair : pairs) {
        ask_around(pair.first);
        ask_around(pair.second);
      }
      for (const Pair& pair : pairs) merge(pair);
      std::erase_if(asked_, [&](std::uint32_t place) { return choice_[place] == nobody; });
      left -= pairs.size();
    }
    return clusters_.front(); // the first place is never the higher one of a pair
  }

private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>; ///< places, the lower first
  struct Links {
    std::uint32_t before, after;
  };

  /// Calls f with the places at most search_radius away.
  template <class F>
  void around(std::uint32_t place, F&& f) const {
    std::uint32_t other = place;
    for (std::uint32_t i = 0; i < search_radius && links_[other].before != nobody; ++i)
      f(other = links_[other].before);
    other = place;
    for (std::uint32_t i = 0; i < search_radius && links_[other].after != nobody; ++i)
      f(other = links_[other].after);
  }

  [[nodiscard]] std::uint32_t cheapest_partner(std::uint32_t place) const {
    using Rank = std::pair<double, std::uint32_t>;
    Rank best{std::numeric_limits<double>::infinity(), nobody};
    std::uint32_t partner = nobody;
    around(place, [&](std::uint32_t other) {
      const Rank rank{union_cost(clusters_[place], clusters_[other]), place ^ other};
      if (rank < best) {
        best = rank;
        partner = other;
      }
    });
    return partner;
  }

  [[nodiscard]] std::vector<Pair> mutual_choices() const {
    std::vector<Pair> pairs;
    for (const std::uint32_t place : asked_) {
      const std::uint32_t other = choice_[place];
      // Of two that are asked, one tells.
      if (choice_[other] == place && (place < other || is_asked_[other] == 0))
        pairs.push_back(std::minmax(place, other));
    }
    return pairs;
  }

  void ask(std::uint32_t place) {
    if (is_asked_[place] != 0) return;
    is_asked_[place] = 1;
    asked_.push_back(place);
  }

  void ask_around(std::uint32_t place) {
    ask(place);
    around(place, [this](std::uint32_t other) { ask(other); });
  }

  void merge(const Pair& pair) {
    const auto [kept, freed] = pair;
    clusters_[kept] = record_.join(clusters_[kept], clusters_[freed]);
    choice_[freed] = nobody;
    const auto [before, after] = links_[freed];
    links_[before].after = after; // the kept place is before it, so there is one
    if (after != nobody) links_[after].before = before;
  }

  std::vector<Cluster> clusters_; ///< by place on the curve; a union has the lower place
  Dendrogram& record_;
  std::vector<Links> links_;
  std::vector<std::uint32_t> choice_; ///< nobody: merged away
  std::vector<std::uint32_t> asked_;
  std::vector<char> is_asked_;
};

} // namespace

Cluster cluster_in_local_order(std::vector<Cluster> clusters, Dendrogram& record) {
  sort_by_morton_order(clusters);
  return Surroundings(std::move(clusters), record).merged_to_one();
}

} // namespace lightcuts
