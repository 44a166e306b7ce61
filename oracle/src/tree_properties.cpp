// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include <lightcuts/oracle/point_properties.h>

namespace lightcuts::oracle {
namespace {

void check_intensity(std::uint32_t i, const TreeNode& node, const Wide& sum, unsigned height,
                     Tally& tally) {
  bool holds = true;
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    // Each level adds two numbers, rounding by 2^-53; `sum` rounds as well, but less.
    constexpr long double per_level = 0x1p-53L + std::numeric_limits<long double>::epsilon();
    const long double allowed = sum[c] * height * per_level;
    const long double error = std::abs(node.intensity[c] - sum[c]);
    holds = holds && error <= allowed;
    worst = std::max(worst, ratio_of(error, allowed));
  }
  tally.record(Property::tree_conserves_intensity, holds, i, worst, [&] {
    return fmt::format("node {}: intensity ({:.9g}, {:.9g}, {:.9g}), its lights' total "
                       "({:.9g}, {:.9g}, {:.9g})",
                       i, node.intensity.x, node.intensity.y, node.intensity.z, sum[0], sum[1],
                       sum[2]);
  });
}

} // namespace

void check_tree(const LightTree& tree, Tally& tally) {
  const auto nodes = tree.nodes();
  std::vector<Wide> sums(nodes.size());
  std::vector<unsigned> heights(nodes.size(), 0);
  std::vector<bool> taken(tree.lights().size(), false);
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const TreeNode& node = nodes[i];
    const auto index = static_cast<std::uint32_t>(i);
    bool belongs = node.representative < tree.lights().size();
    if (node.is_leaf()) {
      belongs = belongs && !taken[node.representative];
      if (belongs) {
        taken[node.representative] = true;
        for (int c = 0; c < 3; ++c) sums[i][c] = tree.lights()[node.representative].intensity[c];
      }
    } else {
      const std::uint32_t a = node.first_child;
      belongs = belongs && (node.representative == nodes[a].representative ||
                            node.representative == nodes[a + 1].representative);
      for (int c = 0; c < 3; ++c) sums[i][c] = sums[a][c] + sums[a + 1][c];
      heights[i] = 1 + std::max(heights[a], heights[a + 1]);
    }
    check_intensity(index, node, sums[i], heights[i], tally);
    tally.record(Property::representative_belongs, belongs, i, no_ratio, [&] {
      return fmt::format("node {}: representative {} is not of this cluster", i,
                         node.representative);
    });
  }
}

} // namespace lightcuts::oracle
