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
  std::uint64_t tests = 3 + first.clusters.size() - 1;
  for (const CutCluster& c : first.clusters) {
    if (c.node >= point.topology().size()) return; // convicted elsewhere
    tests += clusters_.emplace_back(point, c.node).lights.size();
  }
  const Wide& truth = point.at.truth.seen(0);
  channel_ = std::size_t(std::max_element(truth.begin(), truth.end()) - truth.begin());
  if (!(double(truth[channel_]) > least_seen) || clusters_.empty()) return;
  rate_ = sidak(sidak(config.false_alarms, config.cases), tests);
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
  for (std::size_t k = 0; sums.same_cut && k + 1 < clusters_.size(); ++k) {
    const auto off = [&](std::size_t j) {
      return one.clusters[j].estimate[int(channel_)] - clusters_[j].mean[channel_];
    };
    sums.products[k] += off(k) * off(k + 1);
  }
}

DrawSums Draws::drawn() const {
  const auto visible = [&](std::uint32_t light) { return point.at.sees(light); };
  DrawSums sums;
  sums.products.resize(clusters_.size() - 1, 0);
  std::vector<std::uint64_t> queries;
  for (std::uint64_t done = 0; done < count_ && sums.same_cut; done += queries.size()) {
    queries.resize(std::min<std::uint64_t>(count_ - done, 256));
    for (std::size_t i = 0; i < queries.size(); ++i) queries[i] = hashed(seed_, done + i);
    point.judged.tree.draws(point.at.point, cut, queries, visible, [&](const Cut& one) {
      if (sums.same_cut) add(one, sums);
    });
  }
  return sums;
}

const DrawSums& Draws::sums() const {
  if (!sums_) sums_ = drawn();
  return *sums_;
}

} // namespace lightcuts::oracle
