// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <oracle/cases/random_pixels.h>
#include <oracle/properties/case_properties.h>
#include <oracle/properties/statistics.h>

namespace lightcuts::oracle {
namespace {

constexpr double noticed_bias = 0.01, noticed_probability = 0.05, overlooked = 0.001;

std::string at_point(const PointCase& at) {
  const glm::vec3& x = at.point.position();
  return fmt::format("point ({:.9g}, {:.9g}, {:.9g})", x.x, x.y, x.z);
}

double uniform(std::uint64_t seed, std::uint64_t index) {
  return double(hashed(seed, index) >> 11) * 0x1p-53;
}

bool is_dark(const Wide& w) { return w[0] == 0 && w[1] == 0 && w[2] == 0; }

Wide contribution_of(const PointCase& at, std::uint32_t light) {
  return contribution(at.lights()[light], at.point, at.lights().min_distance());
}

// ---- without many draws

void check_sum(const PointCase& at, std::uint32_t node, std::span<const double> p, bool all_shine,
               Tally& tally) {
  long double sum = 0;
  bool finite = true;
  for (const double one : p) {
    sum += one;
    finite = finite && one >= 0 && one <= 1;
  }
  tally.record(Property::results_are_finite, finite, at.place, no_ratio, [&] {
    return fmt::format("{}: a probability in node {} is not in [0, 1]", at_point(at), node);
  });
  // Each level multiplies numbers that round by 2^-52 at most.
  const long double rounding = 0x1p-50L * static_cast<long double>(p.size());
  const long double off = all_shine ? std::abs(sum - 1) : std::max(sum - 1, 0.0L);
  tally.record(Property::probabilities_sum_to_one, off <= rounding, at.place,
               ratio_of(off, rounding), [&] {
                 return fmt::format("{}: the probabilities in node {} sum to {}", at_point(at),
                                    node, double(sum));
               });
}

void check_drawn(const PointCase& at, std::uint32_t node, double u, const DrawnLight& drawn,
                 std::span<const std::uint32_t> lights, std::span<const double> p, Tally& tally) {
  if (drawn.probability == 0) {
    // That is what is left of 1.
    double none = 1;
    for (const double one : p) none -= one;
    tally.record(Property::draws_state_their_probability, none > 0x1p-40, at.place, no_ratio, [&] {
      return fmt::format("{}: u = {} draws nothing of node {}, though its probabilities sum to 1",
                         at_point(at), u, node);
    });
    return;
  }
  const auto found = std::find(lights.begin(), lights.end(), drawn.light);
  const double stated = found == lights.end() ? 0 : p[std::size_t(found - lights.begin())];
  tally.record(Property::draws_state_their_probability, stated == drawn.probability, at.place,
               no_ratio, [&] {
                 return fmt::format("{}: u = {} draws light {} of node {} with probability "
                                    "{:.17g}, which is {:.17g}",
                                    at_point(at), u, drawn.light, node, drawn.probability, stated);
               });
}

// ---- with many

/// One cluster of a cut: what may be drawn of it.
struct Lottery {
  std::uint32_t node;
  std::vector<std::uint32_t> lights;
  std::vector<double> p;
  std::vector<Wide> contributions; ///< occlusion included
  Wide mean{};                     ///< of the estimate, per channel
  std::array<Spread, 3> spread;    ///< of the estimate

