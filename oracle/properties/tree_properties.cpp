// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <oracle/properties/point_properties.h>

namespace lightcuts::oracle {
namespace {

void check_intensity(std::uint32_t i, const glm::dvec3& intensity, const Wide& sum, unsigned height,
                     std::uint64_t place, Tally& tally) {
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    // Each addition rounds by 2^-53; `sum` rounds as well, but less.
    constexpr long double per_addition = 0x1p-53L + std::numeric_limits<long double>::epsilon();
    const long double allowed = sum[c] * height * per_addition;
    const long double error = std::abs(intensity[c] - sum[c]);
    holds = holds && error <= allowed;
    worst = std::max(worst, ratio_of(error, allowed));
  }
  tally.record(Property::tree_conserves_intensity, holds, place, worst, [&] {
    return fmt::format("node {}: intensity ({:.9g}, {:.9g}, {:.9g}), its lights' total "
                       "({:.9g}, {:.9g}, {:.9g})",
                       i, intensity.x, intensity.y, intensity.z, sum[0], sum[1], sum[2]);
  });
}

} // namespace

std::optional<Topology> check_tree(TreeClaim claim, const LightSet& lights, std::uint64_t place,
                                   Tally& tally) {
  TopologyReading reading = read_topology(std::move(claim), lights.size());
  tally.record(Property::tree_partitions_lights, reading.defect.empty(), place, no_ratio,
               [&] { return reading.defect; });
  if (!reading.topology) return std::nullopt;
  const Topology& tree = *reading.topology;
  std::vector<Wide> sums(tree.size());
  std::vector<unsigned> heights(tree.size(), 0);
  const auto nodes = tree.parents_first();
  for (auto i = nodes.rbegin(); i != nodes.rend(); ++i) {
    const std::uint32_t representative = tree.representative(*i);
    bool belongs = false;
    for (const std::uint32_t light : tree.lights(*i)) {
      belongs = belongs || representative == light;
      for (int c = 0; c < 3; ++c) sums[*i][c] += lights[light].intensity[c];
    }
    unsigned height = 0;
    for (const std::uint32_t child : tree.children(*i)) {
      belongs = belongs || representative == tree.representative(child);
      for (int c = 0; c < 3; ++c) sums[*i][c] += sums[child][c];
      height = std::max(height, heights[child]);
    }
    // Of so many terms, one addition less.
    const std::size_t terms = tree.lights(*i).size() + tree.children(*i).size();
    height += unsigned(std::max<std::size_t>(terms, 1) - 1);
    heights[*i] = height;
    if (tree.intensity(*i))
      check_intensity(*i, *tree.intensity(*i), sums[*i], height, place, tally);
    if (representative != TreeClaim::unsaid)
      tally.record(Property::representative_belongs, belongs, place, no_ratio, [&] {
        return fmt::format("node {}: representative {} is not of this cluster", *i, representative);
      });
  }
  return std::move(reading.topology);
}

} // namespace lightcuts::oracle
