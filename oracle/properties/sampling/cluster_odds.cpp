// SPDX-License-Identifier: MIT
#include <oracle/properties/sampling/cluster_odds.h>

#include <algorithm>

namespace lightcuts::oracle {

ClusterOdds::ClusterOdds(const PointAnswers& answers, std::uint32_t cluster)
    : point(answers), node(cluster), lights(point.topology().all_lights(node)),
      p(point.judged.tree.probabilities(node, point.at.point, lights)) {
  const LightSet& all = point.at.lights();
  for (const std::uint32_t i : lights)
    light.push_back(contribution(all[i], point.at.point, all.min_distance()));
}

double ClusterOdds::stated(std::uint32_t index) const {
  const auto found = std::find(lights.begin(), lights.end(), index);
  return found == lights.end() ? 0 : p[std::size_t(found - lights.begin())];
}

double ClusterOdds::none() const {
  double none = 1;
  for (const double one : p) none -= one;
  return none;
}

} // namespace lightcuts::oracle
