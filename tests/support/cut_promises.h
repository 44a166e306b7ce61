// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <set>
#include <string>

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {

/// Nothing occludes.
inline constexpr auto everything = [](std::uint32_t) { return true; };

struct CutCase {
  gen::Scene scene;
  CutConfig config;
  std::uint32_t hidden = 0; ///< light i is occluded if bit i mod 32 is set

  [[nodiscard]] auto visibility() const {
    return [mask = hidden](std::uint32_t i) { return ((mask >> (i % 32)) & 1U) == 0; };
  }
};

inline std::ostream& operator<<(std::ostream& out, const CutCase& c) {
  return out << c.scene << "\nthreshold " << c.config.threshold << " max_size " << c.config.max_size
             << " black_level " << c.config.black_level << " hidden " << std::hex << c.hidden
             << std::dec;
}

inline rc::Gen<CutCase> cut_case() {
  const auto config = gen::from_dice<CutConfig>([](gen::Dice& dice) {
    const float threshold = dice.pick({0.0F, 0.001F, 0.02F, 0.02F, 0.5F, 2.0F});
    const std::uint32_t max_size = dice.pick({1000U, 1000U, 1U, 2U, 3U, 5U, 8U});
    const float black_level = dice.pick({0.0F, 0.0F, 1e-3F, 1e30F});
    return CutConfig{threshold, max_size, black_level};
  });
  const auto hidden =
      rc::gen::oneOf(rc::gen::just(0U), rc::gen::arbitrary<std::uint32_t>(), rc::gen::just(~0U));
  return rc::gen::map(rc::gen::tuple(gen::scene(), config, hidden), [](const auto& t) {
    return CutCase{std::get<0>(t), std::get<1>(t), std::get<2>(t)};
  });
}

namespace promises {

inline void collect(const LightTree& tree, std::uint32_t i, std::vector<int>& count) {
  const TreeNode& node = tree.node(i);
  if (node.is_leaf()) {
    ++count[node.representative];
    return;
  }
  collect(tree, node.first_child, count);
  collect(tree, node.first_child + 1, count);
}

inline bool partitions(const LightTree& tree, const Cut& cut) {
  std::vector<int> count(tree.lights().size());
  for (const CutCluster& c : cut.clusters) collect(tree, c.node, count);
  return std::all_of(count.begin(), count.end(), [](int n) { return n == 1; });
}

/// In real numbers but for the sum, which is that of Cut::radiance before rounding to float.
inline glm::dvec3 total(const Cut& cut) {
  glm::dvec3 sum(0);
  for (const CutCluster& c : cut.clusters) sum += c.estimate;
  return sum;
}

inline bool obeys(const Cut& cut, const CutConfig& config, double black_level) {
  const glm::dvec3 sum = total(cut);
  for (const CutCluster& c : cut.clusters)
    for (int k = 0; k < 3; ++k)
      if (!(c.bound[k] <= std::max(config.threshold * sum[k], black_level))) return false;
  return true;
}

inline bool certified(const Cut& cut, const precise::Colour& exact) {
  using precise::Quad;
  for (int c = 0; c < 3; ++c) {
    if (std::isnan(cut.radiance[c]) || std::isnan(cut.certified_error[c])) return false;
    if (std::isinf(cut.certified_error[c])) continue;
    if (abs(Quad(cut.radiance[c]) - exact[c]) > Quad(cut.certified_error[c])) return false;
  }
  return true;
}

inline bool leaves_are_exact(const LightTree& tree, const Cut& cut) {
  return std::all_of(cut.clusters.begin(), cut.clusters.end(), [&](const CutCluster& c) {
    return !tree.node(c.node).is_leaf() || c.bound == glm::vec3(0);
  });
}

} // namespace promises

/// The first promise of CutLoop that is broken in this case by the kernel and the stopping rule;
/// empty if all are kept.
template <class Rule = StoppingRule>
std::string broken_promise(const CutCase& given,
                           const ClusterKernel& kernel = kernel_for(all_light_kinds)) {
  const LightTree tree = build(given.scene.light_set());
  const ShadingPoint point = given.scene.view.point();
  CutLoop<Rule> select(tree, given.config, kernel);
  std::vector<int> calls(tree.lights().size());
  const Cut cut = select(point, [&](std::uint32_t i) {
    ++calls[i];
    return given.visibility()(i);
  });
  if (!promises::partitions(tree, cut)) return "the cut partitions the lights";
  if (cut.clusters.size() > given.config.max_size) return "max_size is respected";
  if (cut.end == CutEnd::max_size && cut.clusters.size() < given.config.max_size)
    return "stops at max_size only";
  const bool relative = promises::obeys(cut, given.config, 0);
  if (relative != (cut.end == CutEnd::converged)) return "converged is where all obey threshold";
  if (cut.end == CutEnd::black_level &&
      !promises::obeys(cut, given.config, given.config.black_level))
    return "black_level is obeyed";
  if (!promises::certified(cut, precise::sum(tree.lights(), point, given.visibility())))
    return "certified error holds";
  if (!promises::leaves_are_exact(tree, cut)) return "a leaf has bound 0";
  std::uint32_t total = 0;
  for (const int n : calls) {
    if (n > 1) return "no light is evaluated twice";
    total += static_cast<std::uint32_t>(n);
  }
  if (total != cut.shadow_rays) return "shadow rays are counted";
  return {};
}

} // namespace lightcuts
