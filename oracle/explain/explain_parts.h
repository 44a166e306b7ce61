// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include <oracle/properties/bounds/block_answers.h>

/// The parts of explain(), each of which shows nothing where the property is not about that, or
/// holds.
namespace lightcuts::oracle {

/// The first cluster at the point on which the property does not hold, step by step.
[[nodiscard]] std::string explain_cluster(const PointAnswers& of, Property property);

/// The first cluster on which the property of a block does not hold at one of its points: what the
/// bound is made of, of the point and of the block.
[[nodiscard]] std::string explain_block(const BlockAnswers& of,
                                        std::span<const ShadingPoint> points, Property property);

/// The first cut at the point on which the property does not hold, cluster by cluster.
[[nodiscard]] std::string explain_cut(const PointAnswers& of, Property property,
                                      const CutConfig& config);

/// The tree node by node, also where it is no tree at all.
[[nodiscard]] std::string explain_tree(const TreeClaim& claim, const LightSet& lights,
                                       Property property);

} // namespace lightcuts::oracle
