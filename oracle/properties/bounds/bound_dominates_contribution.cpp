// SPDX-License-Identifier: MIT
#include <oracle/properties/bounds/bound_dominates_contribution.h>

#include <vector>

#include <oracle/properties/bounds/worst_channel.h>

namespace lightcuts::oracle {
namespace {

/// exact(channel): the same truth as Exact.
template <class MakeExact>
WorstChannel compared(const Wide& truth, const glm::vec3& bound, const MakeExact& exact) {
  WorstChannel worst;
  for (int c = 0; c < 3; ++c) {
    const long double t = truth[std::size_t(c)];
    worst.add(c, dominates(bound[c], t, t * truth_error, [&] { return exact(c); }), t, bound[c]);
  }
  return worst;
}

void check_contribution(const PointAnswers& of, std::uint32_t node, const Recorder& record) {
  check_dominates(of, node, of.bounds()[node], "bound", record);
}

} // namespace

void check_dominates(const PointAnswers& of, std::uint32_t node, const glm::vec3& bound,
                     const char* name, const Recorder& record) {
  const WorstChannel worst = compared(of.at.truth.open(node), bound,
                                      [&](int c) { return of.at.truth.exact_open(node, c); });
  record(worst.holds, worst.ratio, [&] {
    return sides_text(of, node, worst, "true contribution", name, bound[worst.channel]);
  });
}

void check_bound(const Topology& topology, const LightSet& lights, const ShadingPoint& point,
                 std::uint32_t node, const glm::vec3& bound, const Recorder& record) {
  const std::span<const std::uint32_t> members = topology.all_lights(node);
  Wide sum{};
  for (const std::uint32_t light : members) {
    const Wide one = contribution(lights[light], point, lights.min_distance());
    for (std::size_t c = 0; c < 3; ++c) sum[c] += one[c];
  }
  const WorstChannel worst = compared(sum, bound, [&](int c) {
    Exact exact = 0;
    for (const std::uint32_t light : members)
      exact += exact_contribution(lights[light], point, lights.min_distance(), c);
    return exact;
  });
  record(worst.holds, worst.ratio, [&] {
    return sides_text(point, topology, node, worst.channel, "true contribution", worst.value,
                      "bound", bound[worst.channel]);
  });
}

const PropertyInfo property::bound_dominates_contribution{
    .name = "bound-dominates-contribution",
    .statement = "A cluster's bound is at least what its lights would contribute if all were seen.",
    .formula = "sum of contributions <= bound, per channel",
    .needs = only(Part::bounds),
    .of_clusters = each_cluster<check_contribution>,
};

} // namespace lightcuts::oracle
