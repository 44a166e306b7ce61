// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <lightcuts/render/view/scene_view.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

/// Shadow rays compared with brute force, and those of them too near an edge for rounding to
/// decide.
struct RayCount {
  std::uint64_t rays = 0, undecided = 0;
};

/// A shadow ray from a visible point to a light.
struct RayCase {
  const Subject& subject;
  const SceneView& view;
  const VisiblePoint& from;
  std::uint32_t light;
  RayCount& count;
};

} // namespace lightcuts::oracle
