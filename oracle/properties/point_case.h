// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <oracle/properties/properties.h>
#include <oracle/subjects/subject.h>
#include <oracle/truth/truth.h>

namespace lightcuts::oracle {

/// A shading point with all that is true there.
struct PointCase {
  std::uint64_t place; ///< orders violations
  const ShadingPoint& point;
  std::span<const char> visible; ///< per light, whether it is seen
  const Truth& truth;            ///< evaluated for this point and visibility

  [[nodiscard]] const Topology& topology() const { return truth.topology(); }
  [[nodiscard]] const LightSet& lights() const { return truth.lights(); }
  [[nodiscard]] bool sees(std::uint32_t light) const {
    return light < visible.size() && visible[light] != 0;
  }
  /// "point (x, y, z)".
  [[nodiscard]] std::string text() const;
};

/// "(x, y, z)", of nine digits each.
[[nodiscard]] std::string digits_of(const glm::dvec3& v);

/// A subject's tree, and which parts of it can be judged.
struct Judged {
  SubjectTree& tree;
  Parts parts;

  [[nodiscard]] bool has(Part part) const { return oracle::has(parts, part); }
};

/// The subject's estimate of a cluster, occlusion included; a representative below the horizon
/// counts as seen, and so does one that the subject does not name.
[[nodiscard]] glm::dvec3 seen_estimate(const Judged& judged, std::uint32_t node,
                                       const PointCase& at, const glm::vec3& bound);
/// seen_estimate() given the subject's own bound.
[[nodiscard]] glm::dvec3 seen_estimate(const Judged& judged, std::uint32_t node,
                                       const PointCase& at);

/// What a subject's tree answers at a shading point; of all clusters, when first asked for.
class PointAnswers {
public:
  const Judged judged;
  const PointCase at;

  PointAnswers(const Judged& subject, const PointCase& point) : judged(subject), at(point) {}

  [[nodiscard]] const Topology& topology() const { return at.topology(); }
  /// Per node.
  [[nodiscard]] std::span<const glm::vec3> bounds() const;
  /// Per node, as seen_estimate() has it.
  [[nodiscard]] std::span<const glm::dvec3> estimates() const;
  /// The estimate of a cluster as if its representative were seen.
  [[nodiscard]] glm::dvec3 open_estimate(std::uint32_t node) const;
  /// A cut of what is seen from the point, or of all lights; valid until the tree's next one.
  [[nodiscard]] Cut select(const CutConfig& config, bool all_seen = false) const;

private:
  mutable std::vector<glm::vec3> bounds_;
  mutable std::vector<glm::dvec3> estimates_;
};

/// Makes a check of one cluster one of many, for PropertyInfo::of_clusters.
template <auto check>
void each_cluster(const PointAnswers& of, NodeRange nodes, const Recorder& record) {
  for (std::uint32_t i = nodes.begin; i < nodes.end; ++i) check(of, i, record);
}

} // namespace lightcuts::oracle
