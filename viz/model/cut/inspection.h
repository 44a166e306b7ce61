// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <lightcuts/core/cut/cut_selector.h>

#include <viz/model/cut/cluster_row.h>
#include <viz/model/picture/frame.h>

namespace lightcuts::viz {

/// Which cut to look at.
struct InspectionKey {
  FrameKey frame;
  glm::uvec2 pixel{0};               ///< of a counterexample without meaning
  std::optional<std::uint32_t> step; ///< the cut as it was with so many clusters, >= 1;
                                     ///< nothing: the final one
  bool operator==(const InspectionKey&) const = default;
};

/// A pixel's shading point and its cut, cluster by cluster.
struct Inspection {
  bool sees_surface = false; ///< without a surface all below is empty
  glm::vec3 position{0}, normal{0}, to_viewer{0};
  Material material;
  glm::vec3 radiance{0}, certified_error{0}, emission{0};
  CutConfig config; ///< the cut's; of a step, max_size is that of the final cut
  CutEnd end = CutEnd::converged;
  std::uint32_t shadow_rays = 0;
  std::vector<ClusterRow> clusters;
  /// The pixels that went down the tree together with this one, itself among them; empty by
  /// methods that light each alone.
  std::vector<glm::uvec2> block;
  std::uint32_t final_size = 0; ///< clusters of the final cut
  /// The node that the next refinement replaces; nothing at the last step.
  std::optional<std::uint32_t> refined_next;
  std::optional<glm::dvec3> truth; ///< exact radiance, by the oracle; see add_truth()
  std::optional<std::size_t> clairvoyant;
};

/// How the cut came about: with so many clusters, its total, certified error and largest bound,
/// each summed over RGB.
struct RefinementCurve {
  std::vector<double> size, total, certified, largest_bound;
};

/// Picks the cut of a pixel, as the method of the key does; of the reference what lightcuts would
/// pick. Milliseconds. Of a counterexample, the cut of its subject at its shading point.
[[nodiscard]] Inspection inspect(const InspectionKey& key);

/// The sizes between 1 and the final one, at most `most` of them, and what the cut was like then.
/// Where it is cancelled, what was found until then is returned.
[[nodiscard]] RefinementCurve refinement_curve(const InspectionKey& key, std::size_t most,
                                               const Progress& progress);

/// Adds what is true of each cluster: looks at every light. Returns false where it was cancelled.
bool add_truth(const InspectionKey& key, Inspection& inspection, const Progress& progress);

/// A cluster of any node of the tree at the inspected point, in the cut or not; without truth.
[[nodiscard]] std::optional<ClusterRow> row_of(const InspectionKey& key, std::uint32_t node);

} // namespace lightcuts::viz
