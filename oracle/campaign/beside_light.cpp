// SPDX-License-Identifier: MIT
#include <oracle/campaign/beside_light.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <oracle/numbers/dice.h>

namespace lightcuts::oracle {
namespace {

using gen::Dice;

/// Some way down from the root, so that all sizes of clusters are as likely.
std::uint32_t random_cluster(Dice& dice, const Topology& topology) {
  std::uint32_t node = 0;
  for (int levels = dice.below(24); levels > 0 && !topology.is_leaf(node); --levels) {
    const auto children = topology.children(node);
    node = children[dice.bits() % children.size()];
  }
  return node;
}

} // namespace

gen::View view_beside_light(const LightSet& lights, const Topology& topology, std::uint64_t random,
                            const gen::View& otherwise) {
  Dice dice(random);
  const std::span<const std::uint32_t> members =
      topology.all_lights(random_cluster(dice, topology));
  const int axis = dice.below(3);
  const float side = dice.sign();
  const auto out = [&](std::uint32_t i) { return side * lights[i].position[axis]; };
  const auto [inmost, outmost] =
      std::minmax_element(members.begin(), members.end(),
                          [&](std::uint32_t a, std::uint32_t b) { return out(a) < out(b); });
  const Light& light = lights[*outmost];
  if (light.kind == LightKind::directional) return otherwise;
  const double size = double(out(*outmost)) - double(out(*inmost));
  const double scale = size > 0 ? size : std::max(1e-3, std::abs(double(out(*outmost))));
  gen::View view = otherwise;
  view.position = light.position;
  const float at = light.position[axis];
  view.position[axis] = Dice::finite(double(at) + side * std::ldexp(scale, -dice.between(0, 20)));
  if (view.position[axis] == at) view.position[axis] = std::nextafter(at, side * 1e38F);
  view.normal = glm::vec3(0);
  view.normal[axis] = -side;
  if (dice.one_in(2)) view.to_viewer = view.normal;
  return view;
}

} // namespace lightcuts::oracle
