// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/render/scene/scene.h>

namespace lightcuts {

/// Whether all triangles, the lights and the eye lie on one side of every triangle's plane (points
/// within double rounding of it count for both sides; directional lights as points at infinity): a
/// convex room seen from within, where no
/// triangle can come between a point of the others and a light. From without, a shading normal that
/// differs from the face's would see lights through the wall. Quick to say no; says no for more
/// than 10^4 triangles.
[[nodiscard]] bool encloses_lights_convexly(const TriangleMesh& mesh, const LightSet& lights,
                                            const glm::vec3& eye);

} // namespace lightcuts