  Lottery(const Judged& judged, const PointCase& at, std::uint32_t of)
      : node(of), lights(at.topology().all_lights(of)),
        p(judged.tree.probabilities(of, at.point, lights)) {
    for (const std::uint32_t light : lights)
      contributions.push_back(at.visible[light] != 0 ? contribution_of(at, light) : Wide{});
    double none = 1;
    for (const double one : p) none -= one;
    for (std::size_t c = 0; c < 3; ++c) {
      for (const Wide& f : contributions) mean[c] += f[c];
      const auto add = [&](double probability, double estimate) {
        const double off = estimate - double(mean[c]);
        spread[c].variance += probability * off * off;
        spread[c].range = std::max(spread[c].range, std::abs(off));
      };
      for (std::size_t i = 0; i < p.size(); ++i)
        if (p[i] > 0) add(p[i], double(contributions[i][c]) / p[i]);
      if (none > 1e-9) add(none, 0);
    }
  }
};

/// The channel in which most is to be seen.
std::size_t brightest(const Wide& w) {
  return std::size_t(std::max_element(w.begin(), w.end()) - w.begin());
}

void check_frequencies(const Judged& judged, const PointCase& at, const Lottery& lottery,
                       std::uint64_t draws, double rate, std::uint64_t seed, Tally& tally) {
  std::vector<std::uint64_t> counts(lottery.lights.size(), 0);
  std::vector<double> random;
  std::vector<DrawnLight> drawn;
  for (std::uint64_t done = 0; done < draws; done += random.size()) {
    random.resize(std::min<std::uint64_t>(draws - done, 4096));
    for (std::size_t i = 0; i < random.size(); ++i) random[i] = uniform(seed, done + i);
    drawn.resize(random.size());
    judged.tree.samples(lottery.node, at.point, random, drawn);
    for (const DrawnLight& one : drawn) {
      if (one.probability == 0) continue;
      const auto found = std::find(lottery.lights.begin(), lottery.lights.end(), one.light);
      if (found != lottery.lights.end()) ++counts[std::size_t(found - lottery.lights.begin())];
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double p = lottery.p[i];
    const double allowed = bernstein_deviation({p * (1 - p), std::max(p, 1 - p)}, draws, rate);
    const double off = std::abs(double(counts[i]) / double(draws) - p);
    tally.record(Property::draws_follow_probabilities, off <= allowed, at.place,
                 ratio_of(off, allowed), [&] {
                   return fmt::format(
                       "{}: light {} of node {} has probability {:.6g} and was drawn "
                       "{} times of {}",
                       at_point(at), lottery.lights[i], lottery.node, p, counts[i], draws);
                 });
  }
}

/// So many that all is noticed that is to be; nothing if that is too many.
std::optional<std::uint64_t> draws_for(const PointCase& at, const std::vector<Lottery>& lotteries,
                                       const std::array<Spread, 3>& spread, double rate,
                                       std::uint64_t most) {
  const auto to_notice = [&](double deviation, const Spread& of) {
    return draws_to_notice(deviation, of, rate, overlooked, most);
  };
  std::uint64_t draws = 1;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto truth = double(at.truth.seen(0)[c]);
    if (!(truth > 0x1p-100)) continue;
    const auto needed = to_notice(noticed_bias * truth, spread[c]);
    if (!needed) return std::nullopt;
    draws = std::max(draws, *needed);
  }
  const bool random = std::any_of(lotteries.begin(), lotteries.end(),
                                  [](const Lottery& l) { return l.p.size() > 1; });
  if (!random) return draws;
  const auto needed = to_notice(noticed_probability, {0.25, 1});
  return needed ? std::optional(std::max(draws, *needed)) : std::nullopt;
}

/// What is gathered of random cuts.
struct Sums {
  std::array<long double, 3> radiance{};
  std::vector<long double> products; ///< of neighbouring clusters' deviations
  bool same_cut = true;
};

Sums sums_of_draws(const Judged& judged, const CutConfig& cut, const PointCase& at,
                   const std::vector<Lottery>& lotteries, std::size_t channel, std::uint64_t draws,
                   std::uint64_t seed) {
  const auto visible = [&at](std::uint32_t light) {
    return light < at.visible.size() && at.visible[light] != 0;
  };
  Sums sums;
  sums.products.resize(lotteries.empty() ? 0 : lotteries.size() - 1, 0);
  for (std::uint64_t i = 0; i < draws && sums.same_cut; ++i) {
    const Cut drawn = judged.tree.draw(at.point, cut, hashed(seed, i), visible);
    for (std::size_t c = 0; c < 3; ++c) sums.radiance[c] += drawn.radiance[int(c)];
    sums.same_cut = drawn.clusters.size() == lotteries.size();
    for (std::size_t k = 0; sums.same_cut && k < lotteries.size(); ++k)
      sums.same_cut = drawn.clusters[k].node == lotteries[k].node;
    for (std::size_t k = 0; sums.same_cut && k + 1 < lotteries.size(); ++k) {
      const auto off = [&](std::size_t j) {
        return drawn.clusters[j].estimate[int(channel)] - lotteries[j].mean[channel];
      };
      sums.products[k] += off(k) * off(k + 1);
    }
  }
  return sums;
}

} // namespace

void check_probabilities(const Judged& judged, const PointCase& at, Tally& tally) {
  for (std::uint32_t node = 0; node < at.topology().size(); ++node) {
    const std::vector<std::uint32_t> lights = at.topology().all_lights(node);
    const std::vector<double> p = judged.tree.probabilities(node, at.point, lights);
    bool all_shine = true;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const bool shines = !is_dark(contribution_of(at, lights[i]));
      all_shine = all_shine && shines;
      tally.record(Property::contributing_lights_are_drawn, p[i] > 0 || !shines, at.place, no_ratio,
                   [&] {
                     return fmt::format("{}: light {} of node {} contributes and is never drawn",
                                        at_point(at), lights[i], node);
                   });
    }
    check_sum(at, node, p, all_shine, tally);
    std::array<double, 8> random;
    for (std::size_t i = 0; i < random.size(); ++i)
      random[i] = (double(i) + 0.5) / double(random.size());
    std::array<DrawnLight, random.size()> drawn;
    judged.tree.samples(node, at.point, random, drawn);
    for (std::size_t i = 0; i < random.size(); ++i)
      check_drawn(at, node, random[i], drawn[i], lights, p, tally);
  }
}

