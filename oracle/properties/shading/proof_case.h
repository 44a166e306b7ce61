// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/core/blocks/proven_visibility.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts::oracle {

/// A point of a group and a light of a cluster, all of whose lights are seen from all points of the
/// group, or none: so a subject says it has proven.
struct ProofCase {
  const SceneView& view;
  const VisiblePoint& from;
  std::uint32_t light;
  std::uint32_t node; ///< the cluster
  ProvenSight sight;  ///< not unknown
};

} // namespace lightcuts::oracle
