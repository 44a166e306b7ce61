// SPDX-License-Identifier: MIT
#include <oracle/properties/sampling/cluster_odds.h>

#include <algorithm>
#include <utility>

namespace lightcuts::oracle {

ClusterOdds::ClusterOdds(const PointAnswers& answers, std::uint32_t cluster)
    : point(answers), node(cluster) {
  std::vector<std::pair<std::uint32_t, int>> open{{node, 0}};
  while (!open.empty()) {
    const auto [i, level] = open.back();
    open.pop_back();
    const auto own = point.topology().lights(i);
    for (const std::uint32_t one : own) {
      lights.push_back(one);
      levels.push_back(level + (own.size() > 1 ? 1 : 0));
    }
    for (const std::uint32_t child : point.topology().children(i))
      open.emplace_back(child, level + 1);
  }
  p = point.judged.tree.probabilities(node, point.at.point, lights);
  const LightSet& all = point.at.lights();
  for (const std::uint32_t i : lights)
    light.push_back(contribution(all[i], point.at.point, all.min_distance()));
}

std::size_t ClusterOdds::place_of(std::uint32_t index) const {
  return std::size_t(std::find(lights.begin(), lights.end(), index) - lights.begin());
}

double ClusterOdds::none() const {
  double none = 1;
  for (const double one : p) none -= one;
  return none;
}

} // namespace lightcuts::oracle
