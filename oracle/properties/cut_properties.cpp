// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <lightcuts/core/cut/certified_error.h>
#include <oracle/properties/point_properties.h>

namespace lightcuts::oracle {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

std::string at_point(const PointCase& at) {
  const glm::vec3& x = at.point.position();
  return fmt::format("point ({:.9g}, {:.9g}, {:.9g})", x.x, x.y, x.z);
}

void check_partition(const Cut& cut, const PointCase& at, Tally& tally) {
  const Topology& tree = at.topology();
  std::vector<std::uint32_t> in_cut;
  for (const CutCluster& c : cut.clusters) in_cut.push_back(c.node);
  std::sort(in_cut.begin(), in_cut.end());
  std::size_t met = 0;
  std::size_t missed = 0;
  std::vector<std::uint32_t> open;
  if (tree.size() > 0) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    if (std::binary_search(in_cut.begin(), in_cut.end(), i)) {
      ++met;
    } else if (tree.is_leaf(i)) {
      missed += tree.lights(i).size();
    } else {
      open.insert(open.end(), tree.children(i).begin(), tree.children(i).end());
    }
  }
  // Clusters below another one of the cut, and repeated ones, were not met.
  tally.record(Property::cut_partitions_lights, missed == 0 && met == in_cut.size(), at.place,
               no_ratio, [&] {
                 std::string text = fmt::format("{}: {} lights in no cluster, {} clusters repeated "
                                                "or inside others",
                                                at_point(at), missed, in_cut.size() - met);
                 if (!in_cut.empty() && in_cut.back() >= tree.size())
                   text += fmt::format(", or beyond the {} nodes there are: {}", tree.size(),
                                       in_cut.back());
                 return text;
               });
}

Wide sum_of_estimates(const Cut& cut) {
  Wide sum{};
  for (const CutCluster& c : cut.clusters)
    for (int i = 0; i < 3; ++i) sum[i] += c.estimate[i];
  return sum;
}

/// Rounding of a total of doubles: 2^-53 for each addition.
long double sum_error(const Cut& cut) {
  return static_cast<long double>(cut.clusters.size()) * 0x1p-53L;
}

void check_threshold(const Judged& judged, const CutConfig& config, const Cut& cut,
                     const Wide& total, const PointCase& at, Tally& tally) {
  const bool full = cut.clusters.size() >= config.max_size && cut.end == CutEnd::max_size;
  bool holds = cut.clusters.size() <= config.max_size && (full || cut.end != CutEnd::max_size);
  double worst = 0;
  std::uint32_t worst_node = 0;
  for (const CutCluster& c : cut.clusters) {
    // A cluster of one light is exact; what is no node is convicted elsewhere.
    if (full || c.node >= at.topology().size() || at.topology().light_count(c.node) == 1) continue;
    const glm::vec3 bound = judged.tree.bound(c.node, at.point);
    for (int i = 0; i < 3; ++i) {
      const long double relative = config.threshold * total[i] * (1 + sum_error(cut));
      const long double allowed = std::max<long double>(relative, config.black_level);
      holds = holds && bound[i] <= allowed;
      if (const double r = ratio_of(bound[i], allowed); r > worst) {
        worst = r;
        worst_node = c.node;
      }
    }
  }
  tally.record(Property::cut_obeys_threshold, holds, at.place, worst, [&] {
    return fmt::format("{}: cut of {} (at most {}) with node {} at {:.6g} times what the "
                       "threshold {} allows",
                       at_point(at), cut.clusters.size(), config.max_size, worst_node, worst,
                       config.threshold);
  });
}

void check_drift(const Cut& cut, const Wide& total, const PointCase& at, Tally& tally) {
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    if (cut.radiance[c] == infinite) { // saturated
      holds = holds && total[c] > std::numeric_limits<float>::max() * (1 - sum_error(cut));
      continue;
    }
    const long double allowed = total[c] * (0x1p-24L + sum_error(cut)) + 0x1p-150L;
    const long double drift = std::abs(cut.radiance[c] - total[c]);
    holds = holds && drift <= allowed;
    worst = std::max(worst, ratio_of(drift, allowed));
  }
  tally.record(Property::total_does_not_drift, holds, at.place, worst, [&] {
    return fmt::format("{}: radiance ({:.9g}, {:.9g}, {:.9g}), estimates sum to ({:.9g}, {:.9g}, "
                       "{:.9g})",
                       at_point(at), cut.radiance.x, cut.radiance.y, cut.radiance.z, total[0],
                       total[1], total[2]);
  });
}

/// |radiance - exact| <= limit, per channel.
void check_against_truth(Property property, const Cut& cut, const glm::vec3& limit,
                         const PointCase& at, Tally& tally) {
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    if (limit[c] == infinite) continue;
    const long double truth = at.truth.seen(0)[c];
    const long double error = std::abs(cut.radiance[c] - truth);
    const auto exact = [&]() -> Exact {
      return abs(Exact(cut.radiance[c]) - at.truth.exact_seen(0, c));
    };
    holds = holds && dominates(limit[c], error, (truth + error) * truth_error, exact);
    worst = std::max(worst, ratio_of(error, limit[c]));
  }
  tally.record(property, holds, at.place, worst, [&] {
    const Wide& exact = at.truth.seen(0);
    return fmt::format("{}: radiance ({:.9g}, {:.9g}, {:.9g}), exact ({:.9g}, {:.9g}, {:.9g}), "
                       "allowed difference ({:.3g}, {:.3g}, {:.3g})",
                       at_point(at), cut.radiance.x, cut.radiance.y, cut.radiance.z, exact[0],
                       exact[1], exact[2], limit.x, limit.y, limit.z);
  });
}

void check_finite(const Cut& cut, const PointCase& at, Tally& tally) {
  bool holds = true;
  for (int c = 0; c < 3; ++c) {
    holds = holds && cut.radiance[c] >= 0 && cut.certified_error[c] >= 0;
    // Estimates lie below bounds, so the total can only saturate if a bound has, or the truth does.
    if (cut.radiance[c] == infinite) holds = holds && cut.certified_error[c] == infinite;
  }
  tally.record(Property::results_are_finite, holds, at.place, no_ratio, [&] {
    return fmt::format("{}: radiance ({}, {}, {}), certified error ({}, {}, {})", at_point(at),
                       cut.radiance.x, cut.radiance.y, cut.radiance.z, cut.certified_error.x,
                       cut.certified_error.y, cut.certified_error.z);
  });
}

glm::vec3 rounding_only(const PointCase& at) {
  glm::vec3 limit;
  for (int c = 0; c < 3; ++c)
    limit[c] = certified_error(static_cast<double>(at.truth.seen(0)[c]), 0);
  return limit;
}

} // namespace

void check_cut(const Judged& judged, const CutConfig& config, const Cut& cut, const PointCase& at,
               Tally& tally) {
  const Wide total = sum_of_estimates(cut);
  check_partition(cut, at, tally);
  if (judged.has(Part::bounds)) check_threshold(judged, config, cut, total, at, tally);
  check_drift(cut, total, at, tally);
  check_finite(cut, at, tally);
  check_against_truth(Property::certified_error_holds, cut, cut.certified_error, at, tally);
  if (config.threshold == 0 && config.black_level == 0 && config.max_size >= at.lights().size())
    check_against_truth(Property::zero_threshold_is_exact, cut, rounding_only(at), at, tally);
}

} // namespace lightcuts::oracle
