// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <oracle/cases/case.h>
#include <oracle/properties/point_case.h>
#include <oracle/properties/sampling/draws.h>
#include <oracle/properties/shading/ray_case.h>

namespace lightcuts::oracle {

/// Runs the table of properties, or one of them, on what a subject is judged on, and counts. All
/// that judges goes through here: scenes, random cases, replay and the window.
class Judge {
public:
  /// parts: of the subject. place: orders violations. only: a property whose count is to be as that
  /// of all together, but without what takes time and cannot change it.
  Judge(Parts parts, std::uint64_t place, Tally& tally,
        std::optional<Property> only = std::nullopt);

  /// What does not take a tree.
  void subject(const Subject& subject) const;
  /// Nothing where it is no tree.
  [[nodiscard]] std::optional<Topology> tree(TreeClaim claim, const LightSet& lights) const;

  // A tree at a shading point.
  void clusters(const PointAnswers& of, NodeRange nodes) const;
  void clusters(const PointAnswers& of) const { clusters(of, {0, of.topology().size()}); }
  void cut(const PointAnswers& of, const CutConfig& config, const Cut& cut) const;
  void cuts(const PointAnswers& of, std::span<const CutConfig> configs) const;
  /// What compares cuts with each other, or answers with themselves.
  void point(const PointAnswers& of, const CutConfig& config) const;
  /// All lights of all clusters: without drawing many.
  void odds(const PointAnswers& of) const;
  /// Lights of the last clusters, which are small; and all, if they are not too many.
  void few_odds(const PointAnswers& of) const;
  void draws(const PointAnswers& of, const CutConfig& cut, const DrawConfig& config) const;

  /// Bounds per node, of all views of the case together; none where they are no block, or nobody
  /// asks.
  [[nodiscard]] std::vector<glm::vec3> block_bounds(const Judged& judged, const Topology& topology,
                                                    const Case& on) const;
  /// A point of a block.
  void block(const BlockAnswers& of) const;
  /// All points of the block that the case's views are, if they are one.
  void block(const Judged& judged, const Topology& topology, const LightSet& lights,
             const Case& on) const;

  // Shading and visibility.
  void light(const ShadingPoint& point, const Light& light) const;
  /// Reflectances do not matter.
  void lobe(const Lobe& lobe) const;
  void ray(const RayCase& of) const;
  /// What the subject proves of the points and each cluster of the scene's lights: every pair of a
  /// point and a light, or so many of them, drawn by the place, if they are more.
  void proofs(const Subject& subject, const SceneView& view, const LightTree& tree,
              std::span<const VisiblePoint> points, std::uint64_t most) const;
  /// A picture of the case's triangles, proofs for all that is seen at once, and rays from what is
  /// seen to all lights.
  void picture(const Subject& subject, const Case& on) const;

  /// What changes of the case must not matter.
  void invariance(const Subject& subject, const Case& on) const;
  /// What was built and asked before, where the case has that.
  void history(const Subject& subject, const Case& on) const;
  /// The case's shading points.
  void views(const Judged& judged, const Topology& topology, const LightSet& lights,
             const Case& on) const;

  /// Counts what the work throws as SubjectFailure as a violation; returns whether it did not.
  template <class Work>
  bool answers(Work&& work) const {
    std::string failure;
    try {
      work();
    } catch (const SubjectFailure& e) {
      failure = e.what();
    }
    record(Property::subject_answers)(failure.empty(), [&] { return failure; });
    return failure.empty();
  }

private:
  [[nodiscard]] bool has(Part part) const { return oracle::has(parts_, part); }
  [[nodiscard]] bool wants(Property property) const;
  [[nodiscard]] Recorder record(Property property) const {
    return {tally_[property], place_, severity_of(property, parts_)};
  }
  /// Whether any property is checked at such places.
  template <auto of>
  [[nodiscard]] bool any() const;
  /// Checks all that are.
  template <auto of, class... Place>
  void run(const Place&... place) const;

  Parts parts_;
  std::uint64_t place_;
  Tally& tally_;
  std::optional<Property> only_;
};

/// Judges the subject on the case: everything, or one property alone. What the subject cannot
/// answer counts as subject-answers. Throws InputError where the case is not valid.
void check_case(const Subject& subject, const Case& on, std::uint64_t place, Tally& tally,
                std::optional<Property> only = std::nullopt);

} // namespace lightcuts::oracle
