// SPDX-License-Identifier: MIT
#include <lightcuts/oracle/check_case.h>

#include "each_view.h"
#include <lightcuts/oracle/case_properties.h>
#include <lightcuts/oracle/point_properties.h>

namespace lightcuts::oracle {
namespace {

void check_cuts(const Judged& judged, const Case& on, const PointCase& at, Tally& tally) {
  const auto visible = [&at](std::uint32_t light) {
    return light < at.visible.size() && at.visible[light] != 0;
  };
  for (const CutConfig& config : cuts_of(on))
    check_cut(judged, config, judged.tree.select(at.point, config, visible), at, tally);
  check_nesting(judged, on.cut, at, tally);
  check_darkening(judged, at, tally);
}

void check_views(const Judged& judged, const Topology& topology, const LightSet& lights,
                 const Case& on, std::uint64_t place, Tally& tally) {
  for_each_view(on, topology, lights, place, [&](std::size_t, const PointCase& at) {
    check_clusters(judged, at, tally);
    if (judged.has(Part::cuts)) check_cuts(judged, on, at, tally);
    if (judged.has(Part::sampling)) check_probabilities(judged, at, tally);
    check_agreement(judged, on.cut, at, tally);
    return false;
  });
}

void check_all(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally) {
  if (!on.triangles.empty()) check_picture(subject, on, place, tally);
  if (has(subject.parts(), Part::refinement_order)) check_refinement_order(subject, place, tally);
  const LightSet lights = on.light_set();
  if (lights.empty()) return;
  const std::unique_ptr<SubjectTree> tree = subject.build(lights, on.seed);
  Judged judged{*tree, subject.parts()};
  const std::optional<Topology> topology = check_tree(tree->claim(), lights, place, tally);
  if (!topology) return;
  check_cost(*topology, lights, place, tally);
  check_views(judged, *topology, lights, on, place, tally);
  check_invariance(subject, on, place, tally);
}

} // namespace

std::array<CutConfig, 3> cuts_of(const Case& on) {
  CutConfig exact = on.cut, small = on.cut;
  exact.threshold = 0;
  exact.black_level = 0;
  exact.max_size = std::uint32_t(on.lights.size());
  small.max_size = 3;
  return {on.cut, exact, small};
}

void check_case(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally) {
  std::string failure;
  try {
    check_all(subject, on, place, tally);
  } catch (const SubjectFailure& e) {
    failure = e.what();
  }
  tally.record(Property::subject_answers, failure.empty(), place, no_ratio,
               [&] { return failure; });
}

} // namespace lightcuts::oracle