void check_draws(const Judged& judged, const CutConfig& cut, const DrawConfig& config,
                 const PointCase& at, Tally& tally) {
  const auto visible = [&at](std::uint32_t light) {
    return light < at.visible.size() && at.visible[light] != 0;
  };
  const Cut first = judged.tree.draw(at.point, cut, 0, visible);
  std::vector<Lottery> lotteries;
  for (const CutCluster& c : first.clusters) {
    if (c.node >= at.topology().size()) return; // convicted elsewhere
    lotteries.emplace_back(judged, at, c.node);
  }
  const std::size_t channel = brightest(at.truth.seen(0));
  const double truth = double(at.truth.seen(0)[channel]);
  if (!(truth > 0x1p-100) || lotteries.empty()) return;

  std::uint64_t tests = 3 + lotteries.size() - 1;
  for (const Lottery& l : lotteries) tests += l.lights.size();
  const double rate = sidak(sidak(config.false_alarms, config.cases), tests);
  std::array<Spread, 3> spread;
  for (std::size_t c = 0; c < 3; ++c)
    for (const Lottery& l : lotteries) {
      spread[c].variance += l.spread[c].variance;
      spread[c].range += l.spread[c].range;
    }
  const auto draws = draws_for(at, lotteries, spread, rate, config.max_draws);
  if (!draws) return;

  for (const Lottery& l : lotteries)
    if (l.lights.size() > 1)
      check_frequencies(judged, at, l, *draws, rate, hashed(config.seed, l.node), tally);

  const Sums sums = sums_of_draws(judged, cut, at, lotteries, channel, *draws, config.seed);
  tally.record(Property::draws_are_independent, sums.same_cut, at.place, no_ratio,
               [&] { return fmt::format("{}: the cut depends on what is drawn", at_point(at)); });
  if (!sums.same_cut) return;
  const auto n = static_cast<long double>(*draws);
  for (std::size_t c = 0; c < 3; ++c) {
    const long double exact = at.truth.seen(0)[c];
    // Each radiance is a float.
    const double allowed =
        bernstein_deviation(spread[c], *draws, rate) + double(exact) * 0x1p-23 + 0x1p-149;
    const auto off = static_cast<double>(std::abs(sums.radiance[c] / n - exact));
    tally.record(
        Property::stochastic_is_unbiased, off <= allowed, at.place, ratio_of(off, allowed), [&] {
          return fmt::format("{}: mean of {} draws {:.9g}, exact {:.9g}, channel {}", at_point(at),
                             *draws, double(sums.radiance[c] / n), double(exact), "rgb"[c]);
        });
  }
  for (std::size_t k = 0; k + 1 < lotteries.size(); ++k) {
    const Spread &a = lotteries[k].spread[channel], &b = lotteries[k + 1].spread[channel];
    const double allowed =
        bernstein_deviation({a.variance * b.variance, a.range * b.range}, *draws, rate) +
        truth * truth * 0x1p-40;
    const auto off = static_cast<double>(std::abs(sums.products[k] / n));
    tally.record(
        Property::draws_are_independent, off <= allowed, at.place, ratio_of(off, allowed), [&] {
          return fmt::format("{}: draws of nodes {} and {} have a covariance of {:.6g}; of "
                             "independent ones {} would show at most {:.6g}",
                             at_point(at), lotteries[k].node, lotteries[k + 1].node, off, *draws,
                             allowed);
        });
  }
}

} // namespace lightcuts::oracle
