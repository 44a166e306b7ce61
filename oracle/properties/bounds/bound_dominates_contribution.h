// SPDX-License-Identifier: MIT
#pragma once

#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {

/// Checks bound-dominates-contribution for one cluster, without a Truth.
void check_bound(const Topology& topology, const LightSet& lights, const ShadingPoint& point,
                 std::uint32_t node, const glm::vec3& bound, const Recorder& record);

/// Checks whether what is called `name` is at least what the cluster's lights contribute to the
/// point if all are seen.
void check_dominates(const PointAnswers& of, std::uint32_t node, const glm::vec3& bound,
                     const char* name, const Recorder& record);

} // namespace lightcuts::oracle
