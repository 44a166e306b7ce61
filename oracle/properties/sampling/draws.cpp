// SPDX-License-Identifier: MIT
#include <oracle/properties/sampling/draws.h>

#include <algorithm>
#include <cmath>

#include <oracle/cases/random_pixels.h>

namespace lightcuts::oracle {
namespace {

constexpr double noticed_bias = 0.01, noticed_probability = 0.05, overlooked = 0.001;
constexpr double least_seen = 0x1p-100; // radiance

} // namespace

RandomCluster::RandomCluster(const PointAnswers& answers, std::uint32_t cluster)
    : ClusterOdds(answers, cluster) {
  const double left = none();
  for (std::size_t c = 0; c < 3; ++c) {
    const auto seen = [&](std::size_t i) { return point.at.sees(lights[i]) ? light[i][c] : 0.0L; };
    for (std::size_t i = 0; i < p.size(); ++i) mean[c] += seen(i);
    const auto add = [&](double probability, double estimate) {
      const double off = estimate - double(mean[c]);
      spread[c].variance += probability * off * off;
      spread[c].range = std::max(spread[c].range, std::abs(off));
    };
    for (std::size_t i = 0; i < p.size(); ++i)
      if (p[i] > 0) add(p[i], double(seen(i)) / p[i]);
    if (left > 1e-9) add(left, 0);
  }
}

Draws::Draws(const PointAnswers& answers, const CutConfig& asked, const DrawConfig& config)
    : point(answers), cut(asked), seed_(config.seed) {
  if (point.judged.has(Part::random_cuts))
    of_random_cuts(config);
  else
    of_single_draws(config);
}

void Draws::of_random_cuts(const DrawConfig& config) {
  const Cut first = point.judged.tree.draw(
      point.at.point, cut, 0, [&](std::uint32_t light) { return point.at.sees(light); });
  std::uint64_t tests = 4;
  for (const CutCluster& c : first.clusters) {
    if (c.node >= point.topology().size()) return; // convicted elsewhere
    tests += clusters_.emplace_back(point, c.node).lights.size();
  }
  const Wide& truth = point.at.truth.seen(0);
  channel_ = std::size_t(std::max_element(truth.begin(), truth.end()) - truth.begin());
  if (!(double(truth[channel_]) > least_seen) || clusters_.empty()) return;
  if (clusters_.size() > 1) tests += whole_.emplace(point, 0).lights.size();
  pair_up();
  rate_ = sidak(sidak(config.false_alarms, config.cases), tests + pairs_.size());
  for (std::size_t c = 0; c < 3; ++c)
    for (const RandomCluster& l : clusters_) {
      spread_[c].variance += l.spread[c].variance;
      spread_[c].range += l.spread[c].range;
    }
  count_ = needed(config.max_draws, true).value_or(0);
}

void Draws::of_single_draws(const DrawConfig& config) {
  std::uint64_t tests = clusters_.emplace_back(point, 0).lights.size();
  for (const std::uint32_t child : point.topology().children(0))
    tests += clusters_.emplace_back(point, child).lights.size();
  rate_ = sidak(sidak(config.false_alarms, config.cases), tests);
  count_ = needed(config.max_draws, false).value_or(0);
}

void Draws::pair_up() {
  constexpr std::size_t few = 8;
  for (std::size_t k = 0; k < clusters_.size(); ++k)
    for (std::size_t j = k + 1; j < clusters_.size() && (clusters_.size() <= few || j == k + 1);
         ++j)
      pairs_.emplace_back(k, j);
}

/// So many that all is noticed that is to be, a bias if `unbiased`; nothing if that is too many.
std::optional<std::uint64_t> Draws::needed(std::uint64_t most, bool unbiased) const {
  std::optional<std::uint64_t> draws = 1;
  const auto notice = [&](double deviation, const Spread& spread) {
    const auto enough = draws_to_notice(deviation, spread, rate_, overlooked, most);
    draws = draws && enough ? std::optional(std::max(*draws, *enough)) : std::nullopt;
  };
  for (std::size_t c = 0; unbiased && c < 3; ++c)
    if (const auto truth = double(point.at.truth.seen(0)[c]); truth > least_seen)
      notice(noticed_bias * truth, spread_[c]);
  if (std::any_of(clusters_.begin(), clusters_.end(),
                  [](const RandomCluster& l) { return l.p.size() > 1; }))
    notice(noticed_probability, {0.25, 1});
  return draws;
}

void Draws::add(const Cut& one, DrawSums& sums) const {
  for (std::size_t c = 0; c < 3; ++c) sums.radiance[c] += one.radiance[int(c)];
  sums.same_cut =
      std::equal(one.clusters.begin(), one.clusters.end(), clusters_.begin(), clusters_.end(),
                 [](const CutCluster& a, const RandomCluster& b) { return a.node == b.node; });
  if (!sums.same_cut) return;
  const auto off = [&](std::size_t j) {
    return one.clusters[j].estimate[int(channel_)] - clusters_[j].mean[channel_];
  };
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    sums.products[i] += off(pairs_[i].first) * off(pairs_[i].second);
}

DrawSums Draws::drawn() const {
  const auto visible = [&](std::uint32_t light) { return point.at.sees(light); };
  DrawSums sums;
  sums.products.resize(pairs_.size(), 0);
  const long double mean = point.at.truth.seen(0)[channel_];
  long double before = 0; // the deviation of the query before
  std::vector<std::uint64_t> queries;
  for (std::uint64_t done = 0; done < count_ && sums.same_cut; done += queries.size()) {
    queries.resize(std::min<std::uint64_t>(count_ - done, 256));
    for (std::size_t i = 0; i < queries.size(); ++i)
      queries[i] = i % 2 == 0 ? hashed(seed_, done + i) : queries[i - 1] + 1;
    std::size_t i = 0;
    point.judged.tree.draws(point.at.point, cut, queries, visible, [&](const Cut& one) {
      if (!sums.same_cut) return;
      add(one, sums);
      const long double off = one.radiance[int(channel_)] - mean;
      if (i++ % 2 == 1) sums.successive += before * off;
      before = off;
    });
  }
  return sums;
}

const DrawSums& Draws::sums() const {
  if (!sums_) sums_ = drawn();
  return *sums_;
}

} // namespace lightcuts::oracle
