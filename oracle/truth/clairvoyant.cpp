// SPDX-License-Identifier: MIT
#include <oracle/truth/clairvoyant.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lightcuts::oracle {

std::size_t clairvoyant_cut_size(const Truth& truth, const EstimateOfCluster& estimate_of,
                                 double threshold, double black_level) {
  const Topology& tree = truth.topology();
  const auto qualifies = [&](std::uint32_t i) {
    if (tree.is_leaf(i)) return true;
    const glm::dvec3 estimate = estimate_of(i);
    for (int c = 0; c < 3; ++c) {
      const long double allowed = std::max<long double>(threshold * truth.seen(0)[c], black_level);
      if (std::abs(estimate[c] - truth.seen(i)[c]) > allowed) return false;
    }
    return true;
  };
  std::size_t size = 0;
  std::vector<std::uint32_t> open;
  if (tree.size() > 0) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    if (qualifies(i))
      ++size;
    else
      open.insert(open.end(), tree.children(i).begin(), tree.children(i).end());
  }
  return size;
}

} // namespace lightcuts::oracle
