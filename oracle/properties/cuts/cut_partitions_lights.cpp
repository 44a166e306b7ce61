// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include <oracle/properties/cut_answer.h>

namespace lightcuts::oracle {
namespace {

void check_partition(const CutAnswer& of, const Recorder& record) {
  const Topology& tree = of.point.topology();
  std::vector<std::uint32_t> in_cut;
  for (const CutCluster& c : of.cut.clusters) in_cut.push_back(c.node);
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
  record(missed == 0 && met == in_cut.size(), [&] {
    std::string text = fmt::format("{}: {} lights in no cluster, {} clusters repeated or inside "
                                   "others",
                                   of.point.at.text(), missed, in_cut.size() - met);
    if (!in_cut.empty() && in_cut.back() >= tree.size())
      text += fmt::format(", or beyond the {} nodes there are: {}", tree.size(), in_cut.back());
    return text;
  });
}

} // namespace

const PropertyInfo property::cut_partitions_lights{
    .name = "cut-partitions-lights",
    .statement = "Every light is in exactly one cluster of the cut.",
    .formula = "each path from the root to a leaf meets the cut once",
    .needs = only(Part::cuts),
    .of_cut = check_partition,
};

} // namespace lightcuts::oracle
