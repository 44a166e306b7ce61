// SPDX-License-Identifier: MIT
#include <oracle/explain/failing_place.h>

#include <vector>

#include <oracle/properties/each_view.h>

namespace lightcuts::oracle {
namespace {

/// How the first cut that breaks the property is configured.
std::optional<CutConfig> failing_cut(const Judged& judged, Property property, const Case& on,
                                     const PointCase& at) {
  if (!judged.has(Part::cuts)) return std::nullopt;
  const auto visible = [&at](std::uint32_t light) {
    return light < at.visible.size() && at.visible[light] != 0;
  };
  for (const CutConfig& config : cuts_of(on)) {
    Tally tally;
    check_cut(judged, config, judged.tree.select(at.point, config, visible), at, tally);
    if (tally[property].violations > 0) return config;
  }
  return std::nullopt;
}

} // namespace

std::optional<std::uint32_t> failing_cluster(const Judged& judged, Property property,
                                             const PointCase& at,
                                             std::span<const glm::vec3> bounds) {
  for (std::uint32_t node = 0; node < bounds.size(); ++node) {
    Tally tally;
    check_cluster(judged, node, at, bounds, tally);
    if (tally[property].violations > 0) return node;
  }
  return std::nullopt;
}

std::optional<FailingPlace> failing_place(const Subject& subject, const Counterexample& c) {
  const LightSet lights = c.on.light_set();
  if (lights.empty()) return std::nullopt;
  const std::unique_ptr<SubjectTree> tree = subject.build(lights, c.on.seed);
  const TopologyReading reading = read_topology(tree->claim(), lights.size());
  if (!reading.topology) return std::nullopt;
  const Judged judged{*tree, subject.parts()};
  std::optional<FailingPlace> place;
  for_each_view(c.on, *reading.topology, lights, 0, [&](std::size_t view, const PointCase& at) {
    if (judged.has(Part::bounds)) {
      std::vector<glm::vec3> bounds(at.topology().size());
      judged.tree.bounds(at.point, bounds);
      if (const auto node = failing_cluster(judged, c.property, at, bounds))
        place = {view, node, c.on.cut};
    }
    if (place) return true;
    if (const auto cut = failing_cut(judged, c.property, c.on, at))
      place = {view, std::nullopt, *cut};
    return place.has_value();
  });
  return place;
}

} // namespace lightcuts::oracle
