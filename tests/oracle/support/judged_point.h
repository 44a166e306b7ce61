// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/properties/judge.h>
#include <oracle/subjects/library_subject.h>

namespace lightcuts::oracle {

/// What the library has.
inline constexpr Parts library_parts =
    only(Part::bounds) | only(Part::lower_bounds) | only(Part::estimates) | only(Part::cuts) |
    only(Part::refinement_order) | only(Part::occlusion) | only(Part::pictures) |
    only(Part::greedy_tree) | only(Part::library_rules);

/// A tree and a shading point with the truth there: what the properties are checked on.
struct JudgedPoint {
  LightTree tree;
  Topology topology;
  ShadingPoint point;
  std::vector<char> visible;
  Truth truth;

  JudgedPoint(LightTree of, const ShadingPoint& from, std::vector<char> seen)
      : tree(std::move(of)),
        topology(read_topology(claim_of(tree), tree.lights().size()).topology.value()), point(from),
        visible(std::move(seen)) {
    truth.evaluate(topology, tree.lights(), point, visible);
  }
  JudgedPoint(const JudgedPoint&) = delete;
  JudgedPoint& operator=(const JudgedPoint&) = delete;

  [[nodiscard]] PointCase at() const { return {7, point, visible, truth}; }
  [[nodiscard]] LibraryTree library() const { return LibraryTree(tree); }
};

/// Lights of intensity 1, 2, 4 and 8 (green twice, blue thrice that) over the corners of a square.
inline LightTree four_lights() {
  LightSet lights;
  for (int i = 0; i < 4; ++i)
    lights.add_omni({i % 2, i / 2, 1 + i / 2}, float(1 << i) * glm::vec3(1, 2, 3));
  return build(lights);
}

inline ShadingPoint diffuse_point(const glm::vec3& position = glm::vec3(0)) {
  return {position, {0, 0, 1}, {0, 0, 1}, {glm::vec3(0.5F)}};
}

/// The library's tree but for a bound that a test has bent.
class BentTree : public LibraryTree {
public:
  using Bend = std::function<glm::vec3(std::uint32_t node, glm::vec3 bound)>;

  BentTree(const LightTree& of, Bend bend) : LibraryTree(of), bend_(std::move(bend)) {}
  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    return std::make_unique<BentTree>(*this);
  }
  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    return bend_(node, LibraryTree::bound(node, point));
  }

private:
  Bend bend_;
};

/// What a scene is asked for; all others need cases.
inline constexpr std::array reached_by_check{
    Property::tree_partitions_lights,      Property::tree_conserves_intensity,
    Property::representative_belongs,      Property::bound_dominates_contribution,
    Property::bound_dominates_error,       Property::bounds_are_ordered,
    Property::bound_shrinks_on_refinement, Property::bound_is_finite,
    Property::cut_partitions_lights,       Property::cut_obeys_threshold,
    Property::certified_error_holds,       Property::zero_threshold_is_exact,
    Property::total_does_not_drift,        Property::results_are_finite,
    Property::brdf_is_reciprocal,          Property::brdf_conserves_energy,
    Property::occlusion_equals_brute_force};

/// What judge(Judge, PointAnswers) counts of the tree at the point: of all properties, or of one.
template <class F>
Tally judged_at(SubjectTree& tree, const JudgedPoint& judged, F&& judge,
                Parts parts = library_parts, std::optional<Property> only = std::nullopt) {
  Tally tally;
  judge(Judge(parts, judged.at().place, tally, only), PointAnswers({tree, parts}, judged.at()));
  return tally;
}

/// Of all clusters.
inline Tally judged_clusters(SubjectTree&& tree, const JudgedPoint& judged) {
  return judged_at(tree, judged,
                   [](const Judge& judge, const PointAnswers& of) { judge.clusters(of); });
}

/// The properties that were violated.
inline std::vector<Property> violated(const Tally& tally) {
  std::vector<Property> list;
  for (const Property p : all_properties)
    if (tally[p].violations > 0) list.push_back(p);
  return list;
}

} // namespace lightcuts::oracle
