// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {

/// One point of a block, and how the subject bounds all points of the block together.
struct BlockAnswers {
  const PointAnswers& point;
  std::span<const glm::vec3> bounds; ///< per node: SubjectTree::block_bounds()
  NodeRange nodes;                   ///< to be judged
};

} // namespace lightcuts::oracle
