// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include <oracle/properties/text_rows.h>
#include <oracle/properties/tree_case.h>
#include <oracle/truth/truth.h>

namespace lightcuts::oracle {
namespace {

/// What a cluster's lights sum to, and the additions on the longest way up to it.
struct Sum {
  Wide intensity{};
  std::size_t height = 0;
};

void check_node(std::uint32_t i, const glm::dvec3& intensity, const Sum& sum,
                const Recorder& record) {
  bool holds = true;
  double worst = 0;
  const Wide& total = sum.intensity;
  for (int c = 0; c < 3; ++c) {
    // Each addition rounds by 2^-53; `total` rounds as well, but less.
    constexpr long double per_addition = 0x1p-53L + std::numeric_limits<long double>::epsilon();
    const long double allowed = total[c] * static_cast<long double>(sum.height) * per_addition;
    const long double error = std::abs(intensity[c] - total[c]);
    holds = holds && error <= allowed;
    worst = std::max(worst, ratio_of(error, allowed));
  }
  record(holds, worst, [&] {
    return fmt::format("node {}: intensity ({:.9g}, {:.9g}, {:.9g}), its lights' total "
                       "({:.9g}, {:.9g}, {:.9g})",
                       i, intensity.x, intensity.y, intensity.z, total[0], total[1], total[2]);
  });
}

void check_intensity(const TreeCase& of, const Recorder& record) {
  if (of.topology == nullptr) return;
  const Topology& tree = *of.topology;
  std::vector<Sum> sums(tree.size());
  const auto nodes = tree.parents_first();
  for (auto i = nodes.rbegin(); i != nodes.rend(); ++i) {
    Sum& sum = sums[*i];
    for (const std::uint32_t light : tree.lights(*i))
      for (int c = 0; c < 3; ++c) sum.intensity[c] += of.lights[light].intensity[c];
    for (const std::uint32_t child : tree.children(*i)) {
      for (int c = 0; c < 3; ++c) sum.intensity[c] += sums[child].intensity[c];
      sum.height = std::max(sum.height, sums[child].height);
    }
    // Of so many terms, one addition less.
    const std::size_t terms = tree.lights(*i).size() + tree.children(*i).size();
    sum.height += std::max<std::size_t>(terms, 1) - 1;
    if (tree.intensity(*i)) check_node(*i, *tree.intensity(*i), sum, record);
  }
}

/// The intensities of a node, side by side with what its lights sum to.
std::string rows(const TreeCase& of, std::uint32_t node) {
  if (!of.topology->intensity(node)) return {};
  std::array<Exact, 3> sum{0, 0, 0};
  for (const std::uint32_t light : of.topology->all_lights(node))
    for (int c = 0; c < 3; ++c) sum[std::size_t(c)] += Exact(of.lights[light].intensity[c]);
  return number_row("intensity", *of.topology->intensity(node)) +
         row_of("its lights' total", [&](int c) { return text_of(sum[std::size_t(c)]); });
}

} // namespace

const PropertyInfo property::tree_conserves_intensity{
    .name = "tree-conserves-intensity",
    .statement = "A cluster's intensity is the total of its lights'.",
    .formula = "|intensity - sum| <= height * 2^-53 * sum, per channel",
    .of_tree = check_intensity,
    .node_rows = rows,
};

} // namespace lightcuts::oracle
