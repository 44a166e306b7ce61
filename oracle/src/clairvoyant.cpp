// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/clairvoyant.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lightcuts::oracle {

std::size_t clairvoyant_cut_size(const Subject& subject, const ShadingPoint& point,
                                 std::span<const char> visible, const Truth& truth,
                                 double threshold, double black_level) {
  const LightTree& tree = subject.tree();
  const auto qualifies = [&](std::uint32_t i) {
    const TreeNode& node = tree.node(i);
    if (node.is_leaf()) return true;
    const glm::dvec3 estimate = seen_estimate(subject, i, point, subject.bound(i, point), visible);
    for (int c = 0; c < 3; ++c) {
      const long double allowed = std::max<long double>(threshold * truth.seen(0)[c], black_level);
      if (std::abs(estimate[c] - truth.seen(i)[c]) > allowed) return false;
    }
    return true;
  };
  std::size_t size = 0;
  std::vector<std::uint32_t> open;
  if (!tree.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    if (qualifies(i)) {
      ++size;
      continue;
    }
    open.push_back(tree.node(i).first_child);
    open.push_back(tree.node(i).first_child + 1);
  }
  return size;
}

} // namespace lightcuts::oracle
