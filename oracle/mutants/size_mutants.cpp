// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <vector>

#include <oracle/mutants/groups.h>

namespace lightcuts::oracle {
namespace {

/// Boxes are made of blocks of so many lights.
constexpr std::uint32_t block = 1024;

/// Leaves the one light after the last whole block out of the boxes of its clusters.
LightTree without_last_of_block(const LightSet& lights, std::uint64_t seed) {
  const LightTree tree = build(lights, {seed});
  if (lights.size() < block || lights.size() % block != 1) return tree;
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  std::vector<std::optional<Box>> boxes(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    TreeNode& node = nodes[i];
    if (node.is_leaf()) {
      if (node.representative + 1 != lights.size()) boxes[i] = node.box;
      continue;
    }
    for (const std::uint32_t child : {node.first_child, node.first_child + 1}) {
      if (boxes[i] && boxes[child]) {
        boxes[i]->extend(boxes[child]->lo);
        boxes[i]->extend(boxes[child]->hi);
      } else if (boxes[child]) {
        boxes[i] = boxes[child];
      }
    }
    node.box = *boxes[i];
  }
  return {lights, std::move(nodes)};
}

LightTree with_indices_in_16_bits(const LightSet& lights, std::uint64_t seed) {
  const LightTree tree = build(lights, {seed});
  std::vector<TreeNode> nodes(tree.nodes().begin(), tree.nodes().end());
  for (TreeNode& node : nodes) node.representative &= 0xFFFF;
  return {lights, std::move(nodes)};
}

/// Finds a cluster's lights with a stack that has room for so many levels.
class ShallowStack : public CopiedPerThread<ShallowStack> {
public:
  using CopiedPerThread<ShallowStack>::CopiedPerThread;
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    constexpr std::uint32_t room = 40;
    if (heights_.empty()) measure();
    if (heights_[node] <= room) return LibraryTree::bound(node, point);
    const std::uint32_t child = tree().node(node).first_child;
    return LibraryTree::bound(heights_[child] < heights_[child + 1] ? child : child + 1, point);
  }

private:
  void measure() {
    const auto nodes = tree().nodes();
    heights_.resize(nodes.size(), 0);
    for (std::size_t i = nodes.size(); i-- > 0;)
      if (const std::uint32_t child = nodes[i].first_child; child != 0)
        heights_[i] = 1 + std::max(heights_[child], heights_[child + 1]);
  }

  std::vector<std::uint32_t> heights_;
};

constexpr Mutant size_catalogue[] = {
    {"last-of-1025-lights",
     "leaves the light that follows the last whole block of 1024 out of the boxes",
     with_altered<without_last_of_block>},
    {"light-index-in-16-bits", "keeps the indices of lights in 16 bits",
     with_altered<with_indices_in_16_bits>},
    {"stack-of-40-levels", "bounds only the shallower child of clusters deeper than 40 levels",
     with_tree<ShallowStack>},
};

} // namespace

std::span<const Mutant> size_mutants() { return size_catalogue; }

} // namespace lightcuts::oracle
