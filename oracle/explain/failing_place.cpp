// SPDX-License-Identifier: MIT
#include <oracle/explain/failing_place.h>

#include <memory>

#include <oracle/properties/cut_answer.h>
#include <oracle/properties/each_view.h>

namespace lightcuts::oracle {
namespace {

/// How the first cut that breaks the property is configured.
std::optional<CutConfig> failing_cut(const PointAnswers& of, Property property,
                                     const CutConfig& configured) {
  for (const CutConfig& config : cuts_of(configured, of.at.lights().size())) {
    Tally tally;
    Judge(of.judged.parts, 0, tally, property).cuts(of, {&config, 1});
    if (tally[property].violations > 0) return config;
  }
  return std::nullopt;
}

} // namespace

std::optional<std::uint32_t> failing_cluster(const PointAnswers& of, Property property) {
  Tally tally;
  const Judge judge(of.judged.parts, 0, tally, property);
  for (std::uint32_t node = 0; node < of.topology().size(); ++node) {
    judge.clusters(of, {node, node + 1});
    if (tally[property].violations > 0) return node;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> failing_cluster(const BlockAnswers& of, Property property) {
  Tally tally;
  const Judge judge(of.point.judged.parts, 0, tally, property);
  for (std::uint32_t node = 0; node < of.bounds.size(); ++node) {
    judge.block({of.point, of.bounds, {node, node + 1}});
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
  Tally unused;
  const std::vector<glm::vec3> of_block =
      Judge(subject.parts(), 0, unused, c.property).block_bounds(judged, *reading.topology, c.on);
  std::optional<FailingPlace> place;
  for_each_view(c.on, *reading.topology, lights, 0, [&](std::size_t view, const PointCase& at) {
    const PointAnswers answers(judged, at);
    if (const auto node = failing_cluster(answers, c.property))
      place = {view, node, c.on.cut};
    else if (const auto in_block = failing_cluster({answers, of_block, {0, 0}}, c.property))
      place = {view, in_block, c.on.cut};
    else if (const auto cut = failing_cut(answers, c.property, c.on.cut))
      place = {view, std::nullopt, *cut};
    return place.has_value();
  });
  return place;
}

} // namespace lightcuts::oracle
