// SPDX-License-Identifier: MIT
#include <oracle/cases/catalogue/making.h>

namespace lightcuts::oracle::making {
namespace {

std::vector<Light> some(int count = 60) {
  return lights(count, [](int, auto& dice) {
    return omni(about(dice, {0, 0, 1.5F}), gen::Dice::not_negative(dice.in_cube()));
  });
}

Case by_threshold(float threshold, std::uint32_t most_clusters = CutConfig().max_size) {
  Case c = lit(some());
  c.cut.threshold = threshold;
  c.cut.max_size = most_clusters;
  return c;
}
Case threshold_of_0() { return by_threshold(0); }
Case threshold_of_1e_7() { return by_threshold(1e-7F); }
Case threshold_of_1() { return by_threshold(1); }
Case threshold_of_100() { return by_threshold(100); }
Case one_cluster() { return by_threshold(0.01F, 1); }
Case two_clusters() { return by_threshold(0, 2); }
Case black_level_above_all() {
  Case c = by_threshold(0);
  c.cut.black_level = 1e30F;
  return c;
}
Case nothing_occludes() {
  Case c = by_threshold(0.01F);
  c.cut.unoccluded = true;
  return c;
}

Case none() { return lit({}); }
Case one() { return lit({omni({0, 0, 1})}); }
Case two_equal() { return lit({omni({0.5F, 0, 1}), omni({0.5F, 0, 1})}); }
Case black_among_bright() {
  Case c = lit(some());
  for (std::size_t i = 0; i < c.lights.size(); i += 2) c.lights[i].intensity = glm::vec3(0);
  return c;
}
Case all_black() {
  Case c = lit(some());
  for (Light& light : c.lights) light.intensity = glm::vec3(0);
  return c;
}
Case all_hidden() {
  Case c = lit(some(20));
  for (std::uint32_t i = 0; i < 20; ++i) c.views[0].hidden.push_back(i);
  return c;
}
Case of_all_kinds() {
  return lit(lights(48, [](int i, auto& dice) {
    const glm::vec3 p = about(dice, {0, 0, 1.5F});
    if (i % 4 == 0) return omni(p);
    if (i % 4 == 1) return oriented(p, unit(-glm::dvec3(p)));
    if (i % 4 == 2) return spot(p, {0, 0, -1}, 0.9F, 0.5F);
    return sun(unit(p));
  }));
}

constexpr NamedCase count_cases[] = {
    {"none", "No light at all: there is no tree to ask.", none},
    {"one", "One light: the root is a leaf.", one},
    {"two-equal", "Two equal lights: no order but that of their indices.", two_equal},
    {"black-among-bright",
     "Half of the lights are black: merging them costs nothing, and none may stand for others.",
     black_among_bright},
    {"all-black", "All lights are black: every weight is 0, and 0/0 is no probability.", all_black},
    {"all-hidden", "Nothing is seen: the total stays 0 while bounds do not.", all_hidden},
    {"of-all-kinds", "Clusters of four kinds of light: none has a box, a cone or a rim of its own.",
     of_all_kinds},
    {"one-cluster", "A cut of one cluster: it ends before it began.", one_cluster},
    {"two-clusters", "A cut of two clusters at threshold 0.", two_clusters},
    {"threshold-of-0", "Nothing but exact clusters obey: every light is asked.", threshold_of_0},
    {"threshold-of-1e-7", "The threshold is next to the rounding of floats.", threshold_of_1e_7},
    {"threshold-of-1", "Each cluster may err by as much as there is.", threshold_of_1},
    {"threshold-of-100", "Everything obeys, but for a total that is all but 0.", threshold_of_100},
    {"black-level-above-all",
     "Every bound is below the black level: the root will do, and the cut has to say why.",
     black_level_above_all},
    {"nothing-occludes", "Lower bounds count: the certified error has two sides.",
     nothing_occludes},
};

} // namespace

std::span<const NamedCase> counts() { return count_cases; }

} // namespace lightcuts::oracle::making
