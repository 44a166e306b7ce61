// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/truth.h>

#include <lightcuts/oracle/radiometry.h>

namespace lightcuts::oracle {

Wide contribution(const Light& light, const ShadingPoint& point, float min_distance) {
  return radiometry::contribution<long double>(light, point, min_distance);
}

Exact exact_contribution(const Light& light, const ShadingPoint& point, float min_distance,
                         int channel) {
  return radiometry::contribution<Exact>(light, point, min_distance)[std::size_t(channel)];
}

void Truth::evaluate(const LightTree& tree, const ShadingPoint& point,
                     std::span<const char> visible) {
  tree_ = &tree;
  point_ = &point;
  visible_ = visible;
  const auto nodes = tree.nodes();
  open_.resize(nodes.size());
  seen_.resize(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const TreeNode& node = nodes[i];
    if (node.is_leaf()) {
      open_[i] =
          contribution(tree.lights()[node.representative], point, tree.lights().min_distance());
      seen_[i] = visible[node.representative] != 0 ? open_[i] : Wide{};
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      open_[i][c] = open_[node.first_child][c] + open_[node.first_child + 1][c];
      seen_[i][c] = seen_[node.first_child][c] + seen_[node.first_child + 1][c];
    }
  }
}

Exact Truth::exact(std::uint32_t node, int channel, bool only_visible) const {
  Exact sum = 0;
  std::vector<std::uint32_t> open{node};
  while (!open.empty()) {
    const TreeNode& n = tree_->node(open.back());
    open.pop_back();
    if (!n.is_leaf()) {
      open.push_back(n.first_child);
      open.push_back(n.first_child + 1);
    } else if (!only_visible || visible_[n.representative] != 0) {
      sum += exact_contribution(tree_->lights()[n.representative], *point_,
                                tree_->lights().min_distance(), channel);
    }
  }
  return sum;
}

} // namespace lightcuts::oracle
